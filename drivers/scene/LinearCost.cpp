#include "drivers/scene/LinearCost.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::drivers {

namespace {

constexpr double mebi = 1024.0 * 1024.0;

/// Of Newton's steps with D's entries, for a step of the path.
double newtonSeconds(double multipliers) {
  return multipliers * multipliers * (3.5e-8 + 1.4e-11 * multipliers);
}

}  // namespace

int formedUpTo(int steps) { return std::min(500 * (1 + steps), 3000); }

Cost denseCost(const std::vector<BodySize>& bodies, int steps, int processes) {
  double seconds = 0;
  double bytes = 0;
  double all = 0;
  for (const BodySize& body : bodies) {
    const double u = body.displacements;
    const double d = body.densities;
    const double m = body.multipliers;
    seconds +=
        (d * d * (d / 3 + u) + u * u * (d + u / 3) + u * m * (u + 3 * m) + m * m * m) /
            42e9 +
        2e-8 * u * d;
    bytes += 8 * (3.85 * u * d + 2.4 * m * m) + 13000 * body.elements;
    all += m;
  }
  seconds += steps * newtonSeconds(all);
  return {seconds, processes * (programMemory + bytes / mebi)};
}

Cost compressedCost(const std::vector<BodySize>& bodies, int steps, int processes) {
  double seconds = 0;
  double bytes = 0;
  double all = 0;
  for (const BodySize& body : bodies) {
    const double unknowns = body.displacements + body.densities;
    const double halvings = std::log2(std::max(body.grading, 1.0));
    seconds += 9e-5 * (1 + 0.01 * halvings) * unknowns + 2.7e-3 * body.met;
    bytes += 14e3 * (1 + 0.13 * halvings) * unknowns + 36e3 * body.multipliers +
             6e5 * body.met + 450.0 * (steps - 1) * unknowns +
             3e3 * (processes - 1) * unknowns;
    all += body.multipliers;
  }
  seconds += all <= formedUpTo(steps) ? 2.7e-7 * all * all + steps * newtonSeconds(all)
                                      : 3.1e-4 * steps * all;
  return {seconds, processes * programMemory + bytes / mebi};
}

}  // namespace epafi::drivers
