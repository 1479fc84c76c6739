#include "drivers/run/UnheldMotions.hpp"

#include "bem/algebra/LeastSquares.hpp"
#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"
#include "contact/body/Coupling.hpp"
#include "contact/body/Holding.hpp"
#include "contact/equation/Equilibrium.hpp"
#include "contact/system/LoadSize.hpp"
#include "drivers/run/FreeMotions.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::drivers {

namespace {

using bem::Vector;

FreeMotions motionsOf(const contact::ContactSystem& system) {
  FreeMotions motions(system.size());
  for (std::size_t b = 0; b < system.size(); ++b) {
    const contact::Holding& holding = system.body(b).holding();
    for (bem::Index k = holding.fixed(); k < holding.allowed.columns(); ++k)
      motions[b].push_back(bem::columnOf(holding.allowed, k));
  }
  return motions;
}

/// Tells motions that do nothing to contact from what they do, a column each.
class Resistance {
 public:
  explicit Resistance(const bem::Matrix& motions) : motions_(motions) {
    for (bem::Index k = 0; k < motions.columns(); ++k) {
      const Vector column = bem::columnOf(motions, k);
      largest_ = std::max(largest_, std::sqrt(bem::dot(column, column)));
    }
  }

  /// Amplitudes of motion k and of those that were added before, which together leave all contacts as
  /// they are; empty if there are none: then motion k is added.
  Vector unresisted(bem::Index k) {
    constexpr double rounding = 1e-9;
    Vector rest = bem::columnOf(motions_, k);
    Vector amplitudes(bem::at(motions_.columns()), 0.0);
    amplitudes[bem::at(k)] = 1;
    for (int pass = 0; pass < 2; ++pass)  // twice, for rounding
      for (const auto& [basis, of] : added_) {
        const double part = -bem::dot(basis, rest);
        bem::axpy(part, basis, rest);
        bem::axpy(part, of, amplitudes);
      }
    const double size = std::sqrt(bem::dot(rest, rest));
    if (!(size > rounding * largest_))
      return amplitudes;
    for (Vector* vector : {&rest, &amplitudes})
      for (double& x : *vector)
        x /= size;
    added_.emplace_back(std::move(rest), std::move(amplitudes));
    return {};
  }

 private:
  const bem::Matrix& motions_;
  double largest_ = 0;
  std::vector<std::pair<Vector, Vector>> added_{};  ///< orthonormal, and amplitudes
};

/// Is each motion far from all combinations of others?  By less than asking for one after the other.
bool areIndependent(const bem::Matrix& motions) {
  constexpr double far = 1e-12;  // of squares; what is nearer is looked at
  bem::Matrix gram = bem::transposedProduct(motions, motions);
  double all = 0;
  for (bem::Index k = 0; k < gram.columns(); ++k)
    all += gram(k, k);
  for (bem::Index k = 0; k < gram.columns(); ++k)
    gram(k, k) -= far * all;
  return bem::cholesky(gram) == 0;
}

/// \throws bem::InputError naming a body and a motion of it that, with motions of others, leaves all
/// contacts as they are
void requireResistance(const BodySpaces& spaces, const bem::Matrix& motions,
                       const FreeMotions& free) {
  const Scene& scene = spaces.scene();
  if (!scene.hasSeveral() || areIndependent(motions))
    return;
  Resistance resistance(motions);
  const auto resist = [&](bem::Index k, std::size_t body, const char* advice) {
    const Vector amplitudes = resistance.unresisted(k);
    if (amplitudes.empty())
      return;
    const Moved moved = movedBy(amplitudes, spaces, free)[body];
    throw bem::InputError("Bodies->", moved.body, ": can ", moved.turns ? "turn" : "move",
                          " as a rigid body", moved.how,
                          ", alone or with what it touches, in a way that nothing "
                          "resists; ",
                          advice);
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
      resist(column + static_cast<bem::Index>(own), b,
             "hold it by a Dirichlet condition, Rigid Motions->Fix, contact or friction");
  for (std::size_t r = 0; r < scene.rigid.size(); ++r)
    for (const RigidBody::Component& component : scene.rigid[r].components)
      if (component.stiffness > 0)
        ++k;
      else if (component.free)
        resist(k++, free.size() + r,
               "give it a Displacement or a Rotation instead of a Force or a Moment, or "
               "a Stiffness, contact or friction");
}

/// What slides on flat ground: along n, out of the body, the load presses, along t it shears.
struct Slide {
  bem::Vec2 normal{};
  double friction = -1;  ///< of all its contacts; < 0: they differ, or there are none
};

/// The sides of an elastic body in contact, if they all face one way and have one coefficient of
/// friction.
Slide groundOf(const BodySpaces& spaces,
               const std::vector<contact::Conditions>& conditions, std::size_t body) {
  constexpr double same = 1e-9;
  const double stress = spaces.scene().units().stress;
  Slide slide;
  bool isOne = true;
  spaces.multiplier().under(conditions).forEachElement([&](const auto& element) {
    const contact::Opposite::Point there = spaces.opposite()->at(element, 0);
    const bool isOwn = bem::at(element.body) == body;
    if (!isOwn && (there.element < 0 || bem::at(there.body) != body))
      return;
    const bem::Vec2 normal = (isOwn ? 1 : -1) * there.direction.unit;
    const contact::PointLaw law = element.condition->friction.at(
        element.mesh->physicalPoint(element.element, 0), stress);
    const double friction = law.bound(1);
    if (slide.friction < 0)
      slide = {normal, friction};
    isOne = isOne && !element.ties() && !element.condition->isSupport &&
            law.bound(0) == 0 &&
            !(element.shears() && element.condition->friction.law->knowsPlace()) &&
            norm(normal - slide.normal) < same &&
            std::abs(friction - slide.friction) <= same * friction;
  });
  return isOne ? slide : Slide{};
}

/// The force of a load on a body whose three motions are free, by what it does along them.
bem::Vec2 forceAlong(const Vector& loads, const std::vector<Vector>& motions,
                     const bem::Space& space) {
  std::vector<Vector> rows;
  for (const Vector& motion : motions) {
    const RigidPart part = rigidPart(motion, space);
    rows.push_back({part.mean.x, part.mean.y, part.turn});
  }
  const auto along = [&](const Vector& translation) {
    return bem::dot(bem::leastSquares(rows, translation, 1e-12).x, loads);
  };
  return {along({1, 0, 0}), along({0, 1, 0})};
}

std::string unresisted(const BodySpaces& spaces,
                       const std::vector<contact::Conditions>& conditions,
                       const contact::Problem& numbers, const FreeMotions& free) {
  const Scene& scene = spaces.scene();
  const contact::UnresistedMotion motion = contact::unresistedMotion(numbers);
  if (motion.amplitudes.empty())
    return "";
  std::size_t body = 0;
  const std::vector<Moved> all = movedBy(motion.amplitudes, spaces, free);
  for (std::size_t b = 1; b < all.size(); ++b)
    if (all[b].size > all[body].size)
      body = b;
  const Moved& most = all[body];
  std::string limit;
  if (motion.held > 0) {
    const double unit =
        scene.energy() / (most.turns ? 1 : scene.units().length) / most.unit;
    limit = bem::message(most.turns ? ": of a moment of " : ": of a force of ",
                         motion.load * unit, " they hold at most ", motion.held * unit);
  }
  std::string words =
      (most.turns ? " turns Bodies->" : " drives Bodies->") + most.body + most.how;
  if (body < free.size() && free[body].size() == 3 && !most.turns && motion.held == 0)
    if (const Slide slide = groundOf(spaces, conditions, body); slide.friction >= 0) {
      const double* first = numbers.rigidLoad.data();
      for (std::size_t b = 0; b < body; ++b)
        first += free[b].size();
      const bem::Vec2 force =
          forceAlong({first, first + 3}, free[body], spaces.space(body));
      const double pressing = dot(force, slide.normal);
      const double along = dot(force, turnLeft(slide.normal));
      const double unit = scene.energy() / scene.units().length;
      if (pressing > 0 && std::abs(along) > slide.friction * pressing) {
        words =
            " slides Bodies->" + most.body + direction(along * turnLeft(slide.normal));
        limit = bem::message(": ", tidy(std::abs(along) * unit, pressing * unit), " > ",
                             slide.friction, " x ", pressing * unit);
      }
    }
  return "the load" + words +
         ", a rigid motion in which neither contact nor friction can balance it" + limit;
}

/// What contact feels of free rigid motions and what loads do along them, the part of a contact
/// system that needs no operators.  Refers to the spaces.
class FreeBalance {
 public:
  /// \param conditions  at any time, by body, of which the kinds count
  FreeBalance(const BodySpaces& spaces,
              const std::vector<contact::Conditions>& conditions, double t)
      : spaces_(spaces),
        couplings_(contact::makeCouplings(spaces.all(), spaces.multiplier(),
                                          *spaces.opposite())),
        drives_(spaces.scene().drivesAt(t), spaces.multiplier(), *spaces.opposite()),
        free_(spaces.size()) {
    for (std::size_t b = 0; b < spaces.size(); ++b) {
      const contact::Holding holding =
          contact::makeHolding(spaces.space(b), conditions[b]);
      for (bem::Index k = holding.fixed(); k < holding.allowed.columns(); ++k)
        free_[b].push_back(bem::columnOf(holding.allowed, k));
      // rigid motions have no tractions
      for (Vector& column :
           motionsOnContacts(holding, holding.fixed(), couplings_[b].trace))
        columns_.push_back(std::move(column));
    }
  }

  const FreeMotions& free() const { return free_; }
  /// Is anything free?  At all times or never.
  bool hasFree() const { return !columns_.empty() || drives_.freeMotions() > 0; }

  /// Without D and d0.
  contact::Problem at(const std::vector<contact::Conditions>& conditions,
                      double t) const {
    const Scene& scene = spaces_.scene();
    const contact::Obstacle obstacle = contact::makeObstacle(
        spaces_.multiplier().under(conditions), spaces_.opposite(), scene.units());
    const contact::RigidDrives drives = drives_.under(scene.drivesAt(t));
    contact::Problem numbers;
    numbers.normals = obstacle.multiplier.normals();
    numbers.tangentials = obstacle.tangentials;
    numbers.surface = obstacle.surface;
    Vector given = obstacle.given();
    drives.addGiven(given);
    double ofBodies = 0;
    double moved = bem::largestEntry(given);
    for (std::size_t b = 0; b < spaces_.size(); ++b) {
      const contact::Loads loads =
          contact::makeLoads(spaces_.space(b), conditions[b], scene.units());
      ofBodies += loads.size();
      moved = std::max(moved, bem::largestEntry(loads.rigidPart));
      for (const Vector& motion : free_[b])
        numbers.rigidLoad.push_back(bem::dot(motion, loads.load));
      if (!loads.rigidPart.empty())
        bem::axpy(1, couplings_[b].trace.apply(loads.rigidPart), given);
    }
    drives.setMotions(columns_, numbers);
    drives.addForces(numbers);
    const double size = contact::loadSize(numbers, given, obstacle.multiplier.lengths(),
                                          moved, ofBodies, drives);
    numbers.stress = size > 0 ? size : 1;
    return numbers;
  }

 private:
  const BodySpaces& spaces_;
  std::vector<contact::Coupling> couplings_;
  contact::RigidDrives drives_;
  FreeMotions free_;
  std::vector<Vector> columns_;  ///< of G, of elastic bodies
};

}  // namespace

void checkResistance(const BodySpaces& spaces, const contact::ContactSystem& system) {
  requireResistance(spaces, system.numbers().rigid, motionsOf(system));
}

std::string unresisted(const BodySpaces& spaces, const contact::ContactSystem& system) {
  std::vector<contact::Conditions> conditions;
  for (std::size_t b = 0; b < system.size(); ++b)
    conditions.push_back(system.body(b).conditions());
  return unresisted(spaces, conditions, system.numbers(), motionsOf(system));
}

std::vector<double> unbalanced(const BodySpaces& spaces,
                               const std::vector<double>& times) {
  std::vector<double> result;
  const double any = times.front();
  const FreeBalance balance(spaces, spaces.scene().conditionsAt(any), any);
  for (const double t : times)
    if (balance.hasFree() &&
        !contact::unresistedMotion(balance.at(spaces.conditionsAt(t), t))
             .amplitudes.empty())
      result.push_back(t);
  return result;
}

void checkUnheld(const BodySpaces& spaces,
                 const std::vector<contact::Conditions>& conditions, double t) {
  const Scene& scene = spaces.scene();
  const FreeBalance balance(spaces, conditions, t);
  const contact::Problem numbers = balance.at(conditions, t);
  requireResistance(spaces, numbers.rigid, balance.free());
  const std::string motion = unresisted(spaces, conditions, numbers, balance.free());
  if (!motion.empty())
    throw bem::InputError(scene.history ? bem::message("at t = ", t, " ") : "", motion);
}

}  // namespace epafi::drivers
