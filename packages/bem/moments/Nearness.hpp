#pragma once

#include "bem/mesh/Mesh.hpp"
#include "bem/quadrature/Gauss.hpp"

#include <algorithm>

namespace epafi::bem {

/// Are two elements E and F near, that is, the gap less than half the larger length?  If not, the
/// number of Gauss points on each of them for an error of 1e-12 of the norm of the moments:
///
///   n = smoothOrder(z) + degreeShare(degree)                  [doc/theory/operators.md]
///
/// A Nearness contains the first term only.
struct Nearness {
  int outer = 0;  ///< on E; 0: the pair is near
  int inner = 0;  ///< on F
  bool isFar() const { return outer > 0; }
  /// Takes as many points as another pair needs, if these are more.
  void include(const Nearness& other) {
    outer = std::max(outer, other.outer);
    inner = std::max(inner, other.inner);
  }
};

/// Symmetric in E and F.  \param w Mesh::offset(e, f)
Nearness nearness(const Mesh& mesh, int e, int f, Vec2 w);

/// The largest smoothOrder.
constexpr int largestSmoothOrder = 48;

/// Additional Gauss points for polynomials of a degree.
constexpr int degreeShare(int degree) { return (degree + 2) / 2 + 1; }

/// The largest degree of moments: densities may have one term more than the degree of the
/// displacements.
constexpr int largestMoment = largestDegree + 1;

static_assert(largestSmoothOrder + degreeShare(largestMoment) <= largestGaussOrder);

/// Gauss points on an element for the kernel, if the other element is outside the ellipse
/// around this one whose sum of focal distances is z lengths.
int smoothOrder(double z);

/// Gauss points for the kernel on an element that turns by `angle` (0: a segment), if the other
/// one is at least `distance` [half lengths] from its midpoint.  Grows with the angle.
int farOrder(double angle, double distance);

/// From this distance z (in half lengths) on, all elements in a circle are far, and this order
/// suffices for them.
constexpr double zOfCircles = 4;
constexpr int smoothOrderOfCircles = 7;

}  // namespace epafi::bem
