#include "drivers/output/Inside.hpp"

#include "bem/fields/Interior.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::drivers {

namespace {

/// Depth of what stands for the boundary, in halves of the element.
constexpr double skin = 1e-3;
/// How near to an element's end, in halves of the element.
constexpr double end = 0.05;

}  // namespace

Inside::Inside(const bem::Space& space, const bem::Material& material,
               const bem::Units& units, const bem::Vector& displacement,
               const bem::Vector& density)
    : space_(space),
      material_(material),
      lame_(material, units.stress),
      units_(units),
      displacement_(displacement),
      density_(density) {}

InsideValue Inside::at(bem::Vec2 point) const {
  const bem::InteriorValue field = bem::evaluateInterior(
      space_, lame_, displacement_, density_, space_.mesh().outline().scaled(point));
  InsideValue value;
  value.displacement = units_.length * field.displacement;
  value.xx = units_.stress * field.xx;
  value.yy = units_.stress * field.yy;
  value.xy = units_.stress * field.xy;
  value.zz = material_.planeStress ? 0 : material_.poissonsRatio * (value.xx + value.yy);
  const double a = value.xx - value.yy;
  const double b = value.yy - value.zz;
  const double c = value.zz - value.xx;
  value.vonMises = std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * value.xy * value.xy);
  const double radius = std::hypot(0.5 * a, value.xy);
  value.principal1 = 0.5 * (value.xx + value.yy) + radius;
  value.principal2 = 0.5 * (value.xx + value.yy) - radius;
  return value;
}

InsideValue Inside::atBoundary(int e, double t) const {
  const bem::Mesh& mesh = space_.mesh();
  const bem::Element& element = mesh[e];
  const double place = std::clamp(t, -1 + end, 1 - end);
  const bem::Vec2 inward = -1 * element.curve.normal(place);
  const bem::Vec2 x = element.curve.point(place) + (skin * element.half) * inward;
  InsideValue value = at(mesh.outline().physical(x));
  value.displacement = units_.length * space_.displacementAt(displacement_, e, t);
  return value;
}

}  // namespace epafi::drivers
