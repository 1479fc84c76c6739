#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/results/Solved.hpp"
#include "drivers/run/LevelBalance.hpp"
#include "drivers/run/NextLevel.hpp"
#include "drivers/run/Path.hpp"
#include "drivers/run/Warnings.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace epafi::drivers {

namespace {

/// What is told of a contact, the largest over what is solved of the level or of the steps of its path.
struct Contact {
  double sliding = 0;  ///< where it is closed, over its length in contact
  double parting = 0;  ///< of Direction, times the slip where it is closed
  double slope = 0;    ///< largest angle between the sides where it is closed
  double apart = 0;    ///< by how much sliding convex sides part [length]
  /// n k |λₜ|, at most n k f p, of a path: the slip follows what it wears, and more than one
  /// solution may exist.
  double wearing = 0;
};

std::map<std::string, Contact> contactsOf(const SolvedLevel& level) {
  std::map<std::string, Contact> contacts;
  for (const auto& step : level.steps) {
    if (!step->row.converged)
      continue;
    for (const contact::Solved& solved : step->bodies) {
      const contact::ContactFields fields(solved);
      const auto lengths = contact::contactLengths(solved);
      for (const auto& element : fields.elements()) {
        const contact::ContactPoint point = fields.at(element, 0);
        const auto& condition = *element.condition;
        if (condition.isSupport)
          continue;
        Contact& contact = contacts[nameOf(element)];
        const double slip = std::abs(point.tangential);
        if (const double length = lengths.at(nameOf(element));
            point.closed && length > 0) {
          contact.sliding = std::max(contact.sliding, slip / length);
          const double parting = slip * point.direction.parting / solved.units.length;
          contact.parting = std::max(contact.parting, parting);
          contact.slope = std::max(contact.slope, std::abs(point.direction.angle));
          contact.apart = std::max(contact.apart, slip * parting / 2);
        }
        if (condition.wear && element.shears() && level.level.onPath())
          contact.wearing =
              std::max(contact.wearing,
                       condition.cycles * condition.wear(point.place) * point.bound);
      }
    }
  }
  return contacts;
}

/// The largest displacement on a body's boundary, in its diameters.
double largestMotion(const contact::Solved& solved, const bem::Outline& outline) {
  double largest = 0;
  for (int e = 0; e < solved.space.mesh().size(); ++e)
    for (const double t : {-1.0, 0.0, 1.0})
      largest = std::max(largest, norm(solved.displacementAt(e, t)));
  return largest * solved.units.length / outline.diameter();
}

/// The same over what is solved of the level or of the steps of its path.
double largestMotion(const SolvedLevel& level, std::size_t b) {
  double largest = 0;
  for (const auto& step : level.steps)
    if (step->row.converged)
      largest = std::max(largest, largestMotion(step->bodies[b],
                                                *step->spaces.scene().bodies[b].outline));
  return largest;
}

/// Digits that rounding has taken, of bodies too slender for double precision, or of small
/// deformations beside large motions.
void findLostDigits(const SolvedLevel& level, Warnings& warn) {
  // of forces; a beam's bending is off by three hundred times as much
  constexpr double smallImbalance = 1e-7;
  constexpr double smallDefect = 1e-6;
  const char* const why =
      "rounding has taken these digits, as it does in bodies slender by more than 1 : "
      "1000, and where a motion is 1e10 times what deforms: look at units and loads";
  const Scene& scene = level.last().spaces.scene();
  for (std::size_t b = 0; b < scene.bodies.size() + scene.rigid.size(); ++b) {
    double worst = 0;
    bool isRounding = true;
    for (const auto& step : level.steps)
      if (const contact::Imbalance& own = step->imbalances[b];
          own.size > worst * own.largest) {
        worst = own.size / own.largest;
        isRounding = own.isRounding();
      }
    if (worst > smallImbalance)
      warn("Bodies->", nameOf(level.last().imbalances[b], scene),
           ": its forces are out of balance by ", worst, " of the largest; ",
           isRounding ? why
                      : "the solver leaves these, relative to the load of the whole "
                        "scene: take a smaller Solver->Tolerance, or no far larger load "
                        "beside");
  }
  double missed = 0;
  double largest = 0;  // of a step without load displacements are rounding, too
  for (const auto& step : level.steps) {
    const double motion = step->largestDisplacement();
    missed = std::max(missed, step->at.defect * motion);
    largest = std::max(largest, motion);
  }
  if (missed > smallDefect * largest)
    warn("contact is met up to ", missed / largest, " of the displacements; ", why);
}

/// What steps as short as they may be do not tell to the tolerance.
void findErrorInTime(const SolvedLevel& level, Warnings& warn) {
  const StepRow& last = level.last().row;
  const double tolerance = level.last().spaces.scene().history.tolerance;
  const auto tell = [&](const char* what, double error) {
    // each section may take the tolerance of its own work or of its share of the path's
    if (tolerance > 0 && error > 2 * tolerance)
      warn(what, " has an estimated error in time of ", error,
           " of itself, more than History->Tolerance = ", tolerance,
           ": a smaller History->Minimum Step, or more of History->Times");
  };
  tell("friction's work",
       last.energyDissipatedError /
           std::max(last.energyDissipated, leastFriction * std::abs(last.energyOutside)));
  tell("the worn volume", last.wornVolumeError);
}

/// Do sides overlap, by more than rounding, between the points that keep them apart?
bool isMissed(const Scene& scene, const Level& level) {
  adaptivity::Contributions squares = level.squares();
  return of(squares, adaptivity::Source::Penetration) > 1e-24 * scene.energy();
}

/// Does contact close or slide where it may not, or motions go farther than the equations hold?
void findLarge(const SolvedLevel& level, Warnings& warn) {
  constexpr double small = 0.1;
  constexpr double settled = 0.3;
  const std::map<std::string, Contact> contacts = contactsOf(level);
  for (const auto& [name, contact] : contacts)
    if (contact.sliding > small)
      warn("contact '", name, "': sliding reaches ", std::round(100 * contact.sliding),
           " % of the length in contact; what meets what is looked for once, on the "
           "outlines as drawn (small sliding): stresses may belong elsewhere by as much");
  constexpr double ofSlope = 0.1;
  for (const auto& [name, contact] : contacts)
    if (contact.parting > ofSlope * contact.slope)
      warn("contact '", name, "': its convex sides part by about ", contact.apart,
           " as they slide, which the equations of small sliding leave out: they are "
           "pressed deeper into each other by as much");
  for (const auto& [name, contact] : contacts)
    if (contact.wearing > settled)
      warn("contact '", name, "': Cycle Jump times Wear->Coefficient times the friction ",
           "bound reaches ", contact.wearing, ", above ", settled,
           ": slip and wear may have several solutions; shorten steps or the jump");
  const std::vector<Body>& bodies = level.last().spaces.scene().bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const double motion = largestMotion(level, b);
    if (motion > small)
      warn("Bodies->", bodies[b].name, ": displacements reach ", std::round(100 * motion),
           " % of the body's size; the equations are those of small displacements and "
           "small sliding, on the outline as drawn: look at units and loads");
  }
}

/// Motions that Fix holds against loads that contact, which takes a part of them, could carry; what is
/// open at times needs Fix then.
void findSharedLoads(const SolvedLevel& level, Warnings& warn) {
  constexpr double small = 1e-3;
  const Scene& scene = level.last().spaces.scene();
  const auto isClamped = [](const contact::Conditions& conditions) {
    return !conditions.dirichlet.empty() ||
           std::any_of(conditions.contact.begin(), conditions.contact.end(),
                       [](const auto& each) { return each.second.isSupport; });
  };
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const contact::Conditions& conditions = scene.bodies[b].conditions;
    for (const auto& [axis, isFixed, component] :
         {std::tuple{'X', conditions.fix.x && !scene.isAxisymmetric,
                     &contact::Resultant::x},
          {'Y', conditions.fix.y, &contact::Resultant::y}}) {
      double held = 0;
      bool isOpen = false;
      for (const auto& step : level.steps) {
        double pressed = 0;
        for (const contact::Summary& summary : step->summaries())
          pressed = std::max(pressed, summary.forceNormal);
        isOpen = isOpen || pressed == 0;
        const contact::Summary& summary = step->summaries()[b];
        const double force = summary.reaction.*component;
        const double carried = std::abs(summary.contact.*component);
        if (isFixed && !isClamped(conditions) && std::abs(force) > std::abs(held) &&
            std::abs(force) > small * pressed && carried > small * std::abs(force))
          held = force;
      }
      if (held != 0 && !isOpen)
        warn("Bodies->", scene.bodies[b].name, "->Rigid Motions->Fix: ", axis,
             " takes a force of ", held,
             " beside what is in contact; unless a guide holds the body there, leave it "
             "out: without ",
             axis, " contact carries it, or nothing does");
    }
  }
}

/// "; Contacts->fit->Interference < 0 is a gap", of contacts that are drawn apart so.
std::string negativeInterferences(const Scene& scene) {
  std::string text;
  for (const Body& body : scene.bodies)
    for (const bem::Edge& edge : body.outline->edges()) {
      const auto found = body.conditions.contact.find(edge.boundary);
      if (found == body.conditions.contact.end() || found->second.name.empty() ||
          found->second.ties() || text.find(found->second.path) != std::string::npos)
        continue;
      const bem::Vec2 middle = body.outline->physical(edge.curve.point(0));
      if (found->second.gap({middle.x, middle.y, edge.curve.normal(0)}) > 0)
        text += "; " + found->second.path + "->Interference < 0 is a gap, > 0 an overlap";
    }
  return text;
}

}  // namespace

std::vector<std::string> warningsOf(const SolvedLevel& level) {
  constexpr double coarse = 0.1;
  const Scene& scene = level.last().spaces.scene();
  Warnings warn;
  double energy = level.row.summary.energyStrain;
  double contact = level.row.summary.contactLength;
  for (const auto& step : level.steps) {
    energy = std::max(energy, step->row.energyStrain);
    for (const auto& [name, summary] : step->row.contacts)
      contact = std::max(contact, summary.contactLength);
  }
  constexpr const char* neverCloses =
      "contact never closes: nothing presses a body onto what it could meet; look at the "
      "signs of loads (tractions pull along x and y) and motions, at the gap, and at a "
      "finer first mesh";
  if (energy == 0) {
    const contact::Configuration& at = level.last().at;
    const auto isIn = [](const auto& all, const auto& moves) {
      return std::any_of(all.begin(), all.end(), moves);
    };
    if (isIn(at.displacements,
             [](const bem::Vector& u) { return bem::largestEntry(u) > 0; }))
      warn(
          "the strain energy is too small for a number: loads are next to nothing beside "
          "Young's modulus; look at the units of both");
    else if (isIn(at.rigid, [](const contact::RigidMotion& m) {
               return norm(m.slide) > 0 || m.turn != 0;
             }))
      warn(neverCloses);
    else
      warn(
          "nothing loads the scene: no traction, force, prescribed displacement or "
          "overlap; all of it stays as it is",
          negativeInterferences(scene));
    return warn.all();
  }
  if (level.row.report.converged()) {
    if (scene.hasContact() && contact == 0)
      warn(isMissed(scene, level.level)
               ? "contact closes between the points of the mesh alone (eta_penetration), "
                 "where no force holds it: take a finer mesh, or Adaptivity->Tolerance"
               : neverCloses);
    findSharedLoads(level, warn);
    findLostDigits(level, warn);
    findErrorInTime(level, warn);
    if (const std::string missing = missingTo(scene, level.level); !missing.empty())
      warn("a limit ends the run", missing);
    else if (level.level.relativeEstimate > coarse &&
             !scene.adaptivity.limits.tolerance &&
             scene.adaptivity.estimator.weights != "Paper")
      warn("the estimated error is ", std::round(100 * level.level.relativeEstimate),
           " % of the energy norm: take a finer mesh, or Adaptivity->Tolerance = 0.01, "
           "which "
           "refines it");
  }
  findCutSides(level, warn);
  findLarge(level, warn);
  return warn.all();
}

}  // namespace epafi::drivers
