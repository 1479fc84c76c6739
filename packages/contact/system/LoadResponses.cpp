#include "contact/system/LoadResponses.hpp"

#include "bem/algebra/SmallAlgebra.hpp"

#include <cmath>

namespace epafi::contact {

using bem::axpy;
using bem::dot;

Vector LoadResponses::of(const Vector& load, const std::function<Vector()>& solve) {
  constexpr std::size_t most = 3;
  constexpr double tolerance = 1e-14;
  constexpr double largestGrowth = 8;
  const double size = std::sqrt(dot(load, load));
  /// Of orthonormal loads: `growth` is the size of loads that one was combined from.
  struct Direction {
    Vector load;
    Vector response;
    double growth;
  };
  std::vector<Direction> directions;
  for (const Known& known : known_) {
    Direction next{known.load, known.response, std::sqrt(dot(known.load, known.load))};
    const double whole = next.growth;
    for (const Direction& other : directions) {
      const double part = dot(other.load, next.load);
      axpy(-part, other.load, next.load);
      axpy(-part, other.response, next.response);
      next.growth += std::abs(part) * other.growth;
    }
    const double left = std::sqrt(dot(next.load, next.load));
    if (!(left > tolerance * whole))
      continue;
    for (double& x : next.load)
      x /= left;
    for (double& x : next.response)
      x /= left;
    next.growth /= left;
    directions.push_back(std::move(next));
  }
  Vector rest = load;
  Vector response(known_.empty() ? 0 : known_.front().response.size(), 0.0);
  double growth = 0;
  for (const Direction& direction : directions) {
    const double part = dot(direction.load, rest);
    axpy(-part, direction.load, rest);
    axpy(part, direction.response, response);
    growth += std::abs(part) * direction.growth;
  }
  if (!directions.empty() && std::sqrt(dot(rest, rest)) <= tolerance * size &&
      growth <= largestGrowth * size)
    return response;
  response = solve();
  if (size > 0)
    known_.insert(known_.begin(), {load, response});
  if (known_.size() > most)
    known_.erase(known_.begin() + 1);
  return response;
}

}  // namespace epafi::contact
