#include "drivers/run/LevelPlan.hpp"

#include "bem/base/Error.hpp"
#include "contact/compressed/CompressedStiffness.hpp"
#include "drivers/process/Resources.hpp"
#include "drivers/scene/LinearCost.hpp"

#include <algorithm>
#include <cmath>

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

std::vector<BodySize> sizesOf(const BodySpaces& spaces) {
  std::vector<BodySize> sizes;
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    const bem::Space& space = spaces.space(b);
    double smallest = space.mesh()[0].half;
    double largest = smallest;
    for (const bem::Element& element : space.mesh().elements()) {
      smallest = std::min(smallest, element.half);
      largest = std::max(largest, element.half);
    }
    const contact::MultiplierSpace& multiplier = spaces.multiplier(b);
    const bool meetsElastic = !spaces.opposite(b)->bodies().empty();
    sizes.push_back({static_cast<double>(space.displacements()),
                     static_cast<double>(space.densities()),
                     static_cast<double>(multiplier.size()),
                     static_cast<double>(space.mesh().size()), largest / smallest,
                     meetsElastic ? static_cast<double>(multiplier.normals()) : 0});
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

/// A level both ways.
struct Forecast {
  Cost dense{};
  Cost compressed{};
  double allowed = 0;       ///< memory [MiB]
  bool isDelicate = false;  ///< compressed operators would lose digits

  bool denseFits() const { return dense.memory <= allowed; }
  /// Does it cost less to compress, in time by this factor?
  bool compresses(double gain) const {
    const bool compressedFits = compressed.memory <= allowed;
    if (denseFits() != compressedFits)
      return compressedFits;
    if (!denseFits())
      return compressed.memory < dense.memory;
    return !isDelicate && gain * compressed.seconds < dense.seconds;
  }
};

/// What compressed operators would save in place of dense ones that a scene asks for.
std::string advised(const Forecast& forecast, bool isAutomatic, bool isPossible) {
  constexpr double worthTelling = 2;
  if (!forecast.compresses(worthTelling))
    return "";
  return bem::message(
      "with ", isAutomatic ? "" : "Solver->Linear->Method = Automatic",
      isAutomatic || isPossible ? "" : " and ",
      isPossible ? "" : "Discretization->Stabilization->Form = Density",
      " operators could be compressed: about ",
      std::ceil(100 * forecast.compressed.seconds / forecast.dense.seconds),
      " % of the time and ", std::ceil(forecast.compressed.memory), " in place of ",
      std::ceil(forecast.dense.memory), " MiB");
}

}  // namespace

Plan planOf(const Scene& scene, const BodySpaces& spaces, const Ranks& ranks,
            double allowedBefore) {
  using Operators = LinearMethod::Operators;
  const Operators wanted = linearMethods().at(scene.linear.method).operators;
  const int processes = ranks.processes().count();
  const std::vector<BodySize> sizes = sizesOf(spaces);
  const int steps = scene.history.steps();
  const bool isThin = std::any_of(scene.bodies.begin(), scene.bodies.end(), isSlender);
  const bool isGraded = std::any_of(sizes.begin(), sizes.end(), [](const BodySize& b) {
    return b.grading > mostGraded;
  });
  Forecast forecast{denseCost(sizes, steps, processes),
                    compressedCost(sizes, steps, processes)};
  Plan compressed{true, forecast.compressed.memory, {}, isThin ? fewerDigits : ""};
  const double most = std::max(forecast.dense.memory, forecast.compressed.memory);
  compressed.allowed =
      most < plentiful * allowedBefore ? allowedBefore : allowedMemory(scene, ranks);
  if (wanted == Operators::Compressed)
    return compressed;

  forecast.allowed = compressed.allowed;
  forecast.isDelicate = isThin || isGraded;
  const bool isAutomatic = wanted == Operators::Cheaper;
  const bool isPossible = contact::whyNotCompressed(scene.stabilization).empty();
  if (isAutomatic && isPossible && forecast.compresses(1)) {
    if (forecast.denseFits())
      compressed.denseInstead = forecast.dense.memory;
    return compressed;
  }
  Plan dense{false, forecast.dense.memory};
  dense.allowed = forecast.allowed;
  if (!isAutomatic || !isPossible)
    dense.advice = advised(forecast, isAutomatic, isPossible);
  return dense;
}

std::optional<std::string> tooLarge(int level, const Size& size, const Plan& plan,
                                    const Scene& scene, const Ranks& ranks) {
  const std::optional<double>& limit = scene.adaptivity.limits.memory;
  if (plan.memory <= plan.allowed)
    return std::nullopt;
  const double program = programMemory * ranks.processes().count();
  const double share = std::max((plan.allowed - program) / (plan.memory - program), 0.0);
  // matrices grow with the square
  const long cap = static_cast<long>((plan.compressed ? share : std::sqrt(share)) *
                                     static_cast<double>(size.dof()));
  const std::string text = bem::message(
      "level ", level, " with ", size.dof(), " degrees of freedom would take about ",
      std::ceil(plan.memory), " MiB; ",
      limit ? "Adaptivity->Maximum Memory = " : "MiB that are free: ",
      std::floor(plan.allowed),
      limit ? "" : " (Adaptivity->Maximum Memory overrules them)", "; ", plan.advice,
      plan.advice.empty() ? "" : "; ", "about ", cap, " degrees of freedom fit: ");
  if (level == 0)
    throw bem::InputError(text + "make the first mesh coarser");
  return text + "set Adaptivity->Maximum Degrees of Freedom";
}

}  // namespace epafi::drivers
