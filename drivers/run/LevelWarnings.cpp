#include "bem/base/Error.hpp"
#include "contact/results/ContactFields.hpp"
#include "drivers/run/NextLevel.hpp"
#include "drivers/run/Path.hpp"
#include "drivers/run/Warnings.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace epafi::drivers {

namespace {

using bem::message;

/// How far the sides of each contact slide where it is closed, over its length in contact.
void findSliding(const contact::Solved& solved, std::map<std::string, double>& shares) {
  const contact::ContactFields fields(solved);
  std::map<std::string, double> slides;
  for (const auto& element : fields.elements()) {
    const contact::ContactPoint point = fields.at(element, 0);
    if (point.closed)
      slides[nameOf(element)] =
          std::max(slides[nameOf(element)], std::abs(point.tangential));
  }
  const auto lengths = contact::contactLengths(solved);
  for (const auto& [name, slide] : slides) {
    const double length = lengths.at(name);
    shares[name] = std::max(shares[name], length > 0 ? slide / length : 0);
  }
}

/// The largest of each contact over the level or over the steps of its path.
std::map<std::string, double> slidingOf(const SolvedLevel& level) {
  std::map<std::string, double> shares;
  for (const auto& step : level.steps)
    for (const contact::Solved& solved : step->bodies)
      findSliding(solved, shares);
  return shares;
}

/// Contacts whose slip follows what they wear so much that more than one solution may exist: the
/// largest n k |λₜ| of each over the steps of the path, at most n k f p.
std::map<std::string, double> unsettledWear(const SolvedLevel& level) {
  std::map<std::string, double> rates;
  if (!level.level.onPath())
    return rates;
  for (const auto& step : level.steps)
    for (const contact::Solved& solved : step->bodies) {
      const contact::ContactFields fields(solved);
      for (const auto& element : fields.elements())
        if (element.condition->wear && element.tangential >= 0) {
          const contact::ContactPoint point = fields.at(element, 0);
          double& rate = rates[nameOf(element)];
          rate = std::max(rate, element.condition->cycles *
                                    element.condition->wear(point.place) * point.bound);
        }
    }
  return rates;
}

/// The largest displacement on a body's boundary, in its diameters.
double largestMotion(const contact::Solved& solved, const bem::Outline& outline) {
  double largest = 0;
  for (int e = 0; e < solved.space.mesh().size(); ++e)
    for (const double t : {-1.0, 0.0, 1.0})
      largest = std::max(largest, norm(solved.displacementAt(e, t)));
  return largest * solved.units.length / outline.diameter();
}

/// The same over the level or over the steps of its path.
double largestMotion(const SolvedLevel& level, std::size_t b) {
  double largest = 0;
  for (const auto& step : level.steps)
    largest = std::max(
        largest, largestMotion(step->bodies[b], *step->spaces.scene().bodies[b].outline));
  return largest;
}

/// The forces on a body that do not balance, over the largest of them; where all cancel, over
/// that which moves it by `motion` at its strain energy.  Zero but for rounding, see Summary; of
/// a body without strain beside what moves `around` all is rounding, and balance says nothing.
struct Imbalance {
  double missed = 0;
  double largest = 0;

  /// The larger of this and that of one more step.
  void add(const contact::Summary& body, double motion, double around,
           double youngsModulus) {
    // a beam of 1 : 10000 has 1e-13, rounding squared 1e-32
    constexpr double strained = 1e-24;
    if (body.energyStrain <= strained * youngsModulus * around * around)
      return;
    largest = std::max(largest, 2 * body.energyStrain / motion);
    bem::Vec2 sum;
    for (const auto* force : {&body.load, &body.inside, &body.contact, &body.reaction}) {
      sum = sum + bem::Vec2{force->x, force->y};
      largest = std::max({largest, std::abs(force->x), std::abs(force->y)});
    }
    missed = std::max(missed, norm(sum));
  }
};

/// Digits that rounding has taken, of bodies too slender for double precision, or of small
/// deformations beside large motions.
void findLostDigits(const SolvedLevel& level, std::vector<std::string>& warnings) {
  // of forces; a beam's bending is off by three hundred times as much
  constexpr double smallImbalance = 1e-7;
  constexpr double smallDefect = 1e-6;
  const char* const why =
      "rounding has taken these digits, as it does in bodies slender by more than 1 : "
      "1000, and where a motion is 1e10 times what deforms: look at units and loads";
  const Scene& scene = level.last().spaces.scene();
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    Imbalance imbalance;
    for (const auto& step : level.steps)
      imbalance.add(
          wholeOf(scene.symmetry, *body.outline, step->summaries()[b]),
          largestMotion(step->bodies[b], *body.outline) * body.outline->diameter(),
          scene.units().length * step->largestDisplacement(),
          body.material.youngsModulus);
    if (imbalance.missed > smallImbalance * imbalance.largest)
      warnings.push_back(
          message("Bodies->", body.name, ": its forces are out of balance by ",
                  imbalance.missed / imbalance.largest, " of the largest; ", why));
  }
  double missed = 0;
  double largest = 0;  // of a step without load displacements are rounding, too
  for (const auto& step : level.steps) {
    const double motion = step->largestDisplacement();
    missed = std::max(missed, step->at.defect * motion);
    largest = std::max(largest, motion);
  }
  if (missed > smallDefect * largest)
    warnings.push_back(message("contact is met up to ", missed / largest,
                               " of the displacements; ", why));
}

/// What steps as short as they may be do not tell to the tolerance.
void findErrorInTime(const SolvedLevel& level, std::vector<std::string>& warnings) {
  const StepRow& last = level.last().row;
  const double tolerance = level.last().spaces.scene().history.tolerance;
  const auto tell = [&](const char* what, double error) {
    // each section may take the tolerance of its own work or of its share of the path's
    if (tolerance > 0 && error > 2 * tolerance)
      warnings.push_back(
          message(what, " has an estimated error in time of ", error,
                  " of itself, more than History->Tolerance = ", tolerance,
                  ": a smaller History->Minimum Step, or more of History->Times"));
  };
  tell("friction's work",
       last.energyDissipatedError /
           std::max(last.energyDissipated, leastFriction * std::abs(last.energyOutside)));
  tell("the worn volume", last.wornVolumeError);
}

bool isDeformed(const SolvedStep& step) {
  return std::any_of(
      step.bodies.begin(), step.bodies.end(), [](const contact::Solved& solved) {
        return std::any_of(solved.displacement.begin(), solved.displacement.end(),
                           [](double u) { return u != 0; });
      });
}

/// Do sides overlap, by more than rounding, between the points that keep them apart?
bool isMissed(const Scene& scene, const Level& level) {
  adaptivity::Contributions squares = level.squares();
  return of(squares, adaptivity::Source::Penetration) > 1e-24 * scene.energy();
}

struct Extent {
  double energy = 0;
  double contact = 0;
};

/// The largest over the level or over the steps of its path.
Extent extentOf(const SolvedLevel& level) {
  const contact::Summary& summary = level.row.summary;
  Extent extent{summary.energyStrain, summary.contactLength};
  for (const auto& step : level.steps) {
    extent.energy = std::max(extent.energy, step->row.energyStrain);
    for (const auto& [name, contact] : step->row.contacts)
      extent.contact = std::max(extent.contact, contact.contactLength);
  }
  return extent;
}

}  // namespace

std::vector<std::string> warningsOf(const SolvedLevel& level) {
  const Scene& scene = level.last().spaces.scene();
  std::vector<std::string> warnings;
  const Extent extent = extentOf(level);
  if (extent.energy == 0) {
    warnings.emplace_back(
        isDeformed(level.last())
            ? "the strain energy is too small for a number: loads are next to nothing "
              "beside Young's modulus; look at the units of both"
            : "nothing loads the scene: no traction, force, prescribed displacement or "
              "overlap; all of it stays as it is");
    return warnings;
  }
  const bool isSolved = level.row.report.converged();
  if (isSolved && scene.hasContact() && extent.contact == 0)
    warnings.emplace_back(
        isMissed(scene, level.level)
            ? "contact closes between the points of the mesh alone (eta_penetration), "
              "where no force holds it: take a finer mesh, or Adaptivity->Tolerance"
            : "contact never closes: nothing presses a body onto what it could meet; "
              "look at the signs of loads (tractions pull along x and y), at the gap, "
              "and at a finer first mesh");
  if (isSolved)
    findLostDigits(level, warnings);
  if (isSolved)
    findErrorInTime(level, warnings);
  if (const std::string missing = missingTo(scene, level.level);
      isSolved && !missing.empty())
    warnings.push_back("a limit ends the run" + missing);
  constexpr double small = 0.1;
  for (const auto& [name, share] : slidingOf(level))
    if (share > small)
      warnings.push_back(message(
          "contact '", name, "': sliding reaches ", std::round(100 * share),
          " % of the length in contact; what meets what is looked for once, on the "
          "outlines as drawn (small sliding): stresses may belong elsewhere by as much"));
  constexpr double settled = 0.3;
  for (const auto& [name, rate] : unsettledWear(level))
    if (rate > settled)
      warnings.push_back(message(
          "contact '", name, "': Cycle Jump times Wear->Coefficient times the friction ",
          "bound reaches ", rate, ", above ", settled,
          ": slip and wear may have several ", "solutions; shorten steps or the jump"));
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const double motion = largestMotion(level, b);
    if (motion > small)
      warnings.push_back(
          message("Bodies->", scene.bodies[b].name, ": displacements reach ",
                  std::round(100 * motion),
                  " % of the body's size; the equations are those of small displacements "
                  "and small sliding, on the outline as drawn: look at units and loads"));
  }
  return warnings;
}

}  // namespace epafi::drivers
