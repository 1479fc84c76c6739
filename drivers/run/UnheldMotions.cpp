#include "drivers/run/UnheldMotions.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "bem/space/DisplacementField.hpp"
#include "contact/body/Coupling.hpp"
#include "contact/body/Holding.hpp"
#include "contact/equation/Equilibrium.hpp"
#include "contact/system/LoadSize.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace epafi::drivers {

namespace {

using bem::Vector;

/// Takes from a vector what orthonormal ones have of it; twice, for rounding.
void orthogonalise(const std::vector<Vector>& basis, Vector& v) {
  for (int pass = 0; pass < 2; ++pass)
    for (const Vector& q : basis)
      bem::axpy(-bem::dot(q, v), q, v);
}

/// The free rigid motions of each elastic body, as displacements.
using FreeMotions = std::vector<std::vector<Vector>>;

FreeMotions motionsOf(const contact::ContactSystem& system) {
  FreeMotions motions(system.size());
  for (std::size_t b = 0; b < system.size(); ++b) {
    const contact::Holding& holding = system.body(b).holding();
    for (bem::Index k = holding.fixed(); k < holding.allowed.columns(); ++k)
      motions[b].push_back(bem::columnOf(holding.allowed, k));
  }
  return motions;
}

/// \throws bem::InputError naming a body of which a combination of the motions, a column each of
/// what they do to contact, leaves all contacts as they are.
void requireResistance(const Scene& scene, const bem::Matrix& motions,
                       const FreeMotions& free) {
  if (!scene.hasSeveral())
    return;
  constexpr double rounding = 1e-9;
  double largest = 0;
  for (bem::Index k = 0; k < motions.columns(); ++k) {
    const Vector column = bem::columnOf(motions, k);
    largest = std::max(largest, std::sqrt(bem::dot(column, column)));
  }
  std::vector<Vector> basis;
  const auto resist = [&](bem::Index k, const std::string& name, const char* advice) {
    Vector rest = bem::columnOf(motions, k);
    orthogonalise(basis, rest);
    const double size = std::sqrt(bem::dot(rest, rest));
    if (!(size > rounding * largest))
      throw bem::InputError(
          "Bodies->", name,
          ": can move as a rigid body, alone or with what it touches, in a "
          "way that nothing resists; ",
          advice);
    for (double& x : rest)
      x /= size;
    basis.push_back(std::move(rest));
  };
  bem::Index k = 0;
  std::vector<std::pair<std::size_t, bem::Index>> order;  // body, and its first column
  for (std::size_t b = 0; b < free.size(); k += static_cast<bem::Index>(free[b++].size()))
    order.emplace_back(b, k);
  // of bodies that move together the one with the fewest holds is named
  std::stable_sort(order.begin(), order.end(), [&](const auto& one, const auto& other) {
    return free[one.first].size() < free[other.first].size();
  });
  for (const auto& [b, column] : order)
    for (std::size_t own = 0; own < free[b].size(); ++own)
      resist(column + static_cast<bem::Index>(own), scene.bodies[b].name,
             "hold it by a Dirichlet condition, Rigid Motions->Fix, contact or friction");
  for (const RigidBody& body : scene.rigid)
    for (const RigidBody::Component& component : body.components)
      if (component.stiffness > 0)
        ++k;
      else if (component.free)
        resist(k++, body.name,
               "give it a Displacement or a Rotation instead of a Force or a Moment, or "
               "a Stiffness, contact or friction");
}

struct Moved {
  double size = 0;    ///< of the largest displacement, scaled
  std::string words;  ///< "drives Bodies->pad in the direction (0, 1)"
  double unit = 1;    ///< of force or moment: the displacement or the angle, scaled
  bool turns = false;
};

/// To three digits of a unit, zero without a sign.
double tidy(double x, double unit) {
  return std::round(1000 * x / unit) / 1000 * unit + 0.0;
}

std::string direction(bem::Vec2 u) {
  const double size = norm(u);
  return bem::message(" in the direction (", tidy(u.x / size, 1), ", ",
                      tidy(u.y / size, 1), ")");
}

/// Of a rigid displacement: U + θ e_z x (x - c), c the nodes' mean.
Moved movedBy(const Vector& u, const bem::Space& space, const Body& body) {
  const bem::Mesh& mesh = space.mesh();
  const bem::DisplacementField field(space, u);
  bem::Vec2 centre;
  bem::Vec2 mean;
  for (int e = 0; e < mesh.size(); ++e) {
    centre = centre + (1.0 / mesh.size()) * mesh.scaledPoint(e, -1);
    mean = mean + (1.0 / mesh.size()) * field.at(e, -1);
  }
  double turn = 0;
  double squares = 0;
  double farthest = 0;
  for (int e = 0; e < mesh.size(); ++e) {
    const bem::Vec2 arm = mesh.scaledPoint(e, -1) - centre;
    turn += cross(arm, field.at(e, -1) - mean);
    squares += dot(arm, arm);
    farthest = std::max(farthest, norm(arm));
  }
  turn /= squares;
  const double arc = std::abs(turn) * farthest;
  const bool turns = arc > 1e-3 * norm(mean);  // else about a point far away
  std::string how = direction(mean);
  if (turns) {
    const bem::Vec2 pole = body.outline->physical(centre + (1 / turn) * turnLeft(mean));
    const double length = body.outline->diameter();
    how = bem::message(" about (", tidy(pole.x, length), ", ", tidy(pole.y, length), ")");
  }
  return {norm(mean) + arc,
          (turns ? "turns Bodies->" : "drives Bodies->") + body.name + how,
          turns ? std::abs(turn) : norm(mean), turns};
}

Moved movedBy(const std::array<double, 3>& components, const RigidBody& body) {
  const bem::Vec2 slide{components[0], components[1]};
  const double turn = std::abs(components[2]);
  const bool turns = turn > 1e-3 * norm(slide);
  return {norm(slide) + turn,
          turns ? "turns Bodies->" + body.name
                : "drives Bodies->" + body.name + direction(slide),
          turns ? turn : norm(slide), turns};
}

std::string unresisted(const BodySpaces& spaces, const contact::Problem& numbers,
                       const FreeMotions& free) {
  const Scene& scene = spaces.scene();
  const contact::UnresistedMotion motion = contact::unresistedMotion(numbers);
  if (motion.amplitudes.empty())
    return "";
  Moved most;
  const auto keepLarger = [&](Moved moved) {
    if (moved.size > most.size)
      most = std::move(moved);
  };
  const double* next = motion.amplitudes.data();
  for (std::size_t b = 0; b < free.size(); ++b) {
    Vector moved(spaces.space(b).displacements());
    for (const Vector& one : free[b])
      bem::axpy(*next++, one, moved);
    keepLarger(movedBy(moved, spaces.space(b), scene.bodies[b]));
  }
  for (const RigidBody& body : scene.rigid) {
    std::array<double, 3> components{};
    for (std::size_t c = 0; c < 3; ++c)
      if (body.components[c].free)
        components[c] = *next++;
    keepLarger(movedBy(components, body));
  }
  std::string limit;
  if (motion.held > 0) {
    const double unit =
        scene.energy() / (most.turns ? 1 : scene.units().length) / most.unit;
    limit = bem::message(most.turns ? ": of a moment of " : ": of a force of ",
                         motion.load * unit, " they hold at most ", motion.held * unit);
  }
  return "the load " + most.words +
         ", a rigid motion in which neither contact nor friction can balance it" + limit;
}

/// What contact feels of free rigid motions and what loads do along them, the part of a contact
/// system that needs no operators.
struct FreeBalance {
  contact::Problem numbers;  ///< without D and d0
  FreeMotions free;
};

FreeBalance freeBalanceOf(const BodySpaces& spaces,
                          const std::vector<contact::Conditions>& conditions, double t) {
  const Scene& scene = spaces.scene();
  const contact::Obstacle obstacle = contact::makeObstacle(
      spaces.multiplier().under(conditions), spaces.opposite(), scene.units());
  const contact::MultiplierSpace& multiplier = obstacle.multiplier;
  const auto couplings =
      contact::makeCouplings(spaces.all(), multiplier, *obstacle.opposite);
  const contact::RigidDrives drives(scene.drivesAt(t), multiplier, *obstacle.opposite);
  FreeBalance balance{{}, FreeMotions(spaces.size())};
  contact::Problem& numbers = balance.numbers;
  numbers.normals = multiplier.normals();
  numbers.tangentials = obstacle.tangentials;
  numbers.surface = obstacle.surface;
  std::vector<Vector> columns;
  Vector given = obstacle.given();
  drives.addGiven(given);
  double ofBodies = 0;
  double moved = bem::largestEntry(given);
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    const contact::Loads loads =
        contact::makeLoads(spaces.space(b), conditions[b], scene.units());
    const contact::Holding holding = contact::makeHolding(spaces.space(b), conditions[b]);
    ofBodies += loads.size();
    moved = std::max(moved, bem::largestEntry(loads.rigidPart));
    for (bem::Index k = holding.fixed(); k < holding.allowed.columns(); ++k) {
      balance.free[b].push_back(bem::columnOf(holding.allowed, k));
      numbers.rigidLoad.push_back(bem::dot(balance.free[b].back(), loads.load));
    }
    // rigid motions have no tractions
    const contact::TraceCoupling& trace = couplings[b].trace;
    if (!loads.rigidPart.empty())
      bem::axpy(1, trace.apply(loads.rigidPart), given);
    for (Vector& column : motionsOnContacts(holding, holding.fixed(), trace))
      columns.push_back(std::move(column));
  }
  drives.setMotions(std::move(columns), numbers);
  drives.addForces(numbers);
  const double size = contact::loadSize(numbers, given, contact::lengthsOf(multiplier),
                                        moved, ofBodies, drives);
  numbers.stress = size > 0 ? size : 1;
  return balance;
}

/// By how much the area of a body may grow.
struct Room {
  double area = 0;  ///< ∫ gap ds over contacts + ∫ u·n ds over clamps, ds scaled
  double size = 0;  ///< of the same, absolute values
  bool isLimited = true;   ///< by conditions all around
  bool isContact = false;  ///< at least on a part

  bool isKnown() const { return isLimited && isContact; }
  bool isMissing() const { return area < -1e-6 * size; }  // the rest is quadrature's
};

Room roomOf(const bem::Mesh& mesh, const contact::Conditions& conditions) {
  Room room;
  room.isLimited = conditions.inside == nullptr && !conditions.heat;
  const bem::Rule& rule = bem::gaussLegendre(8);
  for (int e = 0; e < mesh.size() && room.isLimited; ++e) {
    const auto clamp = conditions.dirichlet.find(mesh.boundary(e));
    const auto contact = conditions.contact.find(mesh.boundary(e));
    const bool meets = contact != conditions.contact.end();
    if (meets ? !contact->second.name.empty() || contact->second.normal ||
                    contact->second.wear
              : clamp == conditions.dirichlet.end())
      room.isLimited = false;
    else
      for (std::size_t q = 0; q < rule.points.size() && room.isLimited; ++q) {
        const bem::SurfacePoint x = mesh.physicalPoint(e, rule.points[q]);
        double outwards = meets && contact->second.gap ? contact->second.gap(x) : 0;
        if (!meets)
          for (const auto& [given, along] : {std::pair(&clamp->second.x, x.normal.x),
                                             std::pair(&clamp->second.y, x.normal.y)}) {
            if (*given)
              outwards += (*given)(x)*along;
            else if (std::abs(along) > 1e-12)
              room.isLimited = false;
          }
        const double share = rule.weights[q] * mesh.measure(e, rule.points[q]);
        room.area += share * outwards;
        room.size += share * std::abs(outwards);
        room.isContact = room.isContact || (meets && !contact->second.isSupport);
      }
  }
  return room;
}

}  // namespace

void checkResistance(const Scene& scene, const contact::ContactSystem& system) {
  requireResistance(scene, system.numbers().rigid, motionsOf(system));
}

std::string unresisted(const BodySpaces& spaces, const contact::ContactSystem& system) {
  return unresisted(spaces, system.numbers(), motionsOf(system));
}

std::vector<double> unbalanced(const BodySpaces& spaces,
                               const std::vector<double>& times) {
  bool mayMove = true;  // free motions are the same at all times
  const auto isBalanced = [&](double t) {
    if (!mayMove)
      return true;
    const contact::Problem numbers =
        freeBalanceOf(spaces, spaces.conditionsAt(t), t).numbers;
    mayMove = numbers.rigidMotions() > 0;
    return contact::unresistedMotion(numbers).amplitudes.empty();
  };
  std::vector<double> result;
  std::remove_copy_if(times.begin(), times.end(), std::back_inserter(result), isBalanced);
  return result;
}

void checkRoom(const BodySpaces& spaces, double t) {
  const Scene& scene = spaces.scene();
  const auto isIncompressible = [](const Body& body) {
    return body.material.poissonsRatio >= 0.5 && !body.material.planeStress;
  };
  if (std::none_of(scene.bodies.begin(), scene.bodies.end(), isIncompressible))
    return;
  const std::vector<contact::Conditions> conditions = scene.conditionsAt(t);
  for (std::size_t b = 0; b < spaces.size(); ++b)
    if (const Room room = roomOf(spaces.space(b).mesh(), conditions[b]);
        isIncompressible(scene.bodies[b]) && room.isKnown() && room.isMissing())
      throw bem::InputError(
          "Bodies->", scene.bodies[b].name,
          ": is incompressible (Poisson's Ratio 1/2) and enclosed: contact and "
          "prescribed "
          "displacements take ",
          -room.area * scene.symmetry.copies() * scene.units().length,
          scene.history ? bem::message(" at t = ", t) : "",
          " of its area, and it has none to give; leave it a free side or room, or take "
          "a smaller Poisson's Ratio");
}

void checkUnheld(const BodySpaces& spaces,
                 const std::vector<contact::Conditions>& conditions, double t) {
  const Scene& scene = spaces.scene();
  const FreeBalance balance = freeBalanceOf(spaces, conditions, t);
  requireResistance(scene, balance.numbers.rigid, balance.free);
  const std::string motion = unresisted(spaces, balance.numbers, balance.free);
  if (!motion.empty())
    throw bem::InputError(scene.history ? bem::message("at t = ", t, " ") : "", motion);
}

}  // namespace epafi::drivers
