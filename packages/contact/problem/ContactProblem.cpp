#include "contact/problem/ContactProblem.hpp"

#include "bem/algebra/Blas.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/problem/BodyParts.hpp"
#include "contact/problem/CompressedBody.hpp"

#include <algorithm>
#include <limits>

namespace epafi::contact {

using bem::axpy;

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

ContactProblem::Parts::Parts(const Input& input)
    : space(input.space),
      units(input.units),
      holding(makeHolding(space, input.conditions, units)),
      multiplier(input.space.mesh(), input.basis, input.conditions),
      opposite(input.opposite ? input.opposite
                              : std::make_shared<const DistantObstacle>(
                                    input.space.mesh(), input.units.length)),
      form(makeStabilisedBody(input, multiplier)),
      algebra(input.stiffness.algebra()),
      obstacle(makeObstacle(input.space.mesh(), multiplier, *opposite, input.units)) {
  factor(input);
  numbers.normals = multiplier.normals();
  numbers.tangentials = obstacle.tangentials;
}

double ContactProblem::Parts::size() const {
  // dimensionless: strains and stresses are of one size
  return holding.loads.largestTraction + holding.loads.largestDisplacement +
         obstacle.largestPenetration;
}

void ContactProblem::Parts::factor(const Input& input) {
  const double first = input.stabilization.firstGamma0();
  const bool stabilised = input.stabilization.form != Stabilization::Form::None &&
                          !multiplier.elements().empty();
  gamma0 = stabilised ? first : 0;
  try {
    body = std::make_unique<const ElasticBody>(*form, algebra, holding);
    return;
  } catch (const bem::NumericalError&) {
    if (input.stiffness.compressed() != nullptr || form->subtracted().columns() == 0)
      throw;
  }
  const double definiteBelow = limit(input, *form, holding);
  if (input.stabilization.gamma0)
    throw IndefiniteStiffness(first, definiteBelow);
  gamma0 = std::min(first, definiteBelow) / 4;
  form = form->weakened(gamma0 / first);
  body = std::make_unique<const ElasticBody>(*form, algebra, holding);
}

Vector ContactProblem::Parts::push(const State& state, const Vector& met) const {
  Vector force = state.multiplier.empty() ? Vector(holding.loads.load.size(), 0.0)
                                          : form->push(state.multiplier);
  if (!met.empty())
    axpy(1, met, force);
  return force;
}

ContactProblem::ContactProblem(const Input& input)
    : parts_(std::make_unique<Parts>(input)) {
  Parts& parts = *parts_;
  Problem problem;
  std::vector<ElasticBody::Response> responses;
  if (const auto held = parts.body->compressed()) {
    responses.push_back(
        parts.body->response([&](const Vector& u) { return parts.form->pull(u); }));
    problem =
        condense(Flexibility(compressedFlexibility(
                     makeCompressedCoupling({{parts.space, parts.multiplier, input.lame}},
                                            input.stabilization, parts.units),
                     {held})),
                 responses);
  } else {
    responses.push_back(parts.body->response(parts.form->coupling()));
    problem = condense(parts.algebra, parts.form->multiplierMass(), responses);
  }
  problem.normals = parts.numbers.normals;
  problem.tangentials = std::move(parts.numbers.tangentials);
  takeAway(parts.obstacle, problem.offset);
  problem.stress = parts.size() > 0 ? parts.size() : 1;
  parts.numbers = std::move(problem);
}

ContactProblem::ContactProblem(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

ContactProblem::Parts::Parts(const Parts& same, const Conditions& conditions)
    : space(same.space),
      units(same.units),
      holding(makeHolding(space, conditions, units)),
      multiplier(same.multiplier.under(conditions)),
      opposite(same.opposite),
      form(same.form),
      algebra(same.algebra),
      obstacle(makeObstacle(space.mesh(), multiplier, *opposite, units)),
      gamma0(same.gamma0),
      body(std::make_unique<const ElasticBody>(same.body->under(holding))) {
  numbers.normals = multiplier.normals();
  numbers.tangentials = obstacle.tangentials;
}

double ContactProblem::loadSize() const { return parts_->size(); }

ContactProblem::~ContactProblem() = default;
ContactProblem::ContactProblem(ContactProblem&&) noexcept = default;

const Problem& ContactProblem::numbers() const { return parts_->numbers; }
const MultiplierSpace& ContactProblem::multiplier() const { return parts_->multiplier; }
const Opposite& ContactProblem::opposite() const { return *parts_->opposite; }
Index ContactProblem::freeMotions() const { return parts_->body->freeMotions(); }
Vector ContactProblem::moved(const double* motions) const {
  return parts_->body->moved(motions);
}
const Vector& ContactProblem::gap() const { return parts_->obstacle.gap; }
const Vector& ContactProblem::load() const { return parts_->holding.loads.load; }
double ContactProblem::gamma0() const { return parts_->gamma0; }
double ContactProblem::gamma(std::size_t contactElement) const {
  return parts_->form->gamma(contactElement);
}

Vector ContactProblem::displacement(const State& state, const Vector& met) const {
  const Vector still(static_cast<std::size_t>(parts_->body->freeMotions()), 0.0);
  return parts_->body->displacement(
      parts_->push(state, met), state.rigid.empty() ? still.data() : state.rigid.data());
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

double ContactProblem::storedEnergy(const State& state,
                                    const Vector& displacement) const {
  const Vector none(displacement.size(), 0.0);
  const Vector force = parts_->form->residual(none, displacement);  // -A u
  double twice = 0;
  for (std::size_t i = 0; i < force.size(); ++i)
    twice -= force[i] * displacement[i];
  if (!state.multiplier.empty())
    twice += parts_->form->multiplierWork(state.multiplier);
  return twice / 2;
}

Vector ContactProblem::density(const State& state, const Vector& displacement) const {
  return parts_->form->density(displacement, state.multiplier);
}

Vector ContactProblem::clampForces(const State& state, const Vector& displacement,
                                   const Vector& met) const {
  return parts_->body->clampForces(parts_->push(state, met), displacement);
}

Vector ContactProblem::clampWork(const State& state, const Vector& displacement,
                                 const Vector& met) const {
  return parts_->body->clampWork(parts_->push(state, met), displacement);
}

Vector ContactProblem::fixedReactions(const State& state, const Vector& met) const {
  return parts_->body->fixedReactions(parts_->push(state, met));
}

}  // namespace epafi::contact
