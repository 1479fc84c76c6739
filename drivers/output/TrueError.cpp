#include "drivers/output/TrueError.hpp"

#include "bem/base/Error.hpp"
#include "bem/operators/EnergyNorm.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "bem/space/CauchyData.hpp"
#include "drivers/output/Restart.hpp"
#include "drivers/output/SolutionFile.hpp"
#include "drivers/run/BodySpaces.hpp"
#include "drivers/scene/SceneReader.hpp"
#include "drivers/scene/Text.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <regex>
#include <utility>

namespace epafi::drivers {

namespace {

using Series = bem::LegendreSeries<bem::Complex>;

/// The solution of a body as functions on its boundary.  Dimensionless; remains valid after the
/// operators of the level are deleted.
struct BodySnapshot {
  bem::CauchyData data;
  /// λₙ + i λₜ on each element; zero without contact.
  std::vector<Series> multiplier;
  std::vector<bool> contact;  ///< of each element
};

/// The solution of all bodies at one time: in a step of a path, else under the load.
struct Snapshot {
  double t = 1;
  std::vector<BodySnapshot> bodies;
  double dissipated = 0;  ///< work of friction up to t on a path [stress length²]
};

/// Σ h/p ‖λ - λ_ref‖² over the contact elements of the level, h/d for h.
double multiplierDistance(const BodySnapshot& level, const BodySnapshot& reference) {
  const bem::UnionMesh both = bem::unite(level.data.mesh, reference.data.mesh);
  double sum = 0;
  for (int e = 0; e < both.mesh.size(); ++e) {
    const bem::Origin& a = both.first[e];
    const bem::Origin& b = both.second[e];
    if (!level.contact[a.element])
      continue;
    const bem::Element& own = level.data.mesh[a.element];
    const int p = reference.data.mesh[b.element].degree;
    const bem::Rule& rule = bem::gaussLegendre(std::max(own.degree, p) + 1);
    double square = 0;
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
      const double t = rule.points[q];
      square += rule.weights[q] * (both.mesh.measure(e, t) / both.mesh[e].half) *
                std::norm(bem::evaluate(level.multiplier[a.element], own.degree,
                                        a.middle + a.scale * t) -
                          bem::evaluate(reference.multiplier[b.element], p,
                                        b.middle + b.scale * t));
    }
    sum += 2 * own.half / own.degree * both.mesh[e].half * square;
  }
  return sum;
}

/// Displacement, density and multiplier of a body as functions.
BodySnapshot bodySnapshot(const BodySpaces& spaces, std::size_t b,
                          const SolvedState& step) {
  const bem::Space& space = spaces.space(b);
  const contact::MultiplierSpace& multiplier = spaces.multiplier();
  const std::size_t elements = space.mesh().size();
  BodySnapshot body{bem::makeCauchyData(space, step.displacement[b], step.density[b]),
                    std::vector<Series>(elements), std::vector<bool>(elements)};
  for (const auto& element : multiplier.elements(b)) {
    body.contact[element.element] = true;
    body.multiplier[element.element] = bem::project(
        [&](double t) {
          const auto value = multiplier.at(step.state.multiplier, element, t);
          return bem::Complex(value.normal, value.tangential);
        },
        element.degree);
  }
  return body;
}

/// Distance at one time, dimensionless.
struct Distance {
  double norm = 0;
  double multiplier = 0;
};

Distance distanceOf(const Snapshot& level, const Snapshot& reference,
                    const Scene& scene) {
  Distance distance;
  double squares = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const bem::Lame lame = scene.lame(b);
    const BodySnapshot& own = level.bodies[b];
    const BodySnapshot& other = reference.bodies[b];
    distance.norm = std::hypot(
        distance.norm, bem::energyNorm(bem::difference(own.data, other.data), lame));
    squares += multiplierDistance(own, other) / lame.mu;
  }
  distance.multiplier = std::sqrt(squares);
  return distance;
}

/// \param dissipated  of each requested step
std::vector<Snapshot> takeSnapshots(const Scene& scene, const Level& level,
                                    const std::vector<double>& dissipated) {
  const BodySpaces spaces(scene, level);
  std::vector<Snapshot> result;
  for (const SolvedState& step : level.steps) {
    Snapshot& snapshot = result.emplace_back();
    if (level.onPath()) {
      snapshot.t = step.t;
      snapshot.dissipated = dissipated.at(result.size() - 1);
    }
    for (std::size_t b = 0; b < spaces.size(); ++b)
      snapshot.bodies.push_back(bodySnapshot(spaces, b, step));
  }
  return result;
}

/// The reference solution of a scene.
struct Reference {
  std::vector<Snapshot> steps;
  double energy = 0;          ///< see energyOf, at the end [stress length²]
  double estimate = 0;        ///< estimated error [(stress length²)^½]
  std::vector<double> norms;  ///< energy norm of each step, dimensionless

  double largest() const { return *std::max_element(norms.begin(), norms.end()); }
  /// The step at the time of another one; null if there is none.
  const Snapshot* at(double t) const {
    for (const Snapshot& step : steps)
      if (std::abs(step.t - t) <= 1e-9 * t)
        return &step;
    return nullptr;
  }
};

/// In the order of the columns.
std::vector<double> errorsOf(const SolvedLevel& level, const LevelRow& row,
                             const Reference& reference) {
  const Scene& scene = level.last().spaces.scene();
  Table history;
  history.add(cellsOf(row));
  std::vector<double> dissipated;
  for (const auto& step : level.steps)
    dissipated.push_back(step->row.energyDissipated);
  const std::vector<Snapshot> steps = takeSnapshots(scene, level.level, dissipated);
  // the largest of a path
  const double work = std::abs(reference.steps.back().dissipated);
  Distance farthest;
  double friction = 0;
  std::size_t worst = 0;  // from 1
  for (std::size_t k = 0; scene.history && k < steps.size(); ++k) {
    const Snapshot* other = reference.at(steps[k].t);
    if (other == nullptr)
      continue;
    const Distance distance = distanceOf(steps[k], *other, scene);
    if (worst == 0 || distance.norm > farthest.norm) {
      farthest.norm = distance.norm;
      worst = k + 1;
    }
    farthest.multiplier = std::max(farthest.multiplier, distance.multiplier);
    if (work > 0)
      friction =
          std::max(friction, std::abs(steps[k].dissipated - other->dissipated) / work);
  }
  const Distance last = distanceOf(steps.back(), reference.steps.back(), scene);
  const double norm = reference.norms.back();
  const double unit = std::sqrt(scene.energy());
  std::vector<double> errors{
      last.norm / norm, last.multiplier / norm,
      std::abs(energyOf(history, 0) / reference.energy - 1),
      (worst == 0 ? last : farthest).norm * unit >= 10 * reference.estimate ? 1.0 : 0.0,
      row.estimate / (last.norm * unit)};
  if (worst > 0)
    errors.insert(errors.end(), {farthest.norm / reference.largest(),
                                 farthest.multiplier / reference.largest(), friction,
                                 static_cast<double>(worst)});
  return errors;
}

/// Of all bodies, in the user's coordinates.
std::vector<bem::Vec2> corners(const Scene& scene) {
  std::vector<bem::Vec2> result;
  for (const Body& body : scene.bodies)
    for (const bem::Edge& edge : body.outline->edges())
      result.push_back(edge.start);
  return result;
}

/// Is there a text in a list that names a constant?
bool mentions(const Teuchos::ParameterList& list, const std::string& constant) {
  return std::any_of(list.begin(), list.end(), [&](const auto& item) {
    const Teuchos::ParameterEntry& entry = item.second;
    if (entry.isList())
      return mentions(list.sublist(item.first), constant);
    if (!entry.template isType<std::string>())
      return false;
    return std::regex_search(list.get<std::string>(item.first),
                             std::regex("\\b" + constant + "\\b"));
  });
}

/// The first difference between two scenes that is one of their problems; meshes, methods and
/// steps may differ.
std::string differentProblem(const Scene& a, const Scene& b) {
  std::string different;
  for (const char* section : {"Bodies", "Geometry", "Body Loads", "Contacts", "Tables"}) {
    if (different.empty())
      different =
          difference(*a.used, *b.used, "", {section}, {"Mesh", "Cycle Jump", "Between"});
    for (const auto& [constant, value] : a.constants)
      if (const auto other = b.constants.find(constant);
          different.empty() && other != b.constants.end() && other->second != value &&
          a.used->isSublist(section) && mentions(a.used->sublist(section), constant))
        different = "Constants->" + constant;
  }
  return different;
}

Reference readReference(const std::string& file, const Scene& scene) {
  const Checkpoint kept = readSolution(file);
  const Scene of = sceneOf(kept.used, file, {});
  const std::string what = bem::message("'", file, "' ");
  if (of.history && !kept.level.isSolved())
    throw bem::InputError(what, "is of a path that was interrupted or broke off");
  if (of.bodies.size() != scene.bodies.size() || corners(of) != corners(scene))
    throw bem::InputError(what, "was written by a run of other bodies than the scene's");
  if (of.endOfPath() != scene.endOfPath())
    throw bem::InputError(what, "ends at t = ", of.endOfPath(), ", the scene at ",
                          scene.endOfPath(),
                          "; errors compare solutions under the same loads");
  if (const std::string different = differentProblem(of, scene); !different.empty())
    throw bem::InputError(what, "was written by a run of another problem: ", different,
                          " differs; errors compare solutions of one problem");
  Reference reference;
  within(what, [&] { checkLevel(kept.level, of); });
  const std::vector<double> work = dissipatedOf(kept.steps, kept.level.number);
  if (of.history && work.size() != kept.level.steps.size())
    throw bem::InputError(what, "has not one row of steps.csv per step");
  reference.steps = takeSnapshots(of, kept.level, work);
  reference.energy = energyOf(kept.history, kept.history.rows() - 1);
  reference.estimate = kept.level.estimate();
  for (const Snapshot& step : reference.steps) {
    double norm = 0;
    for (std::size_t b = 0; b < step.bodies.size(); ++b)
      norm = std::hypot(norm, bem::energyNorm(step.bodies[b].data, of.lame(b)));
    reference.norms.push_back(norm);
  }
  return reference;
}

}  // namespace

Cells errorColumns() {
  return {
      {"error", "",
       "with `--reference`: true relative errors against it: in the energy norm, of the "
       "contact stress, of the energy",
       "1"},
      {"error_multiplier", ""},
      {"error_energy", ""},
      {"counted", "",
       "likewise: 1 if the error, on a path the largest of all steps, is at least ten "
       "times "
       "the reference's estimate"},
      {"effectivity", "", "likewise: estimate over true error", "1"},
      {"error_path", "",
       "likewise, on a path: the largest error of all steps in the energy norm, and of "
       "the "
       "contact stress, over the largest norm of all steps",
       "1"},
      {"error_path_multiplier", ""},
      {"error_path_friction", "",
       "likewise: the largest error over all steps of friction's work so far, over the "
       "reference's total friction work",
       "1"},
      {"error_path_step", "", "likewise: the step of `error_path`"},
  };
}

MoreColumns errorsAgainst(const std::string& file, const Scene& scene) {
  const auto reference = std::make_shared<const Reference>(
      within("--reference: ", [&] { return readReference(file, scene); }));
  return [reference](const SolvedLevel* level, const LevelRow& row) {
    std::vector<double> errors;
    // a path that broke off ends under other loads
    if (level != nullptr && (!level->level.onPath() || level->last().row.converged))
      errors = errorsOf(*level, row, *reference);
    Cells cells = errorColumns();
    for (std::size_t k = 0; k < errors.size(); ++k)
      cells[k].value = errors[k];
    return cells;
  };
}

}  // namespace epafi::drivers
