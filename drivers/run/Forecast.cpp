#include "drivers/run/Forecast.hpp"

#include "bem/base/Error.hpp"
#include "drivers/process/Memory.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::drivers {

namespace {

constexpr double mebi = 1024.0 * 1024.0;
constexpr double program = 47;  ///< MiB of a process without matrices

}  // namespace

double forecastMemory(const BodySpaces& spaces, int processes) {
  double bytes = 0;
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    const auto u = static_cast<double>(spaces.space(b).displacements());
    const auto d = static_cast<double>(spaces.space(b).densities());
    const auto m = static_cast<double>(spaces.multiplier(b).size());
    bytes += 8 * (3.85 * u * d + 2.4 * m * m) + 13000.0 * spaces.space(b).mesh().size();
  }
  return processes * program + bytes / mebi;
}

double forecastCompressedMemory(const BodySpaces& spaces, int processes) {
  const double each = 24000.0 + 3000.0 * (processes - 1);
  double bytes = 0;
  for (std::size_t b = 0; b < spaces.size(); ++b)
    bytes += each * static_cast<double>(spaces.space(b).displacements() +
                                        spaces.space(b).densities());
  return processes * program + bytes / mebi;
}

std::optional<std::string> tooLarge(int level, const Size& size, double forecast,
                                    const std::optional<double>& limit,
                                    const Ranks& ranks) {
  const bem::DenseAlgebra& algebra = ranks.algebra();
  // what this process holds now is in the forecast, too
  const double free =
      algebra.broadcast({freeMemory() + ownMemory() * algebra.processes()}).front();
  const double allowed = limit.value_or(free);
  if (forecast <= allowed)
    return std::nullopt;
  // matrices grow with the square
  const double share = (allowed - program * algebra.processes()) /
                       (forecast - program * algebra.processes());
  const long cap = static_cast<long>(std::sqrt(std::max(share, 0.0)) *
                                     static_cast<double>(size.dof()));
  const std::string text = bem::message(
      "level ", level, " with ", size.dof(), " degrees of freedom would take about ",
      std::ceil(forecast), " MiB; ",
      limit ? "Adaptivity->Maximum Memory = " : "MiB that are free: ",
      std::floor(allowed), limit ? "" : " (Adaptivity->Maximum Memory overrules them)",
      "; about ", cap, " degrees of freedom fit: ");
  if (level == 0)
    throw bem::InputError(text + "make the first mesh coarser");
  return text + "set Adaptivity->Maximum Degrees of Freedom";
}

}  // namespace epafi::drivers
