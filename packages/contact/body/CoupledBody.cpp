#include "contact/body/CoupledBody.hpp"

#include "bem/algebra/DenseAlgebra.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/body/BalancedStiffness.hpp"
#include "contact/body/ElasticBody.hpp"
#include "contact/body/ElementCoupling.hpp"

#include <algorithm>

namespace epafi::contact {

using bem::dot;

namespace {

std::vector<Index> unclamped(const Loads& loads) {
  std::vector<Index> free;
  for (std::size_t i = 0; i < loads.clamped.size(); ++i)
    if (loads.clamped[i] == 0)
      free.push_back(static_cast<Index>(i));
  return free;
}

/// Rows and columns of some, ascending.
Matrix unpackedAt(const std::vector<Index>& which, const bem::LowerTriangle& lower) {
  const auto count = static_cast<Index>(which.size());
  Matrix result(count, count);
  for (Index j = 0; j < count; ++j) {
    const double* column = lower.column(which[j]) - which[j];
    for (Index i = j; i < count; ++i)
      result(i, j) = column[which[i]];
  }
  return result;
}

/// Some rows, ascending.
Matrix rowsAt(const std::vector<Index>& which, Matrix a) {
  if (bem::at(a.rows()) == which.size())
    return a;
  Matrix rows(static_cast<Index>(which.size()), a.columns());
  for (Index j = 0; j < a.columns(); ++j)
    for (Index i = 0; i < rows.rows(); ++i)
      rows(i, j) = a(which[i], j);
  return rows;
}

class Factored final : public HeldStiffness {
 public:
  /// Of the displacements at `free` alone.
  Factored(Matrix lower, std::vector<Index> free)
      : factor_(factorOf(std::move(lower))), free_(std::move(free)) {}

  Vector solve(const Vector& force) const override {
    Vector u;
    for (const Index i : free_)
      u.push_back(force[i]);
    const Vector solved = factor_.solve(u);
    u.assign(force.size(), 0.0);
    for (std::size_t k = 0; k < solved.size(); ++k)
      u[free_[k]] = solved[k];
    return u;
  }
  Matrix forward(Matrix rows) const override {
    return factor_.forward(rowsAt(free_, std::move(rows)));
  }

 private:
  static bem::CholeskyFactor factorOf(Matrix lower) try {
    return bem::CholeskyFactor(std::move(lower), "the stiffness matrix");
  } catch (const bem::NumericalError& error) {
    throw bem::NumericalError(
        error.what(),
        "; rounding has taken its digits, as it does in bodies slender by more than "
        "1 : 1000: look at the outline");
  }

  bem::CholeskyFactor factor_;
  std::vector<Index> free_;
};

/// The forms that fit into a Coupling: those of [P], which insert the traction S u, the one
/// by the density, and no stabilisation.
class Coupled final : public StabilisedBody {
 public:
  Coupled(const bem::Space& space, const bem::SteklovPoincare& stiffness,
          Coupling coupling)
      : StabilisedBody(std::move(coupling)),
        space_(space),
        stiffness_(stiffness),
        balanced_(stiffness_, makeRigidModes(space), coupling_) {}

  std::shared_ptr<const HeldStiffness> held(const Holding& holding) const override {
    std::vector<Index> free = unclamped(holding.loads);
    Matrix a = addOuter(subtract(unpackedAt(free, stiffness_.stiffness()), free),
                        rowsAt(free, holding.rigid.functionals.copy()), 1);
    return std::make_shared<const Factored>(std::move(a), std::move(free));
  }

  Vector residual(const Vector& force, const Vector& u) const override {
    return balanced_.residual(force, u);
  }
  Matrix coupling() const override { return coupling_.transposed(); }
  Vector push(const Vector& multiplier) const override {
    return coupling_.push(multiplier);
  }
  Vector pull(const Vector& u) const override { return coupling_.pull(u); }
  Vector contactTerms(const Vector& u, const Vector& multiplier) const override {
    Vector terms = pull(u);
    bem::axpy(-1, coupling_.massTimes(multiplier), terms);
    return terms;
  }
  double multiplierWork(const Vector& multiplier) const override {
    return coupling_.multiplierWork(multiplier);
  }
  Vector density(const Vector& u, const Vector& multiplier) const override {
    return byDensity() ? stiffness_.density(u, coupling_.weighted(multiplier))
                       : stiffness_.density(u);
  }

  // With w = N λ:  uᵀ A u - 2 uᵀ R w + wᵀ X w - ψᵀ G ψ, which has no differences of what
  // grows as ν -> 1/2 while γ is there.
  // What acts inside adds g to w in all places, ψ_p = -(V + G)⁻¹ g.
  double strainEnergy(const Vector& u, const Vector& multiplier,
                      const ResidualTerms& terms) const override {
    double twice = balanced_.stiffnessWork(u);
    if (!byDensity() && coupling_.compliance.pinned.empty())
      return 0.5 * twice;
    const Vector& ofInside = terms.density;
    Vector psi = density(u, multiplier);
    if (!ofInside.empty()) {
      bem::axpy(1, ofInside, psi);
      twice -= 2 * dot(u, terms.force) + dot(terms.compliance, ofInside);
    }
    twice -= coupling_.complianceWork(psi);
    if (!byDensity())
      return 0.5 * twice;
    const Vector w = coupling_.weighted(multiplier);
    for (std::size_t k = 0; k < w.size() && !ofInside.empty(); ++k)
      twice -= 2 * w[k] * ofInside[at(coupling_.compliance.densities[k])];
    twice -= 2 * dot(u, multiply(*coupling_.columns, w));
    return 0.5 * (twice + quadratic(coupling_.response->density, w));
  }

  ResidualTerms residualTerms(const MultiplierSpace& multiplier) const override {
    const Inside& inside = multiplier.conditions().inside;
    if (!inside)
      return {};
    const TractionMoments moments =
        tractionMoments(space_, multiplier, byDensity(), coupling_, *inside);
    ResidualTerms terms;
    terms.terms.assign(moments.multipliers.size(), 0.0);
    bem::axpy(-1, moments.multipliers, terms.terms);
    if (!byDensity() && coupling_.compliance.pinned.empty()) {
      if (coupling_.columns->columns() > 0)
        terms.force = multiply(*coupling_.columns, moments.weights);
      return terms;
    }
    terms.compliance = coupling_.complianceOf(space_, moments.weights, *inside);
    terms.density = stiffness_.densityOf(terms.compliance);
    for (double& x : terms.density)
      x = -x;
    coupling_.subtractWeighted(terms.density, terms.terms);
    terms.force = columnOf(stiffness_.addAdjointDensity(Matrix(space_.displacements(), 1),
                                                        bem::asColumn(terms.compliance)),
                           0);
    return terms;
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
  // S - S^ = S - X Xᵀ, a panel of X at a time, which saves memory
  Matrix subtract(Matrix a, const std::vector<Index>& free) const {
    constexpr Index width = 256;
    const Index columns = coupling_.stabilisationColumns();
    for (Index first = 0; first < columns; first += width) {
      Matrix half = coupling_.stabilisationHalf(first, std::min(first + width, columns));
      a = addOuter(std::move(a), rowsAt(free, std::move(half)), -1);
    }
    return a;
  }

  const bem::Space& space_;
  const bem::SteklovPoincare& stiffness_;
  BalancedStiffness balanced_;
};

}  // namespace

std::unique_ptr<const StabilisedBody> makeCoupledBody(const BodyInput& input,
                                                      const MultiplierSpace& multiplier) {
  return std::make_unique<const Coupled>(input.space, input.stiffness,
                                         makeCoupling(input, multiplier));
}

}  // namespace epafi::contact
