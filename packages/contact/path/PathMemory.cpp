#include "contact/path/PathMemory.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/equation/Classify.hpp"
#include "contact/opposite/SidePoints.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace epafi::contact {

namespace {

using Element = MultiplierSpace::ContactElement;

/// ½ (a + a⁻) · (b - b⁻)
double trapezoid(const Vector& a, const Vector& aBefore, const Vector& b,
                 const Vector& bBefore, std::size_t count) {
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i)
    sum += 0.5 * (a[i] + aBefore[i]) * (b[i] - bBefore[i]);
  return sum;
}

/// visit(i, number among the tangential coefficients) of each that is the element's own.
template <class Visit>
void forEachTangential(const Element& element, Index normals, const Visit& visit) {
  for (int i = 0; i <= element.degree && element.shears(); ++i)
    if (element.tangential.isOwn(i))
      visit(i, at(element.tangentialOf(i) - normals));
}

/// One after the other.
template <class Parts>
Vector inARow(const Parts& parts) {
  Vector all;
  for (const auto& part : parts)
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// Where something acts inside, what Fix holds moves, u_h against the particular solution, and where
/// supports are loaded by what the residual of the stabilisation leaves; where clamps move, too, the
/// rest against them: Fix pulls at the rest alone.
bool fixWorks(const ContactSystem& step, std::size_t b) {
  const Conditions& conditions = step.body(b).conditions();
  const Conditions::Fix& fix = conditions.fix;
  return conditions.inside != nullptr || !step.body(b).loads().residual.means.empty() ||
         (!conditions.dirichlet.empty() && (fix.x || fix.y || fix.rotation));
}

/// What acts on bodies from outside: on those that deform loads and clamps, on the others
/// what moves them against the contact.
Vector forcesFromOutside(const ContactSystem& step, const Configuration& at) {
  std::vector<Vector> forces;
  for (std::size_t b = 0; b < step.size(); ++b) {
    forces.push_back(at.results[b].clampForces);
    bem::axpy(1, step.body(b).loads().load, forces.back());
    if (fixWorks(step, b))
      forces.push_back(step.body(b).fixedReactions(at.contactForces[b]));
  }
  for (const auto& [x, y, moment] : step.rigidForces(at.state))
    forces.push_back({-x, -y, -moment});
  return inARow(forces);
}

/// In the same order.
Vector motionsOf(const ContactSystem& step, const Configuration& at) {
  std::vector<Vector> motions;
  for (std::size_t b = 0; b < step.size(); ++b) {
    motions.push_back(at.displacements[b]);
    if (fixWorks(step, b))
      motions.push_back(step.body(b).fixedMeans());
  }
  for (const RigidMotion& motion : at.rigid)
    motions.push_back({motion.slide.x, motion.slide.y, motion.turn});
  return inARow(motions);
}

}  // namespace

PathMemory::PathMemory(const ContactSystem& atZero, Shear shear)
    : shear_(shear),
      friction_(atZero.numbers().tangentials.size(), 0.0),
      multiplier_(atZero.numbers().size(), 0.0),
      bounds_(atZero.numbers().slipBounds(multiplier_)),
      given_(multiplier_.size(), 0.0) {
  memory_.slip = friction_;
  std::size_t size = 3 * atZero.drives().size();
  for (std::size_t b = 0; b < atZero.size(); ++b)
    size += atZero.body(b).loads().load.size() + (fixWorks(atZero, b) ? 3 : 0);
  motions_.assign(size, 0.0);
  forces_ = motions_;
  // what overlaps without a displacement is pushed apart from touching on
  for (std::size_t i = 0; i < atZero.gap().size(); ++i)
    given_[i] = -std::max(atZero.gap()[i], 0.0);
}

void PathMemory::add(const ContactSystem& step, const Configuration& at) {
  const Problem& problem = step.numbers();
  const std::size_t normals = problem.normals;
  Vector bounds = problem.slipBounds(at.state.multiplier);
  Vector work = contact::frictionWork(problem, at.state, at.penetration);
  // what opens slides on without a bound: no rounding shall decide whether that counts
  constexpr double most = 3;
  for (std::size_t t = 0; shear_ == Shear::Mean && t < work.size(); ++t)
    if (work[t] > 0)
      work[t] *= 0.5 + 0.5 * std::min(bounds_[t] / bounds[t], most);
  bem::axpy(1, work, friction_);
  for (std::size_t i = normals; i < multiplier_.size(); ++i)
    trapezoidal_ += 0.5 * (at.state.multiplier[i] + multiplier_[i]) * at.penetration[i];
  Vector forces = forcesFromOutside(step, at);
  Vector motions = motionsOf(step, at);
  outside_ +=
      trapezoid(forces, forces_, motions, motions_, motions.size()) +
      trapezoid(at.state.multiplier, multiplier_, step.given(), given_, given_.size());
  memory_.wear = step.wear().behind(at.state.multiplier, problem.stress);
  Vector worn = step.wear().tested(memory_.wear);
  worn_.resize(worn.size());
  ofWear_ += trapezoid(at.state.multiplier, multiplier_, worn, worn_, normals);
  worn_ = std::move(worn);
  memory_.slip = step.slipSoFar(at);
  memory_.defect = step.defect(at);
  // what rounding leaves of r where contact is closed: under the same load, Newton's method would
  // look for states that it alone decides
  const ContactStates states = classify(problem, at.state, at.penetration);
  for (std::size_t i = 0; i < normals; ++i)
    if (states[i] == ContactState::Closed)
      memory_.defect[i] -= at.penetration[i];
  memory_.largestLoad = std::max(memory_.largestLoad, step.loadSize());
  memory_.responses = step.responses();
  multiplier_ = at.state.multiplier;
  bounds_ = std::move(bounds);
  motions_ = std::move(motions);
  forces_ = std::move(forces);
  given_ = step.given();
}

double PathMemory::friction() const {
  return std::accumulate(friction_.begin(), friction_.end(), 0.0);
}

double PathMemory::wornVolume() const {
  return std::accumulate(worn_.begin(), worn_.end(), 0.0);
}

PathMemory::Difference PathMemory::apart(const PathMemory& other) const {
  Difference difference;
  for (std::size_t t = 0; t < friction_.size(); ++t) {
    difference.work += std::abs(friction_[t] - other.friction_[t]);
    const double bound = std::max(bounds_[t], other.bounds_[t]);
    if (std::isfinite(bound))  // else what is bonded, which does no work
      difference.slip += bound * std::abs(memory_.slip[t] - other.memory_.slip[t]);
  }
  for (std::size_t i = 0; i < worn_.size(); ++i)
    difference.volume += std::abs(worn_[i] - other.worn_[i]);
  return difference;
}

std::map<std::string, double> frictionWorkOfContacts(const ContactBody& body,
                                                     const Vector& frictionWork) {
  std::map<std::string, double> result;
  std::vector<char> seen(frictionWork.size(), 0);  // neighbours may share a coefficient
  for (const Element& element : body.elements()) {
    double& work = result[nameOf(element)];
    forEachTangential(element, body.multiplier().normals(), [&](int, std::size_t t) {
      if (seen[t] == 0)
        work += frictionWork[t];
      seen[t] = 1;
    });
  }
  return result;
}

Vector frictionWorkDensity(const MultiplierSpace& multiplier,
                           const Vector& frictionWork) {
  Vector lengths(frictionWork.size(), 0.0);  // ∫ χ_i
  forEachGaussPoint(multiplier, [&](const SidePoint& point) {
    forEachTangential(point.contact, multiplier.normals(), [&](int i, std::size_t t) {
      lengths[t] += point.weight * point.chi[at(i)];
    });
  });
  Vector density(multiplier.size(), 0.0);
  for (std::size_t t = 0; t < lengths.size(); ++t)
    if (lengths[t] > 0)  // else what is bonded, which does no work
      density[static_cast<std::size_t>(multiplier.normals()) + t] =
          frictionWork[t] / lengths[t];
  return density;
}

}  // namespace epafi::contact
