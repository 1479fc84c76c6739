#include "drivers/output/Inside.hpp"

#include "bem/fields/Interior.hpp"
#include "drivers/output/Csv.hpp"

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

BodyInsides::BodyInsides(const Scene& scene, const Level& level)
    : scene_(scene), spaces_(scene, meshesOf(scene, level)) {
  insides_.reserve(spaces_.size());
  for (std::size_t b = 0; b < spaces_.size(); ++b)
    insides_.emplace_back(spaces_.space(b), scene.bodies[b].material, scene.units(),
                          level.bodies[b].displacement, level.bodies[b].density);
}

std::vector<InsideValue> BodyInsides::at(const std::vector<bem::Vec2>& points) const {
  std::vector<InsideValue> values(points.size());
  const auto n = static_cast<long>(points.size());
#pragma omp parallel for schedule(dynamic, 16)
  for (long k = 0; k < n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    values[i] = insides_[scene_.bodyAt(points[i])].at(points[i]);
  }
  return values;
}

std::string BodyInsides::csv(const std::vector<bem::Vec2>& points,
                             const std::vector<InsideValue>& values) const {
  Csv csv({"x", "y", "ux", "uy", "sxx", "syy", "sxy", "von_mises", "body", "szz",
           "principal_1", "principal_2"});
  for (std::size_t i = 0; i < points.size(); ++i) {
    const InsideValue& v = values[i];
    csv.row({exactly(points[i].x), exactly(points[i].y), exactly(v.displacement.x),
             exactly(v.displacement.y), exactly(v.xx), exactly(v.yy), exactly(v.xy),
             exactly(v.vonMises), scene_.bodies[scene_.bodyAt(points[i])].name,
             exactly(v.zz), exactly(v.principal1), exactly(v.principal2)});
  }
  return csv.text();
}

}  // namespace epafi::drivers
