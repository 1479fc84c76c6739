#pragma once

#include "contact/body/Coupling.hpp"
#include "contact/body/Holding.hpp"
#include "contact/problem/Flexibility.hpp"

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

/// Springs under bonds of a body that bends so easily that its A has lost the digits of bending, as a
/// coating does which is 1e3 times as long as thick, and more.  A factor of A + Bᵀ K B stands for A,
///
///   (A + Bᵀ K B) u = f - Bᵀ λ + Bᵀ K w,     K = diag(k) less what it does to rigid motions,
///
/// where w, the feet, is what the bond would have B u be: then the springs carry nothing, and u is that
/// of A.  D is made without the feet; the correction of defects finds what that leaves.
///                                                 [doc/theory/contact.md, Thin bonded bodies]
struct Bedding {
  std::vector<Index> rows{};  ///< bonded coefficients; none: no bedding
  Vector stiffness{};         ///< k, one each, of r
  std::size_t holder = 0;     ///< the body that it stands on; the own one: no body
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
  const Bedding& bedding() const { return bedding_; }
  /// Bᵀ K x, x in all coefficients, of which those of the bedding count.
  virtual Vector beddingForce(const Vector& x) const = 0;

  /// Is A formed?  Else solve() is refined by its own product.
  virtual bool isFormed() const = 0;

  /// A⁺ f, A with its bedding, the displacement under f without allowed rigid motions, zero on clamped unknowns, where
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

  /// D by Coupling::columns, at least its lower triangle, with the body's part added to that of the
  /// bodies before.
  /// \param motions  r_k: B r of the motions that clamps allow  \param reactions  s_k of those that
  ///   Fix holds, see ContactSystem
  virtual Matrix addCompliance(Matrix d, const std::vector<Vector>& motions,
                               const std::vector<Vector>& reactions) const = 0;

  /// Rᵀ u, R w and, with densities, X w.
  virtual Vector tractionsOf(const Vector& u) const = 0;
  virtual Vector forcesOf(const Vector& w) const = 0;
  virtual Vector responsesTo(const Vector& w) const = 0;
  /// (V + G)⁻¹ g, and K' of it.
  virtual std::pair<Vector, Vector> answerTo(const Vector& g) const = 0;

 protected:
  ElasticBody(const bem::Space& space, std::shared_ptr<const Holding> holding,
              Coupling coupling, Bedding bedding = {})
      : space_(space),
        holding_(std::move(holding)),
        coupling_(std::move(coupling)),
        bedding_(std::move(bedding)) {}

  const bem::Space& space_;
  std::shared_ptr<const Holding> holding_;
  Coupling coupling_;
  Bedding bedding_;
};

/// D of bodies as the sum of what each adds, see BodyFlexibility, where many meet few others; else as
/// one matrix.  \param motions, reactions  of each, see ElasticBody::addCompliance
Flexibility flexibilityOf(const std::vector<std::shared_ptr<const ElasticBody>>& bodies,
                          const std::vector<std::vector<Vector>>& motions,
                          const std::vector<std::vector<Vector>>& reactions);

inline Vector ElasticBody::Image::residual(const Vector& force) const {
  Vector rest(force.size());
  for (std::size_t i = 0; i < rest.size(); ++i)
    rest[i] = static_cast<double>(force[i] - forces[i]);
  return rest;
}

}  // namespace epafi::contact
