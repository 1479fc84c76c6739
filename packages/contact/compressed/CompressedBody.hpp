#pragma once

#include "bem/compressed/CompressedFactor.hpp"
#include "contact/body/ElasticBody.hpp"

namespace epafi::contact {

/// One of the bodies of compressed operators, which share a tree or have one of their own.  Springs on free or fixed rigid motions make its
/// system regular; solve() removes their effect.
class CompressedBody final : public ElasticBody,
                             public std::enable_shared_from_this<CompressedBody> {
 public:
  /// \pre input.stiffness is of makeCompressedStiffness
  CompressedBody(const BodyInput& input, const MultiplierSpace& multiplier,
                 std::size_t body, std::shared_ptr<const Holding> holding,
                 Coupling plain);

  Vector solve(const Vector& force) const override;
  /// It has no bedding.
  Vector beddingForce(const Vector& /*x*/) const override { return {}; }
  bool isFormed() const override { return false; }
  Image imageOf(const Vector& u) const override;
  Vector density(const Vector& u, const Vector& w) const override;
  Vector tractionsOf(const Vector& u) const override;
  Vector forcesOf(const Vector& w) const override { return onDensities(w).force; }
  /// \pre it has a tree of its own
  Matrix addCompliance(Matrix d, const std::vector<Vector>& motions,
                       const std::vector<Vector>& reactions) const override;
  Vector responsesTo(const Vector& w) const override;
  std::pair<Vector, Vector> answerTo(const Vector& g) const override;

  const bem::Space& space() const { return space_; }
  const bem::CompressedOperators& operators() const { return *operators_; }
  /// The held unknowns and springs of the body, all multipliers and all others held.
  const bem::Restriction& restriction() const { return restriction_; }
  /// Factor of M, the matrix of the body with springs.
  const bem::CompressedFactor& factor() const { return *factor_; }
  /// R and c, rigid motions that clamps do not hold and their functionals, by all unknowns.
  Matrix motions() const { return placed(holding_->allowed); }
  Matrix functionals() const { return placed(holding_->functionals); }

 private:
  void addSprings();
  /// Displacements (columns), or a density, among all unknowns.
  Matrix placed(const Matrix& displacements) const;
  Matrix placed(const Vector& density) const;
  /// The displacements' rows of a column.
  Vector forcesIn(const Matrix& image) const;

  /// Of V + G: all displacements and multipliers held.
  const bem::CompressedFactor& densityFactor() const;
  /// The densities' rows solved, all else held: -(V + G)⁻¹ of them.
  Vector densityFor(const Matrix& right, int refinements) const;
  /// ψ = (V + G)⁻¹ E w and K' ψ; the last one is kept.
  struct OnDensities {
    Vector w;
    Vector psi;
    Vector force;
  };
  const OnDensities& onDensities(const Vector& w) const;

  /// A displacement, its ψ without a multiplier, Z (u, 0) and Z (0, ψ); the last one is kept,
  /// which several results ask for.
  struct Field {
    Vector u;
    Vector psi;
    Matrix images;
  };
  const Field& fieldOf(const Vector& u) const;
  /// K u - (V + G) ψ from the images of both, and its largest entry over that of K u.
  struct Rest {
    Vector entries;
    double size = 0;
  };
  Rest restOf(const Matrix& images) const;
  /// What rigid motions r leave in compressed operators, Z (r, 0) in the densities' rows, its Gram
  /// matrix factored, the ψ that takes it away, and Z (0, ψ).  No columns: nothing.
  struct LeftOfMotions {
    Matrix left;
    Matrix factor;
    Matrix psi;
    Matrix images;
  };
  const LeftOfMotions& leftOfMotions() const;
  /// Takes off the rest what rigid motions have added to it.
  void takeMotions(const Rest& rest, Vector& psi, Matrix& images) const;

  std::shared_ptr<const bem::CompressedOperators> operators_;
  const bem::CompressedOperators::Range& range_;
  bem::Restriction restriction_;
  std::unique_ptr<const bem::CompressedFactor> factor_;
  mutable std::unique_ptr<const bem::CompressedFactor> densityFactor_;
  mutable std::unique_ptr<const LeftOfMotions> leftOfMotions_;
  mutable Vector solved_;  ///< ψ of the last solution
  mutable Field field_;
  mutable OnDensities onDensities_;
};

}  // namespace epafi::contact
