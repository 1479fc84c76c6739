#pragma once

#include "bem/mesh/Mesh.hpp"
#include "bem/quadrature/Gauss.hpp"

namespace epafi::bem {

/// How accurately pairs of elements E and F are integrated: which are near, and how many
/// Gauss points far ones take on each of the two, for 1e-12 of the moments' norm.
///
///   n = smoothOrder(z) + degreeShare(degree)                  [doc/theory/operators.md]
///
/// Orders without the second part, which is added where points are taken.
struct FarOrder {
  int outer = 0;  ///< on E
  int inner = 0;  ///< on F
};

/// The largest smoothOrder.
constexpr int largestSmoothOrder = 48;

/// Gauss points that polynomials of a degree cost on top of what the kernel needs.
constexpr int degreeShare(int degree) { return (degree + 2) / 2 + 1; }

/// The largest degree that moments are taken with: densities may have one function more
/// than displacements have degrees.
constexpr int largestMoment = largestDegree + 1;

static_assert(largestSmoothOrder + degreeShare(largestMoment) <= largestGaussOrder);

/// Gauss points on an element, without what polynomials cost, the other one outside the
/// ellipse about the element whose sum of focal distances is z lengths.
int smoothOrder(double z);

/// The same on an element that turns by an angle (0: a segment), the other one at this distance
/// [half lengths] from its middle or farther.  Grows with the angle.
int farOrder(double angle, double distance);

/// True when a pair is near: the gap is below half the larger length.  Otherwise sets the
/// orders, separately for the two elements.  `w`: Mesh::offset of E and F.  Which of the two is E
/// makes no difference.
bool isNear(const Mesh& mesh, int e, int f, Vec2 w, FarOrder& order);

/// From this z on (in half lengths) circles around elements are far as they are, without a
/// look at each, and from this order on what they need.
constexpr double zOfCircles = 4;
constexpr int smoothOrderOfCircles = 7;

}  // namespace epafi::bem
