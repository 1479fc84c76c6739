#include "contact/body/CoupledBody.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/body/BalancedStiffness.hpp"
#include "contact/body/Coupling.hpp"
#include "contact/body/ElasticBody.hpp"

#include <algorithm>

namespace epafi::contact {

using bem::dot;

namespace {

class Factored final : public HeldStiffness {
 public:
  explicit Factored(std::unique_ptr<const bem::CholeskyFactor> factor)
      : factor_(std::move(factor)) {}
  Vector solve(const Vector& force) const override { return factor_->solve(force); }
  Matrix forward(Matrix rows) const override { return factor_->forward(std::move(rows)); }

 private:
  std::unique_ptr<const bem::CholeskyFactor> factor_;
};

/// The forms that fit into a Coupling: those of [P], which insert the traction S u, the one
/// by the density, and no stabilisation.
class Coupled final : public StabilisedBody {
 public:
  Coupled(const bem::Space& space, const bem::SteklovPoincare& stiffness,
          Coupling coupling)
      : space_(space),
        stiffness_(stiffness),
        algebra_(stiffness.algebra()),
        coupling_(std::move(coupling)),
        balanced_(stiffness_, makeRigidModes(space), coupling_) {}

  // S - S^ = S - X Xᵀ.  One process takes a panel of X at a time, which saves its memory;
  // several would exchange the whole sum for every panel.
  Matrix stiffness() const {
    Matrix a = stiffness_.stiffness().unpacked();
    const Index columns = coupling_.stabilisationColumns();
    const Index width = algebra_.processes() == 1 ? 256 : std::max<Index>(1, columns);
    for (Index first = 0; first < columns; first += width)
      a = algebra_.addOuter(
          std::move(a),
          coupling_.stabilisationHalf(first, std::min(first + width, columns)), -1);
    return a;
  }

  std::shared_ptr<const HeldStiffness> held(const Holding& holding) const override {
    return std::make_shared<const Factored>(algebra_.cholesky(
        constrained(stiffness(), algebra_.myRows(coupling_.unknowns), holding),
        "the stiffness matrix"));
  }

  Vector residual(const Vector& force, const Vector& u) const override {
    return balanced_.residual(force, u);
  }
  Matrix coupling() const override { return coupling_.transposed(algebra_); }
  Vector push(const Vector& multiplier) const override {
    return coupling_.push(algebra_, multiplier);
  }
  Vector pull(const Vector& u) const override { return coupling_.pull(algebra_, u); }
  Matrix multiplierMass() const override { return coupling_.multiplierMass(); }
  double multiplierWork(const Vector& multiplier) const override {
    return coupling_.multiplierWork(multiplier);
  }
  Vector density(const Vector& u, const Vector& multiplier) const override {
    return byDensity() ? stiffness_.density(u, coupling_.weighted(multiplier))
                       : stiffness_.density(u);
  }

  // With w = N λ:  uᵀ A u - 2 uᵀ R w + wᵀ X w - ψᵀ G ψ, which has no differences of what
  // grows as ν -> 1/2 while γ is there.
  double strainEnergy(const Vector& u, const Vector& multiplier) const override {
    double twice = balanced_.stiffnessWork(u);
    if (!byDensity() && coupling_.compliance.pinned.empty())
      return 0.5 * twice;
    twice -= coupling_.complianceWork(density(u, multiplier));
    if (!byDensity())
      return 0.5 * twice;
    const Vector w = coupling_.weighted(multiplier);
    twice -= 2 * dot(u, algebra_.multiply(*coupling_.columns, coupling_.unknowns, w));
    return 0.5 * (twice + quadratic(coupling_.response->density, w));
  }

  bool byDensity() const override { return coupling_.response != nullptr; }

  bem::Vec2 meanSlack(std::size_t contactElement, const Vector& multiplier,
                      const Vector& density) const override {
    return coupling_.meanSlack(contactElement, multiplier, density);
  }

  double gamma(std::size_t contactElement) const override {
    return coupling_.gamma[contactElement];
  }
  Matrix subtracted() const override {
    return coupling_.stabilisationHalf(0, coupling_.stabilisationColumns());
  }
  std::unique_ptr<const StabilisedBody> weakened(double factor) const override {
    Coupling weaker = coupling_;
    weaker.weaken(factor);
    return std::make_unique<const Coupled>(space_, stiffness_, std::move(weaker));
  }

 private:
  const bem::Space& space_;
  const bem::SteklovPoincare& stiffness_;
  const bem::DenseAlgebra& algebra_;
  Coupling coupling_;
  BalancedStiffness balanced_;
};

}  // namespace

std::unique_ptr<const StabilisedBody> makeCoupledBody(const BodyInput& input,
                                                      const MultiplierSpace& multiplier) {
  return std::make_unique<const Coupled>(input.space, input.stiffness,
                                         makeCoupling(input, multiplier));
}

}  // namespace epafi::contact
