#include "contact/body/ElasticBody.hpp"

#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/body/IterativeRefinement.hpp"

#include <algorithm>

namespace epafi::contact {

using bem::axpy;
using bem::dot;

using bem::DenseAlgebra;
using bem::Rows;

namespace {

/// What rounding has left of a correction; it is a force where |A| is large.  Not more,
/// or reactions would no longer say what u is worth.
Vector onlyRounding(Vector correction, const Vector& u) {
  const double limit = roundingOfCorrections * largestEntry(u);
  for (double& x : correction)
    x = std::clamp(x, -limit, limit);
  return correction;
}

/// What Fix makes of the prescribed displacement: the whole of u has no mean motion.
Vector withoutFixedMotions(const Holding& holding) {
  const RigidConstraints& rigid = holding.rigid;
  Vector result = holding.loads.prescribed;
  for (Index k = 0; k < rigid.fixed(); ++k) {
    const Vector functional = columnOf(holding.modes.functionals, rigid.fixedModes[k]);
    axpy(-rigid.scale(k) * dot(functional, holding.loads.prescribed),
         columnOf(rigid.allowed, k), result);
  }
  return result;
}

/// lower += or -= half's Gram matrix is DenseAlgebra's; this is - Σ (C r)(C r)ᵀ.
void subtractMotions(const Matrix& motions, const Rows& mine, Matrix& lower) {
  for (Index k = 0; k < motions.columns(); ++k)
    for (Index j = 0; j < lower.columns(); ++j)
      for (Index i = 0; i < mine.size(); ++i)
        lower(i, j) -= motions(i + mine.begin, k) * motions(j, k);
}

}  // namespace

Holding makeHolding(const bem::Space& space, const Conditions& conditions,
                    bem::Units units) {
  Loads loads = makeLoads(space, conditions, units);
  RigidModes modes = makeRigidModes(space);
  RigidConstraints rigid = makeRigidConstraints(modes, loads, conditions.fix);
  const bem::Outline& outline = space.mesh().outline();
  if (outline.diameter() < outline.scaling().length)
    scalePairs(rigid);
  return {std::move(loads), std::move(modes), std::move(rigid)};
}

Vector pull(const DenseAlgebra& algebra, const Matrix& transposed, const Vector& u) {
  const Rows mine = algebra.myRows(static_cast<Index>(u.size()));
  Vector result(transposed.columns());
  for (Index i = 0; i < transposed.columns(); ++i) {
    const double* column = transposed.column(i);
    const double* own = u.data() + mine.begin;
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (Index j = 0; j < mine.size(); ++j)
      sum += column[j] * own[j];
    result[i] = sum;
  }
  return algebra.sum(std::move(result));
}

Matrix constrained(Matrix lower, const Rows& mine, const Holding& holding) {
  const std::vector<char>& clamped = holding.loads.clamped;
  const auto diagonal = [&](Index j) { return std::max<Index>(0, j - mine.begin); };
  for (Index j = 0; j < lower.columns(); ++j)
    for (Index i = diagonal(j); i < lower.rows(); ++i) {
      const Index row = i + mine.begin;
      if (clamped[row] != 0 || clamped[j] != 0)
        lower(i, j) = row == j ? 1 : 0;
    }
  for (Index k = 0; k < holding.rigid.functionals.columns(); ++k) {
    const double* c = holding.rigid.functionals.column(k);
    for (Index j = 0; j < lower.columns(); ++j)
      for (Index i = diagonal(j); i < lower.rows(); ++i)
        lower(i, j) += c[i + mine.begin] * c[j];
  }
  return lower;
}

ElasticBody::ElasticBody(const StabilisedBody& form, const DenseAlgebra& algebra,
                         const Holding& holding)
    : form_(&form),
      algebra_(&algebra),
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
      this->response([&](const Vector& u) { return pull(*algebra_, coupling, u); });
  const Rows mine = algebra_->myRows(static_cast<Index>(load_.size()));
  for (Index j = 0; j < coupling.columns(); ++j)
    for (Index i = 0; i < coupling.rows(); ++i)
      if (holding_->loads.clamped[i + mine.begin] != 0)
        coupling(i, j) = 0;
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

Problem condense(const DenseAlgebra& algebra, Matrix multiplierMass,
                 const std::vector<ElasticBody::Response>& bodies) {
  const auto m = static_cast<Index>(bodies.front().offset.size());
  const Rows mine = algebra.myRows(m);
  Matrix d = mine.size() == m ? std::move(multiplierMass)
                              : bem::rowsBetween(multiplierMass, mine.begin, mine.end);
  for (const auto& body : bodies) {
    subtractMotions(body.motions, mine, d);
    d = algebra.addGram(std::move(d), body.half);
  }
  d = algebra.replicate(std::move(d), m);
  for (Index j = 0; j < m; ++j)
    for (Index i = j + 1; i < m; ++i)
      d(j, i) = d(i, j);
  return condense(Flexibility(std::move(d)), bodies);
}

}  // namespace epafi::contact
