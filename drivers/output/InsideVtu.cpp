#include "drivers/output/InsideVtu.hpp"

#include "bem/base/Parallel.hpp"
#include "drivers/output/Triangulation.hpp"
#include "drivers/output/VtkGrid.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace epafi::drivers {

namespace {

/// A point of the boundary: element and t in [-1, 1].
struct Foot {
  int element = 0;
  double t = 0;
};

Foot nearestFoot(const bem::Mesh& mesh, bem::Vec2 point) {
  const bem::Vec2 x = mesh.outline().scaled(point);
  Foot foot;
  double nearest = std::numeric_limits<double>::infinity();
  for (int e = 0; e < mesh.size(); ++e) {
    const bem::Complex z = mesh[e].curve.seen(x).z();
    const double over = std::max(0.0, std::abs(z.real()) - 1);
    const double distance = mesh[e].half * std::hypot(over, z.imag());
    if (distance < nearest) {
      nearest = distance;
      foot = {e, std::min(1.0, std::max(-1.0, z.real()))};
    }
  }
  return foot;
}

InsideValue mean(InsideValue a, InsideValue b) {
  for (const InsideField& field : insideFields)
    field.of(a) = 0.5 * (field.of(a) + field.of(b));
  return a;
}

InsideValue onBoundary(const BodyInsides& insides, const InsidePoint& point) {
  constexpr double node = 0.999;
  const bem::Mesh& mesh = insides.mesh(point.body);
  const Foot foot = nearestFoot(mesh, point.x);
  const InsideValue own = insides.atBoundary(point.body, foot.element, foot.t);
  if (foot.t > node)
    return mean(own, insides.atBoundary(point.body, mesh[foot.element].next, -1));
  if (foot.t < -node)
    return mean(own, insides.atBoundary(point.body, mesh[foot.element].previous, 1));
  return own;
}

}  // namespace

FilledBodies fill(const BodyInsides& insides) {
  FilledBodies all;
  for (std::size_t b = 0; b < insides.size(); ++b) {
    const Triangulation own = triangulate(insides.mesh(b));
    std::vector<InsidePoint> points;
    for (const bem::Vec2 x : own.points)
      points.push_back({b, x});
    std::vector<InsideValue> values(points.size());
    std::vector<std::size_t> boundary;
    std::vector<std::size_t> inside;
    for (std::size_t i = 0; i < points.size(); ++i)
      (own.onBoundary[i] || !insides.mesh(b).outline().contains(points[i].x) ? boundary
                                                                             : inside)
          .push_back(i);
    const auto n = static_cast<bem::Index>(boundary.size());
    bem::parallelFor({n, insides.workAtPoint(b) * static_cast<double>(n), 16},
                     [&](bem::Index k) {
                       values[boundary[bem::at(k)]] =
                           onBoundary(insides, points[boundary[bem::at(k)]]);
                     });
    std::vector<InsidePoint> places;
    for (const std::size_t i : inside)
      places.push_back(points[i]);
    const std::vector<InsideValue> there = insides.at(places);
    for (std::size_t k = 0; k < inside.size(); ++k)
      values[inside[k]] = there[k];
    const auto first = static_cast<int>(all.values.size());
    for (const auto& c : own.corners)
      all.corners.push_back({first + c[0], first + c[1], first + c[2]});
    all.points.insert(all.points.end(), points.begin(), points.end());
    all.values.insert(all.values.end(), values.begin(), values.end());
  }
  return all;
}

std::string vtuFile(const FilledBodies& bodies) {
  std::vector<double> places;
  std::vector<int> body;
  for (const auto& [b, x] : bodies.points) {
    places.insert(places.end(), {x.x, x.y, 0});
    body.push_back(static_cast<int>(b));
  }
  std::vector<double> displacements;
  std::array<std::vector<double>, std::size(insideFields)> fields;
  for (InsideValue value : bodies.values) {
    displacements.insert(displacements.end(),
                         {value.displacement.x, value.displacement.y, 0});
    for (std::size_t k = 0; k < fields.size(); ++k)
      fields[k].push_back(insideFields[k].of(value));
  }
  std::vector<VtkArray> arrays = {{"displacement", &displacements, 3}};
  for (std::size_t k = 0; k < fields.size(); ++k)
    arrays.push_back({insideFields[k].name, &fields[k]});
  arrays.push_back({"body", &body});
  std::vector<long long> corners;
  for (const auto& triangle : bodies.corners)
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  return vtuText(
      {places, corners, 3, R"(Scalars="von_mises" Vectors="displacement")", arrays});
}

std::vector<std::string> fieldNames() {
  std::vector<std::string> names;
  for (const InsideField& field : insideFields)
    names.emplace_back(field.name);
  return names;
}

}  // namespace epafi::drivers
