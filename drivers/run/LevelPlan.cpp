#include "drivers/run/LevelPlan.hpp"

#include "bem/base/Error.hpp"
#include "contact/compressed/CompressedStiffness.hpp"
#include "drivers/process/Resources.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi::drivers {

namespace {

// Largest over smallest element.  Pressures of compressed levels agree with dense ones to 9e-6
// of the largest with edges of 1e-6 of a side, to 8e-4 with edges of 1e-8: see decision 52.
constexpr double mostGraded = 1e6;

// Square of the diameter over the area: displacements of compressed levels agree with dense ones to
// 1e-10 of the largest up to here, to 2e-9 on beams of 1 : 50, to 2e-8 on 1 : 100, to 1e-6 on 1 : 300:
// bending multiplies what the compression leaves out.
constexpr double mostSlender = 16;
constexpr const char* fewerDigits =
    "a body is slender, and its displacements lose digits by compressed operators; "
    "Solver->Linear->Method = Dense keeps them, Compression Tolerance = 1e-13 most";

// The part of what an earlier level found free that a later one takes without looking anew:
// what systems tell costs a tenth of a millisecond.
constexpr double plentiful = 0.1;

bool isSlender(const Body& body) {
  double area = 0;
  for (const bem::Edge& edge : body.outline->edges())
    for (const double t : {-1.0, -0.5, 0.0, 0.5}) {
      const bem::Vec2 a = edge.curve.point(t);
      const bem::Vec2 b = edge.curve.point(t + 0.5);
      area += 0.5 * (a.x * b.y - a.y * b.x);
    }
  const double diameter = body.outline->diameter() / body.outline->scaling().length;
  return diameter * diameter > mostSlender * area;
}

/// What a body brings to a level.
struct BodySize {
  double displacements = 0;
  double densities = 0;
  double multipliers = 0;
  double elements = 0;
  double grading = 1;   ///< largest over smallest element
  double opposite = 0;  ///< normal multipliers that act on another body, too
  double heat = 0;      ///< temperatures and fluxes where it conducts

  double unknowns() const { return displacements + densities; }
};

// Memory of a process without matrices [MiB].
constexpr double programMemory = 47;

constexpr double mebi = 1024.0 * 1024.0;

/// Peak with dense matrices [MiB]: K with its transpose, V and S in halves, traction rows, D and
/// what is made on the way (decision 16).  Every process has all of it.
double denseMemory(const std::vector<BodySize>& sizes, int processes) {
  double bytes = 0;
  for (const BodySize& b : sizes)
    bytes +=
        8 * (3.85 * b.displacements * b.densities + 2.4 * b.multipliers * b.multipliers) +
        13000 * b.elements;
  return processes * (programMemory + bytes / mebi);
}

/// Peak with compressed operators [MiB]: skeletons, larger on graded meshes and where bodies
/// meet, what a step of a path keeps for its results, the top of the tree on every process.
///                                                          [doc/benchmarks/compression.md]
double compressedMemory(const std::vector<BodySize>& sizes, int steps, int processes) {
  double bytes = 0;
  for (const BodySize& b : sizes)
    bytes += (9.2e3 * (1 + 0.13 * std::log2(std::max(b.grading, 1.0))) +
              450.0 * (steps - 1) + 3e3 * (processes - 1)) *
                 b.unknowns() +
             23e3 * b.multipliers + 9.2e4 * b.opposite;
  return processes * programMemory + bytes / mebi;
}

/// What conduction keeps beside either [MiB]: a compressed system, around an axis a dense one and its
/// factor.
double heatMemory(const std::vector<BodySize>& sizes, bool isDense, int processes) {
  double bytes = 0;
  for (const BodySize& b : sizes)
    bytes += b.heat * (isDense ? 16 * b.heat : 6e3);
  return processes * bytes / mebi;
}

/// What dense matrices cost, the cubes of the bodies' unknowns, over what compressed operators
/// do, their number and thirty times that of normal multipliers between bodies, which stay in
/// skeletons.  1 at 3100 unknowns of one body, at some 7300 of two that meet.
double gainOf(const std::vector<BodySize>& sizes) {
  constexpr double asMany = 3100;
  double dense = 0;
  double compressed = 0;
  for (const BodySize& b : sizes) {
    dense += b.unknowns() * b.unknowns() * b.unknowns();
    compressed += asMany * asMany * (b.unknowns() + 30 * b.opposite);
  }
  return dense / compressed;
}

std::vector<BodySize> sizesOf(const BodySpaces& spaces) {
  std::vector<BodySize> sizes;
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    const bem::Space& space = spaces.space(b);
    const std::vector<bem::Index>& columns = spaces.multiplier().columns(b);
    const auto& elements = space.mesh().elements();
    double smallest = std::numeric_limits<double>::infinity();
    double largest = 0;
    for (const bem::Element& element : elements)
      if (element.densities > 0) {  // none on an axis of revolution
        smallest = std::min(smallest, element.half);
        largest = std::max(largest, element.half);
      }
    BodySize& size = sizes.emplace_back();
    size.displacements = static_cast<double>(space.displacements());
    size.densities = static_cast<double>(space.densities());
    size.multipliers = static_cast<double>(columns.size());
    size.elements = static_cast<double>(elements.size());
    if (spaces.scene().bodies[b].conditions.heat)
      size.heat = 0.5 * size.unknowns();
    size.grading = largest / smallest;
    if (spaces.opposite()->meetsDeformable(b))
      size.opposite =
          static_cast<double>(std::lower_bound(columns.begin(), columns.end(),
                                               spaces.multiplier().normals()) -
                              columns.begin());
  }
  return sizes;
}

/// Maximum Memory, or what is free; what this process holds now is in a forecast, too.
double allowedMemory(const Scene& scene, const Ranks& ranks) {
  const bem::Processes& processes = ranks.processes();
  const double free =
      processes.broadcast({freeMemory() + ownMemory() * processes.count()}).front();
  return scene.adaptivity.limits.memory.value_or(free);
}

/// What compressed operators would save in place of dense ones.
std::string advised(double gain, bool isAutomatic, bool isPossible, double compressed,
                    double dense) {
  std::string with;
  if (!isAutomatic || gain <= 1)
    with =
        bem::message("Solver->Linear->Method = ", gain > 1 ? "Automatic" : "Compressed");
  if (!isPossible)
    with += std::string(with.empty() ? "" : " and ") +
            "Discretization->Stabilization->Form = Density";
  return bem::message("with ", with, " operators could be compressed: about ",
                      std::ceil(compressed), " in place of ", std::ceil(dense), " MiB");
}

}  // namespace

int formedUpTo(int steps) { return std::min(500 * (1 + steps), 3000); }

LevelRow planOf(const BodySpaces& spaces, const Ranks& ranks, double allowedBefore) {
  using Operators = LinearMethod::Operators;
  const Scene& scene = spaces.scene();
  const Operators wanted = linearMethods().at(scene.solver.linear.method).operators;
  const int processes = ranks.processes().count();
  const std::vector<BodySize> sizes = sizesOf(spaces);
  const bool isThin = std::any_of(scene.bodies.begin(), scene.bodies.end(), isSlender);
  const bool isGraded = std::any_of(sizes.begin(), sizes.end(), [](const BodySize& b) {
    return b.grading > mostGraded;
  });
  const double heat = heatMemory(sizes, scene.isAxisymmetric, processes);
  const double dense = denseMemory(sizes, processes) + heat;
  const double less =
      compressedMemory(sizes, scene.history.times.size(), processes) + heat;
  LevelRow row = spaces.levelRow();
  row.memoryAllowed = std::max(dense, less) < plentiful * allowedBefore
                          ? allowedBefore
                          : allowedMemory(scene, ranks);
  const double gain = isThin || isGraded ? 0 : gainOf(sizes);
  const bool isAutomatic = wanted == Operators::Cheaper;
  const bool isPossible = contact::whyNotCompressed(scene.stabilization).empty();
  const bool denseFits = dense <= row.memoryAllowed;
  if (wanted == Operators::Compressed || (isAutomatic && isPossible && gain > 1)) {
    row.operators = "compressed";
    row.memoryForecast = less;
    if (isThin)
      row.note = fewerDigits;
    if (isAutomatic && denseFits)
      row.memoryOfDense = dense;
    return row;
  }
  constexpr double worthTelling = 2;
  row.memoryForecast = dense;
  if (less < dense && (gain > worthTelling || !denseFits))
    row.note = advised(gain, isAutomatic, isPossible, less, dense);
  return row;
}

namespace {

// Unless the first mesh has more than half of them.
constexpr long usualCap = 4000;

}  // namespace

long capOf(const Scene& scene) {
  if (const auto& limit = scene.adaptivity.limits.degreesOfFreedom)
    return static_cast<long>(*limit);
  const long first = BodySpaces(scene, firstMeshes(scene)).levelRow().dof();
  return std::max(usualCap, 2 * first);
}

std::string aboveCap(int level, const LevelRow& size, const Scene& scene) {
  const auto& limit = scene.adaptivity.limits.degreesOfFreedom;
  if (size.dof() <= (limit ? static_cast<long>(*limit) : usualCap))
    return "";
  const long cap = capOf(scene);
  if (size.dof() <= cap)
    return "";
  std::string text =
      bem::message("level ", level, " would have ", size.dof(),
                   " degrees of freedom; Adaptivity->Maximum Degrees of Freedom = ", cap);
  if (level == 0)
    throw bem::InputError(scene.file, ": ", text, " does not allow a single level");
  return text;
}

std::string tooLarge(int level, const LevelRow& planned, const BodySpaces& spaces,
                     const Ranks& ranks) {
  const Scene& scene = spaces.scene();
  const std::optional<double>& limit = scene.adaptivity.limits.memory;
  const double memory = planned.memoryForecast;
  const double allowed = planned.memoryAllowed;
  if (memory <= allowed)
    return "";
  const double program = programMemory * ranks.processes().count();
  const double share = std::max((allowed - program) / (memory - program), 0.0);
  // matrices grow with the square
  const long cap = static_cast<long>((planned.isCompressed() ? share : std::sqrt(share)) *
                                     static_cast<double>(planned.dof()));
  const std::string text = bem::message(
      "level ", level, " with ", planned.dof(), " degrees of freedom would take about ",
      std::ceil(memory), " MiB; ",
      limit ? "Adaptivity->Maximum Memory = " : "MiB that are free: ",
      std::floor(allowed), limit ? "" : " (Adaptivity->Maximum Memory overrules them)",
      "; ", planned.note, planned.note.empty() ? "" : "; ", "about ", cap,
      " degrees of freedom fit: ");
  if (level == 0)
    throw bem::InputError(text + "make the first mesh coarser");
  return text + "set Adaptivity->Maximum Degrees of Freedom";
}

}  // namespace epafi::drivers
