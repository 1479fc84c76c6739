#include "contact/problem/ContactProblem.hpp"

#include "bem/algebra/Blas.hpp"
#include "contact/problem/ElasticBody.hpp"
#include "contact/problem/Obstacle.hpp"

#include <algorithm>
#include <limits>

namespace epafi::contact {

namespace {

double largestEigenvalue(Matrix symmetric) {
  const int n = static_cast<int>(symmetric.rows());
  const int ld = static_cast<int>(symmetric.stride());
  Vector values(static_cast<std::size_t>(n));
  Vector work(static_cast<std::size_t>(std::max(1, 34 * n)));
  const int size = static_cast<int>(work.size());
  int info = 0;
  dsyev_("N", "L", &n, symmetric.data(), &ld, values.data(), work.data(), &size, &info);
  return info == 0 && n > 0 ? values.back() : 0;
}

/// See limitGamma0; the form has the first choice of γ₀.
double limit(const ContactProblem::Input& input, const StabilisedBody& form,
             const Holding& holding) {
  const bem::DenseAlgebra& algebra = input.stiffness.algebra();
  const bem::Rows mine = algebra.myRows(input.space.displacements());
  Matrix half = form.subtracted();
  const Index columns = half.columns();
  if (columns == 0)
    return std::numeric_limits<double>::infinity();
  for (Index j = 0; j < columns; ++j)
    for (Index i = 0; i < half.rows(); ++i)
      if (holding.loads.clamped[static_cast<std::size_t>(i + mine.begin)] != 0)
        half(i, j) = 0;
  const auto stiffness = algebra.cholesky(
      constrained(input.stiffness.stiffness().unpacked(), mine, holding), "S");
  const Matrix reduced = stiffness->forward(std::move(half));
  const Matrix gram = algebra.replicate(
      algebra.addGram(Matrix(algebra.myRows(columns).size(), columns), reduced), columns);
  const double largest = largestEigenvalue(gram.copy());
  return algebra.broadcast({input.stabilization.firstGamma0() / largest}).front();
}

}  // namespace

IndefiniteStiffness::IndefiniteStiffness(double used, double limit)
    : bem::NumericalError(
          bem::message("the stabilised stiffness S - S^ is not positive definite: "
                       "Discretization->Stabilization->",
                       "Gamma0 = ", used, " is too large for this mesh; below ", limit,
                       " it is definite, and a quarter of that is safe")),
      gamma0(used),
      limitGamma0(limit) {}

double limitGamma0(const ContactProblem::Input& input) {
  const MultiplierSpace multiplier(input.space.mesh(), input.basis, input.conditions);
  return limit(input, *makeStabilisedBody(input, multiplier),
               makeHolding(input.space, input.conditions, input.units));
}

struct ContactProblem::Parts {
  Holding holding;
  MultiplierSpace multiplier;
  std::unique_ptr<const StabilisedBody> form;
  double gamma0 = 0;
  std::unique_ptr<const ElasticBody> body{};
  Vector gap{};
  Problem numbers{};

  bool isStabilised(const Input& input) const {
    return input.stabilization.form != Stabilization::Form::None &&
           !multiplier.elements().empty();
  }

  /// Factors A, with a smaller γ₀ where the default is too large.
  /// \throws IndefiniteStiffness if it is not the default that is.
  void makeBody(const Input& input) {
    const bem::DenseAlgebra& algebra = input.stiffness.algebra();
    const double first = input.stabilization.firstGamma0();
    gamma0 = isStabilised(input) ? first : 0;
    try {
      body = std::make_unique<const ElasticBody>(*form, algebra, holding);
      return;
    } catch (const bem::NumericalError&) {
      if (form->subtracted().columns() == 0)
        throw;
    }
    const double definiteBelow = limit(input, *form, holding);
    if (input.stabilization.gamma0)
      throw IndefiniteStiffness(first, definiteBelow);
    gamma0 = std::min(first, definiteBelow) / 4;
    form = form->weakened(gamma0 / first);
    body = std::make_unique<const ElasticBody>(*form, algebra, holding);
  }

  Vector push(const State& state) const {
    return state.multiplier.empty() ? Vector(holding.loads.load.size(), 0.0)
                                    : form->push(state.multiplier);
  }
};

ContactProblem::ContactProblem(const Input& input) {
  MultiplierSpace multiplier(input.space.mesh(), input.basis, input.conditions);
  auto form = makeStabilisedBody(input, multiplier);
  parts_ = std::make_unique<Parts>(
      Parts{makeHolding(input.space, input.conditions, input.units),
            std::move(multiplier), std::move(form)});
  Parts& parts = *parts_;
  parts.makeBody(input);
  std::vector<ElasticBody::Response> responses;
  responses.push_back(parts.body->response(parts.form->coupling()));
  Problem& problem = parts.numbers;
  problem = condense(input.stiffness.algebra(), parts.form->multiplierMass(), responses);

  const DistantObstacle opposite(input.space.mesh(), input.units.length);
  Obstacle obstacle =
      makeObstacle(input.space.mesh(), parts.multiplier, opposite, input.units);
  parts.gap = std::move(obstacle.gap);
  for (std::size_t i = 0; i < parts.gap.size(); ++i)
    problem.offset[i] -= parts.gap[i];
  problem.normals = parts.multiplier.normals();
  problem.tangentials = std::move(obstacle.tangentials);
  // dimensionless: strains and stresses are of one size
  const double size = parts.holding.loads.largestTraction +
                      parts.holding.loads.largestDisplacement +
                      obstacle.largestPenetration;
  problem.stress = size > 0 ? size : 1;
}

ContactProblem::~ContactProblem() = default;
ContactProblem::ContactProblem(ContactProblem&&) noexcept = default;

const Problem& ContactProblem::numbers() const { return parts_->numbers; }
const MultiplierSpace& ContactProblem::multiplier() const { return parts_->multiplier; }
const Vector& ContactProblem::gap() const { return parts_->gap; }
const Vector& ContactProblem::load() const { return parts_->holding.loads.load; }
double ContactProblem::gamma0() const { return parts_->gamma0; }
double ContactProblem::gamma(std::size_t contactElement) const {
  return parts_->form->gamma(contactElement);
}

Vector ContactProblem::displacement(const State& state) const {
  const Vector still(static_cast<std::size_t>(parts_->body->freeMotions()), 0.0);
  return parts_->body->displacement(
      parts_->push(state), state.rigid.empty() ? still.data() : state.rigid.data());
}

bool ContactProblem::byDensity() const { return parts_->form->byDensity(); }

bem::Vec2 ContactProblem::meanSlack(std::size_t contactElement, const State& state,
                                    const Vector& density) const {
  return parts_->form->meanSlack(contactElement, state.multiplier, density);
}

double ContactProblem::strainEnergy(const State& state,
                                    const Vector& displacement) const {
  return parts_->form->strainEnergy(displacement, state.multiplier);
}

Vector ContactProblem::density(const State& state, const Vector& displacement) const {
  return parts_->form->density(displacement, state.multiplier);
}

Vector ContactProblem::clampWork(const State& state, const Vector& displacement) const {
  return parts_->body->clampWork(parts_->push(state), displacement);
}

Vector ContactProblem::fixedReactions(const State& state) const {
  return parts_->body->fixedReactions(parts_->push(state));
}

}  // namespace epafi::contact
