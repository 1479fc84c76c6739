#pragma once

#include "contact/compressed/CompressedBody.hpp"
#include "contact/problem/Flexibility.hpp"

#include <memory>
#include <vector>

namespace epafi::contact {

/// Compliance matrix D = Ĉ A⁺ Ĉᵀ + M by solutions in the cluster tree, A of all its bodies.
class CompressedFlexibility final : public Flexibility::Operator {
 public:
  /// \param normals number of pressures, the first coefficients
  /// \param reactions  of each body, w_k of the first motions; D has G wᵀ + w Gᵀ of them less
  /// \param columns  the coefficients that act on the bodies, ascending, which are all that D has;
  ///   empty: all.  factor() asks for all.
  CompressedFlexibility(std::vector<std::shared_ptr<const CompressedBody>> bodies,
                        Index normals, const std::vector<std::vector<Vector>>& reactions,
                        const std::vector<Index>& columns = {});

  Index size() const override {
    return static_cast<Index>(coupling_.front().rests.size());
  }
  Vector times(const Vector& x) const override;
  /// |D| |x| is bounded by row sums times the largest coefficient, for each kind.
  Product product(const Vector& x) const override;
  std::unique_ptr<Factor> factor(System system) const override;
  Matrix formed() const override;
  void release() const override;

 private:
  /// Factor of a linear system in some coefficients of D.
  class Reduced;

  const bem::CompressedOperators& operators() const {
    return bodies_.front()->operators();
  }
  /// x += s Ĉᵀ λ on displacements and densities.
  void addTranspose(double s, const double* multiplier, double* x) const;
  /// Ĉ x
  Vector apply(const double* x) const;

  /// A factor, and its CompressedFactor::activePaths of the leaves coupled to the multiplier.
  struct Along {
    bem::CompressedFactor factor;
    std::vector<char> paths;

    Matrix solve(const Matrix& b) const { return factor.solveAlong(paths, b); }
  };
  /// Of a system in some of the coefficients.  Only the last requested system is stored;
  /// a request for another one eliminates it again.
  /// \throws bem::NumericalError
  const Along& eliminated(int number, const bem::Restriction& restriction) const;

  int kindOf(Index i) const { return i < normals_ ? 0 : 1; }
  void takeCoupling(const std::vector<Index>& columns);
  void restrictAll();
  Along along(const bem::CompressedFactor& factor) const;
  void addMotions(const std::vector<std::vector<Vector>>& reactions,
                  const std::vector<Index>& columns);
  void measureRows() const;
  Matrix timesColumns(const Matrix& x) const;

  std::vector<std::shared_ptr<const CompressedBody>> bodies_;
  Index normals_;
  std::vector<TraceCoupling> coupling_;  ///< Ĉ = [B₀, -Nᵀ] of each body, with densities
  std::vector<bem::Entry> mass_;
  std::vector<int> leaves_;       ///< coupled to the multiplier
  bem::Restriction restriction_;  ///< of all bodies with all multipliers held
  std::vector<Along> own_;        ///< of each body
  /// Low-rank difference of D and D_M, which has springs on rigid motions R with functionals c:
  /// D = D_M - G wᵀ - w Gᵀ + G κ Gᵀ,  w = Ĉ M⁻¹ c, with that of reactions,  κ = cᵀ M⁻¹ c,  G = Ĉ R.
  bem::LowRank motions_;
  mutable Matrix rowSums_;  ///< over each kind, computed on first use
  // Kept between steps, so that only changed leaves and their ancestors are eliminated again.
  mutable std::unique_ptr<Along> reduced_;
  mutable int eliminated_ = 0;  ///< the number of its system; 0: of none
  mutable int numbers_ = 0;     ///< given to systems
};

}  // namespace epafi::contact
