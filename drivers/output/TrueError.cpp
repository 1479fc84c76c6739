#include "drivers/output/TrueError.hpp"

#include "bem/base/Error.hpp"
#include "bem/operators/EnergyNorm.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "bem/space/CauchyData.hpp"
#include "contact/opposite/Numbering.hpp"
#include "drivers/output/Restart.hpp"
#include "drivers/output/SolutionFile.hpp"
#include "drivers/run/BodySpaces.hpp"
#include "drivers/scene/SceneReader.hpp"
#include "drivers/scene/Text.hpp"

#include <algorithm>
#include <array>
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

/// The solution of all bodies at one time.
struct Snapshot {
  double t = 1;
  std::vector<BodySnapshot> bodies;
  double dissipated = 0;  ///< work of friction up to t on a path [stress length²]
};

/// On a path every requested step, else one state.
using Snapshots = std::vector<Snapshot>;

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
      square +=
          rule.weights[q] * std::norm(bem::evaluate(level.multiplier[a.element],
                                                    own.degree, a.middle + a.scale * t) -
                                      bem::evaluate(reference.multiplier[b.element], p,
                                                    b.middle + b.scale * t));
    }
    sum += 2 * own.half / own.degree * both.mesh[e].half * square;
  }
  return sum;
}

/// Displacement, density and multiplier of a body as functions.
BodySnapshot bodySnapshot(const BodySpaces& spaces, std::size_t b,
                          const bem::Vector& displacement, const bem::Vector& density,
                          const bem::Vector& multiplier) {
  const bem::Space& space = spaces.space(b);
  const contact::MultiplierSpace& own = spaces.multiplier(b);
  const std::size_t elements = space.mesh().size();
  BodySnapshot body{bem::makeCauchyData(space, displacement, density),
                    std::vector<Series>(elements), std::vector<bool>(elements)};
  for (const auto& element : own.elements()) {
    body.contact[element.element] = true;
    body.multiplier[element.element] = bem::project(
        [&](double t) {
          const auto value = own.at(multiplier, element, t);
          return bem::Complex(value.normal, value.tangential);
        },
        element.degree);
  }
  return body;
}

/// The state of the path at a requested time, of all bodies together.
const contact::State& stateAt(const Level& level, double t) {
  for (const PathPoint& point : level.path)
    if (point.t == t)
      return point.state;
  throw bem::NumericalError(
      bem::message("the path has no state at t = ", t, ", which it was asked for"));
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
Snapshots takeSnapshots(const Scene& scene, const Level& level,
                        const std::vector<double>& dissipated) {
  const BodySpaces spaces(scene, level);
  const contact::Numbering numbering(spaces.sides());
  Snapshots result;
  for (const StepFields& step : level.steps) {
    Snapshot& snapshot = result.emplace_back();
    const contact::State* all = nullptr;
    if (level.onPath()) {
      all = &stateAt(level, step.t);
      snapshot.t = step.t;
      snapshot.dissipated = dissipated.at(result.size() - 1);
    }
    for (std::size_t b = 0; b < spaces.size(); ++b) {
      bem::Vector own = level.last().own[b].multiplier;
      for (std::size_t i = 0; i < own.size() && all != nullptr; ++i)
        own[i] = all->multiplier[numbering(b, static_cast<bem::Index>(i))];
      snapshot.bodies.push_back(
          bodySnapshot(spaces, b, step.displacement[b], step.density[b], own));
    }
  }
  return result;
}

/// The reference solution of a scene.
struct Reference {
  Snapshots steps;
  double energy = 0;          ///< see energyOf, at the end [stress length²]
  double estimate = 0;        ///< estimated error [(stress length²)^½]
  std::vector<double> norms;  ///< energy norm of each step, dimensionless

  double largest() const { return *std::max_element(norms.begin(), norms.end()); }
};

/// Largest errors over the steps of a path.
struct PathError {
  double relative = 0;    ///< energy norm over the largest norm of all steps
  double multiplier = 0;  ///< the same for the multiplier
  double friction = 0;
  int step = 0;  ///< of `relative`, from 1
};

PathError pathError(const Snapshots& steps, const Reference& reference,
                    const Scene& scene) {
  const double largest = reference.largest();
  const double work = std::abs(reference.steps.back().dissipated);
  PathError error;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const Snapshot& step = steps[k];
    const auto other = std::find_if(
        reference.steps.begin(), reference.steps.end(),
        [&](const auto& s) { return std::abs(s.t - step.t) <= 1e-9 * step.t; });
    if (other == reference.steps.end())
      continue;
    const Distance distance = distanceOf(step, *other, scene);
    if (error.step == 0 || distance.norm / largest > error.relative) {
      error.relative = distance.norm / largest;
      error.step = static_cast<int>(k) + 1;
    }
    error.multiplier = std::max(error.multiplier, distance.multiplier / largest);
    if (work > 0)
      error.friction =
          std::max(error.friction, std::abs(step.dissipated - other->dissipated) / work);
  }
  return error;
}

constexpr std::array<const char*, 9> names{
    "error",          "error_multiplier", "error_energy",          "counted",
    "effectivity",    "error_path",       "error_path_multiplier", "error_path_friction",
    "error_path_step"};

/// In the order of the names.
std::vector<double> errorsOf(const SolvedLevel& level, const LevelRow& row,
                             const Reference& reference) {
  const Scene& scene = level.last().spaces.scene();
  std::vector<double> dissipated;
  for (const auto& step : level.steps)
    dissipated.push_back(step->row.energyDissipated);
  const Snapshots steps = takeSnapshots(scene, level.level, dissipated);
  const Distance last = distanceOf(steps.back(), reference.steps.back(), scene);
  const double norm = reference.norms.back();
  const PathError path = scene.history ? pathError(steps, reference, scene) : PathError();
  const double largest = path.step == 0 ? last.norm : path.relative * reference.largest();
  const double unit = std::sqrt(scene.energy());
  std::vector<double> errors{last.norm / norm, last.multiplier / norm,
                             std::abs(energyOf(cellsOf(row)) / reference.energy - 1),
                             largest * unit >= 10 * reference.estimate ? 1.0 : 0.0,
                             row.estimate / (last.norm * unit)};
  if (path.step > 0)
    errors.insert(errors.end(), {path.relative, path.multiplier, path.friction,
                                 static_cast<double>(path.step)});
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
      different = differenceIn(*a.used, *b.used, "", section, {"Mesh", "Cycle Jump"});
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
  if (!kept.level.complete)
    throw bem::InputError(what, "is of a path that was interrupted");
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
  reference.steps =
      takeSnapshots(of, kept.level, dissipatedOf(kept.steps, kept.level.number));
  reference.energy = energyOf(rowsOf(kept.history).back());
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

MoreColumns errorsAgainst(const std::string& file, const Scene& scene) {
  const auto reference = std::make_shared<const Reference>(
      within("--reference: ", [&] { return readReference(file, scene); }));
  return [reference](const SolvedLevel* level, const LevelRow& row) {
    std::vector<double> errors;
    // a path that broke off ends under other loads
    if (level != nullptr && (!level->level.onPath() || level->last().row.converged))
      errors = errorsOf(*level, row, *reference);
    CsvRow cells;
    for (const char* name : names)
      cells.emplace_back(
          name, cells.size() < errors.size() ? number(errors[cells.size()]) : "");
    return cells;
  };
}

}  // namespace epafi::drivers
