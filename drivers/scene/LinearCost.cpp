#include "drivers/scene/LinearCost.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::drivers {

namespace {

constexpr double mebi = 1024.0 * 1024.0;

}  // namespace

Cost denseCost(const std::vector<BodySize>& bodies, int steps, int processes) {
  double seconds = 0;
  double bytes = 0;
  double all = 0;
  for (const BodySize& body : bodies) {
    const double u = body.displacements;
    const double d = body.densities;
    const double m = body.multipliers;
    seconds += (d * d * (d / 3 + u) + u * u * (d + u / 3) + u * m * (u + m)) / 34e9 +
               4e-8 * u * d;
    bytes += 8 * (3.85 * u * d + 2.4 * m * m) + 13000 * body.elements;
    all += m;
  }
  seconds += steps * all * all * (5e-8 + 2e-11 * all);
  return {seconds, processes * programMemory + bytes / mebi};
}

Cost compressedCost(const std::vector<BodySize>& bodies, int steps, int processes) {
  const bool meet = std::any_of(bodies.begin(), bodies.end(),
                                [](const BodySize& body) { return body.meetsElastic; });
  double seconds = 0;
  double bytes = 0;
  for (const BodySize& body : bodies) {
    const double unknowns = body.displacements + body.densities;
    const double halvings = std::log2(std::max(body.grading, 1.0));
    seconds += (meet ? 2e-4 : 1.3e-4) * (1 + 0.085 * halvings) * unknowns +
               (meet ? 1.3e-3 : 2.8e-4) * steps * body.multipliers;
    bytes += (meet ? 20e3 : 14e3) * (1 + 0.13 * halvings) * unknowns +
             (meet ? 180e3 : 36e3) * body.multipliers + 450.0 * (steps - 1) * unknowns +
             3e3 * (processes - 1) * unknowns;
  }
  return {seconds, processes * programMemory + bytes / mebi};
}

}  // namespace epafi::drivers
