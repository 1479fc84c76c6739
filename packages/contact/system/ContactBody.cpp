#include "contact/system/ContactBody.hpp"

#include "bem/algebra/SmallAlgebra.hpp"

#include <algorithm>
#include <limits>

namespace epafi::contact {

using bem::axpy;
using bem::dot;
using bem::largestEntry;

namespace {

// Corrections up to this size, relative to u, are rounding errors.
constexpr double roundingOfCorrections = 1e-12;

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
Vector withoutFixedMotions(const Holding& holding, const Vector& prescribed,
                           const Vector& means) {
  Vector result = prescribed;
  for (Index k = 0; k < holding.fixed(); ++k) {
    const Vector functional = columnOf(holding.modes.functionals, holding.fixedModes[k]);
    double mean = dot(functional, prescribed);
    if (!means.empty())
      mean += means[at(holding.fixedModes[k])];
    axpy(-holding.scales[at(k)] * mean, columnOf(holding.allowed, k), result);
  }
  return result;
}

Vector forceAgainst(Vector load, const Vector& contactForce) {
  if (!contactForce.empty())
    axpy(-1, contactForce, load);
  return load;
}

/// Where clamps hold a solid of revolution, u with the resultant that elimination leaves of f - A u: where
/// stresses balance each other it counts beside what acts along the axis.  The rest, refined, would bend
/// slender bodies, and in the plane the resultant tells how much of their bending is lost.
void addResultant(const ElasticBody& elastic, const Vector& force, Vector& u) {
  constexpr double enough = 1e-11;  // of the largest resultant
  constexpr int most = 3;
  const Holding& holding = elastic.holding();
  if (holding.allowed.columns() > 0)
    return;
  const auto ofFree = [&](Vector x) {
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] = holding.clamped[i] != 0 ? 0 : x[i];
    return x;
  };
  const Matrix& motions = holding.modes.motions;
  double acting = 0;
  for (Index k = 0; k < motions.columns(); ++k)
    acting = std::max(acting, std::abs(dot(columnOf(motions, k), force)));
  constexpr double rounding =
      1e-11;  // of displacements by what rounding leaves of a multiplier
  if (acting <= rounding * bem::largestEntry(u))
    return;
  for (int step = 0; step < most; ++step) {
    const Vector left = ofFree(elastic.residual(force, u));
    Vector spread(u.size());
    for (Index k = 0; k < motions.columns(); ++k) {
      const Vector motion = columnOf(motions, k);
      const Vector functional = ofFree(columnOf(holding.modes.functionals, k));
      const double missing = dot(motion, left);
      if (std::abs(missing) > enough * acting)
        axpy(missing / dot(motion, functional), functional, spread);
    }
    if (bem::largestEntry(spread) == 0)
      return;
    axpy(1, elastic.solve(spread), u);
  }
}

/// x + y, where y may be empty.
Vector sum(Vector x, const Vector& y) {
  if (!y.empty())
    axpy(1, y, x);
  return x;
}

}  // namespace

ContactBody::ContactBody(const BodyInput& input, std::shared_ptr<const Obstacle> obstacle,
                         std::shared_ptr<const ElasticBody> elastic, std::size_t number,
                         Index firstMotion)
    : space_(&input.space),
      units_(input.units),
      obstacle_(std::move(obstacle)),
      number_(number),
      firstMotion_(firstMotion),
      loads_(makeLoads(*space_, input.conditions, units_)),
      elastic_(std::move(elastic)) {
  reactions_ = std::make_shared<const std::vector<Reaction>>(makeReactions());
  setLoads();
}

ContactBody ContactBody::under(std::shared_ptr<const Obstacle> obstacle) const {
  ContactBody result = *this;
  result.obstacle_ = std::move(obstacle);
  result.loads_ = makeLoads(*space_, result.conditions(), units_);
  result.setLoads();
  return result;
}

void ContactBody::setLoads() {
  if (const BoundaryTraction known = knownTraction()) {
    loads_.residual = residualOf(known);
    if (loads_.given.empty())
      loads_.given = loads_.load;
    if (!loads_.residual.force.empty())
      axpy(1, loads_.residual.force, loads_.load);
  }
  load_ = loads_.load;
  if (loads_.largestDeformation > 0) {
    Vector deformation = loads_.prescribed;
    axpy(-1, loads_.rigidPart, deformation);
    load_ = elastic_->residual(load_, deformation);
  }
  constant_ = withoutFixedMotions(
      holding(), loads_.prescribed,
      meansOf(conditions(), space_->mesh(), holding().modes.centroid));
}

Vector ContactBody::apply(const Vector& u) const {
  Vector result = coupling().trace.apply(u);
  if (!coupling().weights.empty())
    coupling().subtractWeighted(elastic_->tractionsOf(u), result);
  return result;
}

Vector ContactBody::massTimes(const Vector& multiplier) const {
  Vector result = coupling().massTimes(multiplier);
  if (coupling().byDensity())
    coupling().subtractWeighted(elastic_->responsesTo(coupling().weighted(multiplier)),
                                result);
  return result;
}

Vector ContactBody::contactForce(const Vector& multiplier) const {
  Vector force(load_.size(), 0.0);
  if (multiplier.empty())
    return force;
  if (!coupling().weights.empty())
    axpy(-1, elastic_->forcesOf(coupling().weighted(multiplier)), force);
  for (const TraceCoupling* trace : {&coupling().trace, &coupling().completion})
    trace->addTranspose(1, multiplier.data(), force.data());
  return force;
}

Vector ContactBody::pushing() const {
  Vector all = load_;
  all.insert(all.end(), constant_.begin(), constant_.end());
  return all;
}

Vector ContactBody::heldDisplacement(const Vector& force) const {
  Vector u = elastic_->solve(sum(force, reactionsTo(force).force));
  axpy(1, constant_, u);
  return u;
}

// β = <γ (λ + t_p + S u - Σ ρ r), r>, S r = 0
void ContactBody::addFixedMotions(const Vector& force, const Vector& multiplier,
                                  Vector& u) const {
  Vector beta = reactionsTo(force).means;
  beta = sum(std::move(beta), loads_.residual.means);
  for (std::size_t k = 0; k < beta.size(); ++k) {
    const Loads::InResidual& one = reactions()[k].residual;
    beta[k] -= dot(one.force, u);
    if (!multiplier.empty())
      beta[k] += dot(one.terms, multiplier);
  }
  for (std::size_t k = 0; k < beta.size(); ++k)
    axpy(beta[k], columnOf(holding().allowed, static_cast<Index>(k)), u);
}

Vector ContactBody::displacementOfLoads() const {
  Vector u = heldDisplacement(load_);
  addFixedMotions(load_, {}, u);
  return u;
}

Vector ContactBody::rigidLoad() const {
  Vector result;
  for (Index k = holding().fixed(); k < holding().allowed.columns(); ++k)
    result.push_back(dot(columnOf(holding().allowed, k), load_));
  return result;
}

Vector ContactBody::displacement(const State& state, const Vector& contactForce,
                                 const Vector& feet) const {
  const Vector force = forceAgainst(load_, contactForce);
  Vector u = heldDisplacement(force);
  for (Index k = 0; k < holding().free() && !state.rigid.empty(); ++k)
    axpy(state.rigid[at(firstMotion_ + k)],
         columnOf(holding().allowed, holding().fixed() + k), u);
  if (elastic_->isFormed()) {
    // What the factor leaves is ε |A| |u|.
    const Vector whole = wholeForce(contactForce);
    u = refined(std::move(u), [&](const Vector& now) {
      Vector left = elastic_->residual(whole, now);
      if (!feet.empty()) {
        Vector apart = feet;
        axpy(-1, apply(now), apart);
        axpy(1, elastic_->beddingForce(apart), left);
      }
      return elastic_->solve(left);
    });
  } else if (space_->mesh().outline().isAxisymmetric()) {
    addResultant(*elastic_, wholeForce(contactForce), u);
  }
  addFixedMotions(force, state.multiplier, u);
  return u;
}

Vector ContactBody::wholeForce(const Vector& contactForce) const {
  return sum(forceAgainst(loads_.load, contactForce),
             reactionsTo(forceAgainst(load_, contactForce)).force);
}

bem::Vec2 ContactBody::foreignTraction(const Vector& multiplier,
                                       const std::vector<Opposite::Source>& point) const {
  bem::Vec2 sum;
  for (const Opposite::Source& source : point) {
    const auto stress = this->multiplier().at(multiplier, *source.element, source.t);
    sum = sum + source.stretching * (stress.normal * source.across +
                                     stress.tangential * turnLeft(source.across));
  }
  return sum;
}

Vector ContactBody::penetration(const Vector& displacement, const Vector& multiplier,
                                const Vector& contactForce) const {
  Vector r = apply(displacement);
  if (!multiplier.empty())
    axpy(-1, massTimes(multiplier), r);
  return sum(std::move(r), reactionsTo(forceAgainst(load_, contactForce)).terms);
}

ContactBody::Results ContactBody::results(const State& state, const Vector& displacement,
                                          const Vector& contactForce) const {
  const ElasticBody::Image image = elastic_->imageOf(displacement);
  Vector psi = density(state, displacement, contactForce);
  const double strain = strainEnergy(state, displacement, contactForce, image.work, psi);
  const Vector none(displacement.size());
  return {std::move(psi), clampForces(image, displacement, contactForce), strain,
          storedEnergy(state, contactForce, -dot(image.residual(none), displacement))};
}

// With w = N λ:  uᵀ A u - 2 uᵀ R w + wᵀ X w - ψᵀ G ψ, which has no differences of what grows as
// ν -> 1/2 while γ is there.  What acts inside and what Fix holds add g to w in all places,
// ψ_g = -(V + G)⁻¹ g.
double ContactBody::strainEnergy(const State& state, const Vector& displacement,
                                 const Vector& contactForce, double stiffnessWork,
                                 const Vector& density) const {
  double twice = stiffnessWork;
  if (!coupling().hasCompliance())
    return 0.5 * twice;
  const Loads::InResidual residual = inResidual(contactForce);
  if (!residual.density.empty())
    twice -= 2 * dot(displacement, residual.force) +
             dot(residual.compliance, residual.density);
  twice -= coupling().complianceWork(density);
  if (!coupling().byDensity() || state.multiplier.empty())
    return 0.5 * twice;
  const Vector w = coupling().weighted(state.multiplier);
  if (!residual.density.empty())
    twice -= 2 * dot(w, coupling().ofDensities(residual.density));
  twice -= 2 * dot(displacement, elastic_->forcesOf(w));
  return 0.5 * (twice + dot(w, elastic_->responsesTo(w)));
}

double ContactBody::storedEnergy(const State& state, const Vector& contactForce,
                                 double workOfForces) const {
  double twice = workOfForces;
  if (!state.multiplier.empty())
    twice += dot(state.multiplier, massTimes(state.multiplier));
  const Vector force = forceAgainst(load_, contactForce);
  const Loads::InResidual reactions = reactionsTo(force);
  if (!state.multiplier.empty())
    twice -= 2 * dot(reactions.terms, state.multiplier);
  for (std::size_t k = 0; k < reactions.means.size(); ++k)
    twice += dot(columnOf(holding().allowed, static_cast<Index>(k)), force) *
             reactions.means[k];
  return twice / 2;
}

Vector ContactBody::density(const State& state, const Vector& displacement,
                            const Vector& contactForce) const {
  const Vector psi =
      elastic_->density(displacement, coupling().byDensity() && !state.multiplier.empty()
                                          ? coupling().weighted(state.multiplier)
                                          : Vector());
  return sum(psi, inResidual(contactForce).density);
}

Vector ContactBody::clampForces(const ElasticBody::Image& image,
                                const Vector& displacement,
                                const Vector& contactForce) const {
  const std::vector<char>& clamped = holding().clamped;
  Vector forces(clamped.size(), 0.0);
  if (std::none_of(clamped.begin(), clamped.end(), [](char c) { return c != 0; }))
    return forces;
  Vector rest = image.residual(wholeForce(contactForce));
  if (elastic_->isFormed())  // freed from rounding
    rest = elastic_->residual(rest, onlyRounding(elastic_->solve(rest), displacement));
  for (std::size_t i = 0; i < rest.size(); ++i)
    if (clamped[i] != 0)
      forces[i] = -rest[i];
  return forces;
}

Vector ContactBody::clampWork(const Vector& clampForces) const {
  const RigidModes& modes = holding().modes;
  Vector work(3, 0.0);
  for (std::size_t i = 0; i < clampForces.size(); ++i)
    for (Index k = 0; k < 3; ++k)
      work[at(k)] += clampForces[i] * modes.motions(static_cast<Index>(i), k);
  return work;
}

Vector ContactBody::fixedReactions(const Vector& contactForce) const {
  const Vector force = forceAgainst(load_, contactForce);
  Vector reactions(3, 0.0);
  for (Index k = 0; k < holding().fixed(); ++k)
    reactions[at(holding().fixedModes[at(k)])] =
        -holding().scales[at(k)] * dot(columnOf(holding().allowed, k), force);
  return reactions;
}

Vector ContactBody::fixedMeans() const {
  Vector means =
      bem::times(-1, meansOf(conditions(), space_->mesh(), holding().modes.centroid));
  means.resize(3);
  for (std::size_t i = 0; i < loads_.prescribed.size(); ++i)
    for (Index k = 0; holding().clamped[i] != 0 && k < 3; ++k)
      means[at(k)] -=
          holding().modes.functionals(static_cast<Index>(i), k) * loads_.prescribed[i];
  for (std::size_t k = 0; k < loads_.residual.means.size(); ++k)
    means[at(holding().fixedModes[k])] += loads_.residual.means[k] / holding().scales[k];
  return means;
}

Vector refined(Vector u, const std::function<Vector(const Vector&)>& correction) {
  constexpr int mostSteps = 4;
  double last = std::numeric_limits<double>::infinity();
  for (int step = 0; step < mostSteps; ++step) {
    const Vector change = correction(u);
    const double size = largestEntry(change);
    if (!(size < 0.5 * last))
      break;
    axpy(1, change, u);
    last = size;
    if (!(size > roundingOfCorrections * largestEntry(u)))
      break;
  }
  return u;
}

}  // namespace epafi::contact
