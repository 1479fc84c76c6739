#include "drivers/output/Inside.hpp"

#include "bem/base/Parallel.hpp"
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

BodyInsides::BodyInsides(const Scene& scene, const Level& level)
    : scene_(scene), level_(level), spaces_(scene, meshesOf(scene, level)) {}

InsideValue BodyInsides::at(const InsidePoint& point) const {
  const auto& [body, x] = point;
  const bem::Material& material = scene_.bodies[body].material;
  const bem::Units units = scene_.units();
  const bem::InteriorValue field = bem::evaluateInterior(
      spaces_.space(body), scene_.lame(body), level_.bodies[body].displacement,
      level_.bodies[body].density, mesh(body).outline().scaled(x));
  InsideValue value;
  value.displacement = units.length * field.displacement;
  value.xx = units.stress * field.xx;
  value.yy = units.stress * field.yy;
  value.xy = units.stress * field.xy;
  value.zz = material.planeStress ? 0 : material.poissonsRatio * (value.xx + value.yy);
  const double a = value.xx - value.yy;
  const double b = value.yy - value.zz;
  const double c = value.zz - value.xx;
  value.vonMises = std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * value.xy * value.xy);
  const double radius = std::hypot(0.5 * a, value.xy);
  value.principal1 = 0.5 * (value.xx + value.yy) + radius;
  value.principal2 = 0.5 * (value.xx + value.yy) - radius;
  return value;
}

InsideValue BodyInsides::atBoundary(std::size_t b, int e, double t) const {
  const bem::Element& element = mesh(b)[e];
  const double place = std::clamp(t, -1 + end, 1 - end);
  const bem::Vec2 inward = -1 * element.curve.normal(place);
  const bem::Vec2 x = element.curve.point(place) + (skin * element.half) * inward;
  InsideValue value = at({b, mesh(b).outline().physical(x)});
  value.displacement = scene_.units().length * spaces_.space(b).displacementAt(
                                                   level_.bodies[b].displacement, e, t);
  return value;
}

double BodyInsides::workAtPoint(std::size_t b) const {
  constexpr double ofElement = 200;  // ns
  return ofElement * mesh(b).size();
}

std::vector<InsideValue> BodyInsides::at(const std::vector<InsidePoint>& points) const {
  std::vector<InsideValue> values(points.size());
  double work = 0;
  for (const InsidePoint& point : points)
    work += workAtPoint(point.body);
  bem::parallelFor({static_cast<bem::Index>(points.size()), work, 16},
                   [&](bem::Index k) { values[bem::at(k)] = at(points[bem::at(k)]); });
  return values;
}

std::string BodyInsides::csv(const std::vector<InsidePoint>& points,
                             const std::vector<InsideValue>& values) const {
  std::string csv = csvLine({"x", "y", "ux", "uy", "sxx", "syy", "sxy", "von_mises",
                             "body", "szz", "principal_1", "principal_2"});
  for (std::size_t i = 0; i < points.size(); ++i) {
    const InsideValue& v = values[i];
    csv += csvLine({exactly(points[i].x.x), exactly(points[i].x.y),
                    exactly(v.displacement.x), exactly(v.displacement.y), exactly(v.xx),
                    exactly(v.yy), exactly(v.xy), exactly(v.vonMises),
                    scene_.bodies[points[i].body].name, exactly(v.zz),
                    exactly(v.principal1), exactly(v.principal2)});
  }
  return csv;
}

}  // namespace epafi::drivers
