#include "contact/body/ElasticBody.hpp"

#include "bem/algebra/DenseAlgebra.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/body/IterativeRefinement.hpp"

#include <algorithm>

namespace epafi::contact {

using bem::axpy;
using bem::dot;

namespace {

/// What rounding has left of a correction; it is a force where |A| is large.  Not more,
/// or reactions would no longer say what u is worth.
Vector onlyRounding(Vector correction, const Vector& u) {
  const double limit = roundingOfCorrections * largestEntry(u);
  for (double& x : correction)
    x = std::clamp(x, -limit, limit);
  return correction;
}

/// What Fix makes of the prescribed displacement: the whole of u, what the particular solution has
/// of it included, has no mean motion.
Vector withoutFixedMotions(const Holding& holding) {
  const RigidConstraints& rigid = holding.rigid;
  Vector result = holding.loads.prescribed;
  for (Index k = 0; k < rigid.fixed(); ++k) {
    const Vector functional = columnOf(holding.modes.functionals, rigid.fixedModes[k]);
    double mean = dot(functional, holding.loads.prescribed);
    if (!holding.means.empty())
      mean += holding.means[at(rigid.fixedModes[k])];
    axpy(-rigid.scale(k) * mean, columnOf(rigid.allowed, k), result);
  }
  return result;
}

/// - Σ (C r)(C r)ᵀ
void subtractMotions(const Matrix& motions, Matrix& d) {
  for (Index k = 0; k < motions.columns(); ++k)
    for (Index j = 0; j < d.columns(); ++j)
      for (Index i = 0; i < d.rows(); ++i)
        d(i, j) -= motions(i, k) * motions(j, k);
}

/// C u from Cᵀ.
Vector pulled(const Matrix& transposed, const Vector& u) {
  Vector result(transposed.columns());
  for (Index i = 0; i < transposed.columns(); ++i) {
    const double* column = transposed.column(i);
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (Index j = 0; j < transposed.rows(); ++j)
      sum += column[j] * u[j];
    result[i] = sum;
  }
  return result;
}

}  // namespace

Holding makeHolding(const bem::Space& space, const Conditions& conditions,
                    bem::Units units) {
  Loads loads = makeLoads(space, conditions, units);
  RigidModes modes = makeRigidModes(space, conditions);
  RigidConstraints rigid = makeRigidConstraints(modes, loads, conditions.fix);
  const bem::Outline& outline = space.mesh().outline();
  if (outline.diameter() < outline.scaling().length)
    scalePairs(rigid);
  Vector means = meansOf(conditions, space.mesh(), modes.centroid);
  return {std::move(loads), std::move(modes), std::move(rigid), std::move(means)};
}

ElasticBody::ElasticBody(const StabilisedBody& form, const Holding& holding)
    : form_(&form),
      holding_(&holding),
      load_(holding.loads.load),
      constant_(withoutFixedMotions(holding)) {
  stiffness_ = form.held(holding);
  if (holding.loads.largestDisplacement > 0)
    load_ = form.residual(load_, holding.loads.prescribed);
}

ElasticBody ElasticBody::under(const Holding& holding) const {
  ElasticBody body = *this;
  body.holding_ = &holding;
  body.load_ = holding.loads.load;
  if (holding.loads.largestDisplacement > 0)
    body.load_ = form_->residual(body.load_, holding.loads.prescribed);
  body.constant_ = withoutFixedMotions(holding);
  return body;
}

// The unclamped, non-rigid displacement under a force.
Vector ElasticBody::respond(Vector force) const {
  for (std::size_t j = 0; j < force.size(); ++j)
    if (holding_->loads.clamped[j] != 0)
      force[j] = 0;
  Vector u = stiffness_->solve(force);
  for (Index k = 0; k < holding_->rigid.allowed.columns(); ++k) {
    const Vector r = columnOf(holding_->rigid.allowed, k);
    axpy(-dot(r, force), r, u);
  }
  return u;
}

ElasticBody::Response ElasticBody::response(Matrix coupling) const {
  Response response =
      this->response([&](const Vector& u) { return pulled(coupling, u); });
  response.half = stiffness_->forward(std::move(coupling));
  return response;
}

ElasticBody::Response ElasticBody::response(
    const std::function<Vector(const Vector& u)>& pull) const {
  const RigidConstraints& rigid = holding_->rigid;
  Response response;
  response.offset = pull(unpushed());
  response.motions =
      Matrix(static_cast<Index>(response.offset.size()), rigid.allowed.columns());
  for (Index k = 0; k < rigid.allowed.columns(); ++k) {
    const Vector moved = pull(columnOf(rigid.allowed, k));
    std::copy(moved.begin(), moved.end(), response.motions.column(k));
  }
  response.rigidLoad = rigidLoad();
  return response;
}

Vector ElasticBody::pushing() const {
  Vector all = load_;
  all.insert(all.end(), constant_.begin(), constant_.end());
  return all;
}

Vector ElasticBody::unpushed() const {
  Vector u = respond(load_);
  axpy(1, constant_, u);
  return u;
}

Vector ElasticBody::rigidLoad() const {
  const RigidConstraints& rigid = holding_->rigid;
  Vector result;
  for (Index k = rigid.fixed(); k < rigid.allowed.columns(); ++k)
    result.push_back(dot(columnOf(rigid.allowed, k), load_));
  return result;
}

Vector ElasticBody::moved(const double* motions) const {
  Vector u(load_.size(), 0.0);
  for (Index k = 0; k < freeMotions(); ++k)
    axpy(motions[k], columnOf(holding_->rigid.allowed, holding_->rigid.fixed() + k), u);
  return u;
}

Vector ElasticBody::displacement(const Vector& contactForce,
                                 const double* motions) const {
  Vector force = load_;
  axpy(-1, contactForce, force);
  Vector u = respond(std::move(force));
  axpy(1, constant_, u);
  axpy(1, moved(motions), u);
  if (compressed() != nullptr)
    return u;  // refined by its own product
  // What the factor leaves is ε |A| |u|.
  Vector whole = holding_->loads.load;
  axpy(-1, contactForce, whole);
  return refined(std::move(u),
                 [&](const Vector& now) { return respond(form_->residual(whole, now)); });
}

Vector ElasticBody::clampForces(const Vector& contactForce,
                                const Vector& displacement) const {
  const std::vector<char>& clamped = holding_->loads.clamped;
  Vector forces(clamped.size(), 0.0);
  if (std::none_of(clamped.begin(), clamped.end(), [](char c) { return c != 0; }))
    return forces;
  Vector rest = holding_->loads.load;
  axpy(-1, contactForce, rest);
  rest = form_->residual(rest, displacement);
  if (compressed() == nullptr)
    rest = form_->residual(rest, onlyRounding(respond(rest), displacement));
  for (std::size_t i = 0; i < rest.size(); ++i)
    if (clamped[i] != 0)
      forces[i] = -rest[i];
  return forces;
}

Vector ElasticBody::clampWork(const Vector& contactForce,
                              const Vector& displacement) const {
  const RigidModes& modes = holding_->modes;
  const Vector forces = clampForces(contactForce, displacement);
  Vector work(3, 0.0);
  for (std::size_t i = 0; i < forces.size(); ++i)
    for (Index k = 0; k < 3; ++k)
      work[k] += forces[i] * modes.motions(static_cast<Index>(i), k);
  work[2] += modes.centroid.x * work[1] - modes.centroid.y * work[0];
  return work;
}

Vector ElasticBody::fixedReactions(const Vector& contactForce) const {
  const RigidConstraints& rigid = holding_->rigid;
  Vector force = load_;
  axpy(-1, contactForce, force);
  Vector reactions(3, 0.0);
  for (Index k = 0; k < rigid.fixed(); ++k)
    reactions[rigid.fixedModes[k]] =
        -rigid.scale(k) * dot(columnOf(rigid.allowed, k), force);
  return reactions;
}

Problem condense(Flexibility flexibility,
                 const std::vector<ElasticBody::Response>& bodies) {
  Problem problem;
  problem.flexibility = std::move(flexibility);
  const auto m = static_cast<Index>(bodies.front().offset.size());
  Index free = 0;
  for (const auto& body : bodies)
    free += static_cast<Index>(body.rigidLoad.size());
  problem.rigid = Matrix(m, free);
  problem.offset.assign(m, 0.0);
  for (const auto& body : bodies) {
    axpy(1, body.offset, problem.offset);
    const Index fixed =
        body.motions.columns() - static_cast<Index>(body.rigidLoad.size());
    for (Index k = fixed; k < body.motions.columns(); ++k)
      std::copy_n(body.motions.column(k), m,
                  problem.rigid.column(problem.rigidMotions() + k - fixed));
    problem.rigidLoad.insert(problem.rigidLoad.end(), body.rigidLoad.begin(),
                             body.rigidLoad.end());
  }
  return problem;
}

Problem condense(Matrix multiplierMass,
                 const std::vector<ElasticBody::Response>& bodies) {
  Matrix d = std::move(multiplierMass);
  for (const auto& body : bodies) {
    subtractMotions(body.motions, d);
    d = addGram(std::move(d), body.half);
  }
  for (Index j = 0; j < d.columns(); ++j)
    for (Index i = j + 1; i < d.rows(); ++i)
      d(j, i) = d(i, j);
  return condense(Flexibility(std::move(d)), bodies);
}

}  // namespace epafi::contact
