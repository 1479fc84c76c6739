#pragma once

#include "contact/body/Coupling.hpp"
#include "contact/body/Holding.hpp"

#include <memory>
#include <utility>

namespace epafi::contact {

/// Data of a body and of the multiplier on it.
struct BodyInput {
  const bem::Space& space;                ///< must outlive the problem
  const bem::SteklovPoincare& stiffness;  ///< must outlive the problem
  const bem::Lame& lame;
  bem::Units units;
  const Conditions& conditions;  ///< must outlive the problem
  const MultiplierBasis& basis;
  Stabilization stabilization;
  /// With compressed operators, the largest number of multiplier coefficients of all bodies for
  /// which D is formed, since this is then cheaper than eliminations in the tree.
  Index formedUpTo = 1000;
};

/// The operators of an elastic body in the discrete equations of a contact problem,
///
///   A u + Bᵀ λ = f,   B u - M λ - g in the conditions      [doc/theory/contact.md, In numbers]
///
/// A factored under the Dirichlet conditions of the body, and R and X, see Coupling, of which B
/// and M consist.  Dense S: DenseBody, all forms of the stabilisation; compressed S:
/// CompressedBody, those that do not evaluate S u.
class ElasticBody {
 public:
  virtual ~ElasticBody() = default;

  const Coupling& coupling() const { return coupling_; }
  const Holding& holding() const { return *holding_; }
  /// Is A formed?  Else solve() is refined by its own product.
  virtual bool isFormed() const = 0;

  /// A⁺ f, the displacement under f without allowed rigid motions, zero on clamped unknowns, where
  /// f does not matter.
  virtual Vector solve(const Vector& force) const = 0;
  /// What a displacement takes: A u with the digits that differences from forces need, and uᵀ S u.
  struct Image {
    std::vector<long double> forces;
    double work = 0;

    /// f - A u
    Vector residual(const Vector& force) const;
  };
  virtual Image imageOf(const Vector& u) const = 0;
  /// f - A u
  Vector residual(const Vector& force, const Vector& u) const {
    return imageOf(u).residual(force);
  }
  /// ψ of a displacement and of what a multiplier puts on the densities: (V + G)⁻¹ (K u - E w).
  virtual Vector density(const Vector& u, const Vector& w) const = 0;

  /// Rᵀ u, R w and, with densities, X w.
  virtual Vector tractionsOf(const Vector& u) const = 0;
  virtual Vector forcesOf(const Vector& w) const = 0;
  virtual Vector responsesTo(const Vector& w) const = 0;
  /// (V + G)⁻¹ g, and K' of it.
  virtual std::pair<Vector, Vector> answerTo(const Vector& g) const = 0;

 protected:
  ElasticBody(const bem::Space& space, std::shared_ptr<const Holding> holding,
              Coupling coupling)
      : space_(space), holding_(std::move(holding)), coupling_(std::move(coupling)) {}

  const bem::Space& space_;
  std::shared_ptr<const Holding> holding_;
  Coupling coupling_;
};

inline Vector ElasticBody::Image::residual(const Vector& force) const {
  Vector rest(force.size());
  for (std::size_t i = 0; i < rest.size(); ++i)
    rest[i] = static_cast<double>(force[i] - forces[i]);
  return rest;
}

}  // namespace epafi::contact
