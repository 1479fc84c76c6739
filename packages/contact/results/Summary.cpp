#include "contact/results/Summary.hpp"

#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"
#include "bem/quadrature/Piecewise.hpp"
#include "contact/body/Loads.hpp"
#include "contact/multiplier/ContinuousMultiplier.hpp"
#include "contact/opposite/SidePoints.hpp"
#include "contact/opposite/TraceCoupling.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace epafi::contact {

namespace {

using bem::Vec2;
using Element = MultiplierSpace::ContactElement;
using bem::Profile;

/// Length of {f > 0} as a part of [-1, 1].
double positivePart(const Profile& f, int degree) {
  double sum = 0;
  const bem::Rule pieces = bem::piecewiseRule(bem::signChanges(f, degree), 1);
  for (std::size_t k = 0; k < pieces.points.size(); ++k)
    if (f(pieces.points[k]) > 0)
      sum += pieces.weights[k];
  return sum;
}

void add(const Resultant& more, Resultant& sum) {
  sum.x += more.x;
  sum.y += more.y;
  sum.moment += more.moment;
}

/// Around a solid of revolution radial forces cancel, and so do moments.
Resultant around(const bem::Units& units, const Resultant& force) {
  return units.isAxisymmetric ? Resultant{0, force.y, 0} : force;
}

double closedPart(const ContactFields& fields, const Element& element) {
  return positivePart([&](double t) { return fields.closing(element, t); },
                      element.degree);
}

/// Half the length of an element in which contact ends, or of the larger one of two between which it
/// ends; else 0.  Contact that reaches the end of its side ends there exactly.
/// \param closed  closedPart of all elements
double doubtOfEnd(const Solved& solved, const ContactFields& fields, const Vector& closed,
                  std::size_t k) {
  constexpr double all = 2;
  constexpr double rounding = 1e-9;
  const auto isWhole = [&](std::size_t i) { return closed[i] > all - rounding; };
  const auto isOpen = [&](std::size_t i) { return closed[i] < rounding; };
  const std::vector<Element>& elements = fields.elements();
  const auto half = [&](std::size_t i) {
    return solved.units.length * solved.space.mesh()[elements[i].element].half;
  };
  if (!isWhole(k) && !isOpen(k))
    return half(k);
  if (!elements[k].follower)
    return 0;
  const std::size_t next = *elements[k].follower;
  const bool ends = (isWhole(k) && isOpen(next)) || (isOpen(k) && isWhole(next));
  return ends ? std::max(half(k), half(next)) : 0;
}

void addElement(const Solved& solved, const ContactFields& fields, const Element& element,
                double closed, Summary& summary) {
  const int p = element.degree;
  const double length = solved.units.length;
  const double area = solved.units.measure();
  const bem::Mesh& mesh = solved.space.mesh();
  const MultiplierBasis& basis = solved.problem.multiplier().basis();
  const bem::Element& side = mesh[element.element];
  forEachPointOf(element, basis, bem::gaussLegendre(p + 1), [&](const SidePoint& point) {
    const auto stress = fields.stress(element, point.t);
    const double weight = area * point.weight;
    summary.forceNormal += weight * stress.normal;
    summary.forceTangential += weight * stress.tangential;
    if (solved.wear != nullptr)
      summary.wornVolume += weight * length * solved.wear->depth[point.gaussPoint()];
  });
  // the force on the body, -λₙ n - λₜ t, and its moment
  const Opposite& opposite = solved.problem.opposite();
  for (const Stretch& stretch : stretches(opposite, element))
    forEachPointOf(
        element, basis, ruleOfForces(element, opposite.at(element, stretch.middle)),
        [&](const SidePoint& point) {
          const auto stress = fields.stress(element, point.t);
          const double weight = -area * point.weight;
          const Vec2 force = weight * (stress.normal * point.normal.unit +
                                       stress.tangential * point.tangent.unit);
          const Vec2 place = mesh.physicalPoint(element.element, point.t);
          Resultant sum{force.x, force.y, cross(place, force)};
          sum.moment -= weight * length * stress.normal * point.normal.ownTurn;
          add(around(solved.units, sum), summary.contact);
          if (point.opposite.element < 0)
            add(around(solved.units, sum), summary.obstacle);
        },
        stretch);
  summary.contactLength += length * side.half * closed;
  if (element.shears())
    summary.slipLength +=
        length * side.half *
        positivePart([&](double t) { return fields.slipping(element, t); }, p);
}

/// insideSides, but for elements that meet corners opposite: pressures may have no bound there, too.
std::vector<char> awayFromCorners(const Solved& solved,
                                  const std::vector<Element>& elements) {
  std::vector<char> isInside =
      insideSides(solved.problem.multiplier(), solved.problem.number());
  const Opposite& opposite = solved.problem.opposite();
  const auto turns = [&](const Element& a, double s, const Element& b, double t) {
    return std::abs(opposite.at(a, s).direction.angle -
                    opposite.at(b, t).direction.angle) > bem::smoothAngle;
  };
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const Element& element = elements[k];
    constexpr double beside = 1e-9;
    for (const double t : opposite.breaks(element))
      if (turns(element, t - beside, element, t + beside))
        isInside[k] = 0;
    if (element.follower && turns(element, 1, elements[*element.follower], -1))
      isInside[k] = isInside[*element.follower] = 0;
  }
  return isInside;
}

/// of(element): the Summary that it is added to.
template <class Of>
void addContact(const Solved& solved, const Of& of) {
  const ContactFields fields(solved);
  const std::vector<char> isInside = awayFromCorners(solved, fields.elements());
  const Vector pressures = fields.continuous();
  Vector closed;
  for (const Element& element : fields.elements())
    closed.push_back(closedPart(fields, element));
  for (std::size_t k = 0; k < isInside.size(); ++k) {
    const Element& element = fields.elements()[k];
    Summary& summary = of(element);
    addElement(solved, fields, element, closed[k], summary);
    summary.contactLengthError += doubtOfEnd(solved, fields, closed, k);
    summary.peak.add(fields, pressures, element, isInside[k] != 0);
  }
}

/// Work of the reactions on the rigid motions v of RigidModes, dimensionless:
///
///   R·v = (A u + Bᵀ λ - f)·v_c + Σ_k ρ_k ∫ r_k · (v - v_c) ds,
///
/// v_c: v at the prescribed unknowns, r_k: the fixed modes.  A clamp that lies where the
/// traction ρ_k r_k acts takes that up again, hence v - v_c.
std::array<double, 3> reactionWork(const Solved& solved) {
  const Holding& holding = solved.problem.holding();
  const auto& [motions, modes, centroid] = holding.modes;
  const Vector clamps = solved.problem.clampWork(solved.results.clampForces);
  const Vector amplitudes = solved.problem.fixedReactions(solved.contactForce);
  std::array<double, 3> work{};
  for (Index v = 0; v < 3; ++v) {
    double& sum = work[v];
    sum = clamps[v];
    for (Index i = 0; i < motions.rows(); ++i)
      if (holding.clamped[i] == 0)
        for (Index k = 0; k < 3; ++k)
          sum += amplitudes[k] * modes(i, k) * motions(i, v);
  }
  return work;
}

/// From work on the rigid motions to forces and their moment about the user's origin:
/// M = M_centroid d + centroid x force.
Resultant resultantOf(const std::array<double, 3>& work, const Solved& solved) {
  const Vec2 centroid =
      solved.space.mesh().outline().physical(solved.problem.holding().modes.centroid);
  const double force = solved.units.force();
  return {force * work[0], force * work[1],
          force * (solved.units.length * work[2] + cross(centroid, {work[0], work[1]}))};
}

/// The rigid motion with the moments of u over the boundary, [length] and radian.
RigidMotion meanMotion(const Solved& solved) {
  const RigidModes& modes = solved.problem.holding().modes;
  const Vector ofInside = meansOf(solved.conditions, solved.space.mesh(), modes.centroid);
  const auto mean = [&](Index k) {
    const Vector functional = bem::columnOf(modes.functionals, k);
    double whole = bem::dot(functional, solved.displacement);
    if (!ofInside.empty())
      whole += ofInside[at(k)];
    const double unit = bem::dot(functional, bem::columnOf(modes.motions, k));
    return unit > 0 ? whole / unit : 0;
  };
  return {{solved.units.length * mean(0), solved.units.length * mean(1)}, mean(2)};
}

/// Work of a load on the rigid motions, fᵀ v.
std::array<double, 3> workOf(const Vector& load, const Solved& solved) {
  const Vector work = transposedProduct(solved.problem.holding().modes.motions, load);
  return {work[0], work[1], work[2]};
}

/// What a particular solution u_p = u_b + u_T, of forces and of heat, adds to the energies of the
/// rest u_h, dimensionless: to the strain energy ∫ t_h·u_b + t_T·u_h ds + ½ ∫ σ_p : C⁻¹ σ_p, to the
/// loads' work ∫ f·u_p ds + ∫ b·u.
struct EnergiesOfInside {
  double strain = 0;
  double load = 0;
};

// By Betti's formula ∫ b·u_h = ∮ t_h·u_b - t_b·u_h.
EnergiesOfInside energiesOfInside(const Solved& solved) {
  const BodyLoadSolution& inside = solved.conditions.inside;
  if (!inside)
    return {};
  const bem::Mesh& mesh = solved.space.mesh();
  const Vector& u = solved.displacement;
  const Vector& psi = solved.results.density;
  double ofForces = 0;  // ∮ t_h·u_b
  double ofHeat = 0;    // ∮ t_T·u_h
  for (int e = 0; e < mesh.size(); ++e) {
    const bem::Rule& rule = bem::gaussForGiven(mesh[e].degree);
    for (int q = 0; q < rule.size(); ++q) {
      const double t = rule.points[q];
      const double weight = mesh.measure(e, t) * rule.weights[q];
      const Vec2 y = mesh.scaledPoint(e, t);
      ofForces += weight *
                  dot(solved.space.densityAt(psi, e, t), inside->displacementOfForces(y));
      ofHeat += weight * dot(inside->stressOfHeat(mesh, e, t).on(mesh[e].curve.normal(t)),
                             solved.field.at(e, t));
    }
  }
  const auto [own, within] = inside->energies(mesh);
  const Loads::OfInside& loads = solved.problem.loads().inside;
  const double weight = ofForces - (bem::dot(loads.traction, u) - ofHeat) + within;
  return {ofForces + ofHeat + own, loads.work + weight};
}

}  // namespace

Summary summarize(const Solved& solved) {
  const double energy = solved.units.energy();
  const Vector& u = solved.displacement;
  Summary summary;
  const bool acts = solved.conditions.inside != nullptr;
  const Loads& loads = solved.problem.loads();
  const Vector& load = loads.given.empty() ? loads.load : loads.given;
  summary.energyStrain = energy * solved.results.strainEnergy;
  summary.energyLoad = energy * bem::dot(load, u);
  if (acts) {
    const EnergiesOfInside more = energiesOfInside(solved);
    summary.energyStrain += energy * more.strain;
    summary.energyLoad += energy * more.load;
    // what it leaves to the boundary is its negative
    std::array<double, 3> work = workOf(loads.inside.traction, solved);
    for (double& x : work)
      x = -x;
    summary.inside = resultantOf(work, solved);
  }
  Summary supports;
  addContact(solved, [&](const Element& element) -> Summary& {
    return element.condition->isSupport ? supports : summary;
  });
  if (!std::isfinite(summary.energyStrain + summary.energyLoad))
    throw bem::NumericalError(
        "energies are beyond numbers: displacements are too large for all; look at the "
        "units of Young's modulus, loads and lengths");
  summary.motion = meanMotion(solved);
  summary.load = resultantOf(workOf(load, solved), solved);
  summary.reaction = resultantOf(reactionWork(solved), solved);
  add(supports.contact, summary.reaction);
  return summary;
}

std::map<std::string, Summary> summarizeContacts(const Solved& solved) {
  std::map<std::string, Summary> contacts;
  addContact(solved, [&](const Element& element) -> Summary& {
    return contacts[nameOf(element)];
  });
  return contacts;
}

std::map<std::string, double> contactLengths(const Solved& solved) {
  std::map<std::string, double> lengths;
  const ContactFields fields(solved);
  for (const Element& element : fields.elements())
    lengths[nameOf(element)] += solved.units.length *
                                solved.space.mesh()[element.element].half *
                                closedPart(fields, element);
  return lengths;
}

namespace {

/// The forces of multipliers on the bodies that they meet, where they act on them.
void addReactions(const std::vector<Solved>& bodies, std::vector<Summary>& summaries) {
  const ContactBody& any = bodies.front().problem;
  const bem::Units units = bodies.front().units;
  forEachSidePoint(
      any.multiplier(), any.opposite(),
      [&](const Element& element, const Opposite::Point& middle) {
        return middle.element >= 0 ? &ruleOfForces(element, middle) : nullptr;
      },
      [&](const SidePoint& point) {
        const Opposite::Point& there = point.opposite;
        if (there.element < 0)
          return;
        const auto value =
            any.multiplier().at(bodies.front().state.multiplier, point.contact, point.t);
        const double weight = units.force() * point.weight;
        const Vec2 force = weight * (value.normal * point.normal.unit +
                                     value.tangential * point.tangent.unit);
        const Vec2 place =
            any.multiplier().mesh(at(there.body)).physicalPoint(there.element, there.t);
        const double turned =
            weight * units.length * value.normal * point.normal.oppositeTurn;
        add(around(units, {force.x, force.y, cross(place, force) - turned}),
            summaries[at(there.body)].contact);
      });
}

}  // namespace

std::vector<Summary> summarizeAll(const std::vector<Solved>& bodies) {
  std::vector<Summary> summaries;
  summaries.reserve(bodies.size());
  for (const Solved& solved : bodies)
    summaries.push_back(summarize(solved));
  if (!bodies.front().problem.opposite().isStill())
    addReactions(bodies, summaries);
  return summaries;
}

Summary sumOf(const std::vector<Summary>& bodies) {
  if (bodies.size() == 1)
    return bodies.front();
  Summary sum;
  for (const Summary& body : bodies) {
    for (const auto member :
         {&Summary::energyStrain, &Summary::energyLoad, &Summary::forceNormal,
          &Summary::forceTangential, &Summary::contactLength,
          &Summary::contactLengthError, &Summary::slipLength, &Summary::wornVolume})
      sum.*member += body.*member;
    for (const auto member :
         {&Summary::load, &Summary::inside, &Summary::reaction, &Summary::obstacle})
      add(body.*member, sum.*member);
    sum.peak.add(body.peak);
  }
  sum.contact = sum.obstacle;
  return sum;
}

Index freeDisplacements(const bem::Space& space, const Conditions& conditions) {
  const std::vector<char> isPrescribed = prescribed(space, conditions);
  return std::count(isPrescribed.begin(), isPrescribed.end(), 0);
}

}  // namespace epafi::contact
