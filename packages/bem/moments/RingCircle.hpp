#pragma once

#include <cmath>

namespace epafi::bem {

/// A circle in the half plane of a meridian: all of it, or the arc from the axis to the axis.
struct RingCircle {
  double middle;  ///< distance of the middle from the axis
  double radius;

  /// The largest angle of a point, from the direction away from the axis.
  double end() const {
    constexpr double pi = 3.14159265358979323846;
    return middle < radius ? std::acos(-middle / radius) : pi;
  }
  /// The k-th of so many points at equal distances, none on the axis.
  double angle(int k, int points) const { return end() * (2 * k + 1 - points) / points; }
};

}  // namespace epafi::bem
