#pragma once

#include "bem/tractions/TractionRows.hpp"
#include "contact/body/ElasticBody.hpp"

namespace epafi::contact {

/// The stabilised stiffness A = S - S^ is not positive definite with the γ₀ that was given.
struct IndefiniteStiffness : bem::NumericalError {
  IndefiniteStiffness(double used, double limit);
  double gamma0;       ///< what was asked for
  double limitGamma0;  ///< A is definite below
};

/// A body with dense S.  Rounding errors of A do not affect the balance of forces:
///
///   A = Pᵀ (S - S^) P,   P u = u - Σ_k r_k <u, r_k> / <r_k, r_k>,  <.,.>: L2(boundary)
///
/// In exact arithmetic rigid motions r are in the kernels of S and S^, and P changes nothing.
/// The computed S satisfies this up to ε |S| only, an error of ε |S| |u| in the forces: 1e-10
/// of the load for a beam of 1:100 (u is 5000 times the load) or for nu = 0.4999999 (|S| is
/// 5e6 times Young's modulus).  For the same reason sums are computed with twice the digits
/// of a double.
class DenseBody final : public ElasticBody {
 public:
  using Tractions = std::shared_ptr<const bem::TractionRows>;

  /// \param tractions S φ; null: no S^  \throws bem::NumericalError if A is not definite
  DenseBody(const BodyInput& input, std::shared_ptr<const Holding> holding,
            Coupling coupling, Tractions tractions, Bedding bedding = {});

  /// L⁻¹ Cᵀ with the factor L of A, clamped rows ignored.
  Matrix forward(Matrix rows) const;
  /// By d + M + (L⁻¹ Bᵀ)ᵀ L⁻¹ Bᵀ - Σ_k r_k (½ r_k + s_k)ᵀ + (½ r_k + s_k) r_kᵀ, the lower triangle.
  Matrix addCompliance(Matrix d, const std::vector<Vector>& motions,
                       const std::vector<Vector>& reactions) const override;
  Vector beddingForce(const Vector& x) const override;
  bool isFormed() const override { return true; }
  Vector solve(const Vector& force) const override;
  /// The rounding error of the work is relative to it, neither to large entries of S as nu -> 1/2 nor
  /// to a rigid motion in u.
  Image imageOf(const Vector& u) const override;
  Vector density(const Vector& u, const Vector& w) const override;
  Vector tractionsOf(const Vector& u) const override;
  Vector forcesOf(const Vector& w) const override;
  Vector responsesTo(const Vector& w) const override;
  std::pair<Vector, Vector> answerTo(const Vector& g) const override;

 private:
  using Extended = std::vector<long double>;

  bem::CholeskyFactor factored() const;
  Matrix makeSprings() const;
  /// Columns of Bᵀ, and M, by places of coefficients.
  Matrix transposedCoupling(const std::vector<Index>& places, Index count) const;
  void addMultiplierMass(const std::vector<Index>& places, Matrix& d) const;
  Matrix subtractStabilisation(Matrix a) const;
  void subtractStabilisation(const Extended& u, Extended& forces) const;
  Extended withoutMotions(const Vector& u) const;
  Extended balanced(Extended forces) const;
  Extended stiffnessTimes(const Extended& u) const;

  const bem::SteklovPoincare& stiffness_;
  std::shared_ptr<const bem::ComplianceResponse> response_;  ///< Density; else null
  Tractions tractions_;
  const Matrix* columns_;    ///< R
  Vector squares_;           ///< <r, r> of the modes r
  std::vector<Index> free_;  ///< displacements that are not clamped
  Matrix springs_;           ///< Bᵀ K^½ of the bedding
  bem::CholeskyFactor
      factor_;  ///< of A + Bᵀ K B + Σ c cᵀ there, c: functionals of allowed motions
};

/// All forms of the stabilisation.  γ₀ becomes smaller if the default is too large.
/// \pre input.stiffness is formed  \throws IndefiniteStiffness if a given γ₀ is too large
std::shared_ptr<const DenseBody> makeDenseBody(
    const BodyInput& input, const MultiplierSpace& multiplier, std::size_t body,
    const std::shared_ptr<const Holding>& holding, const Coupling& plain,
    const Bedding& bedding = {});

/// γ₀ at which A loses its definiteness: 1 / the largest eigenvalue of (S^/γ₀, S).  Infinite without
/// S^.  Relative to S, the smallest eigenvalue of A is 1 - γ₀ / limitGamma0.      [P Lemma 6]
double limitGamma0(const BodyInput& input);

}  // namespace epafi::contact
