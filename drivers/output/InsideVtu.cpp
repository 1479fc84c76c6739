#include "drivers/output/InsideVtu.hpp"

#include "bem/base/Parallel.hpp"
#include "drivers/output/BoundaryVtk.hpp"
#include "drivers/output/Triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi::drivers {

namespace {

struct Field {
  const char* name;
  double (*of)(const InsideValue& value);
};

constexpr Field fields[] = {
    {"ux", [](const InsideValue& v) { return v.displacement.x; }},
    {"uy", [](const InsideValue& v) { return v.displacement.y; }},
    {"sxx", [](const InsideValue& v) { return v.xx; }},
    {"syy", [](const InsideValue& v) { return v.yy; }},
    {"sxy", [](const InsideValue& v) { return v.xy; }},
    {"szz", [](const InsideValue& v) { return v.zz; }},
    {"von_mises", [](const InsideValue& v) { return v.vonMises; }},
    {"principal_1", [](const InsideValue& v) { return v.principal1; }},
    {"principal_2", [](const InsideValue& v) { return v.principal2; }},
    {"temperature", [](const InsideValue& v) { return v.temperature; }},
};

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

InsideValue mean(const InsideValue& a, const InsideValue& b) {
  InsideValue m;
  m.displacement = 0.5 * (a.displacement + b.displacement);
  for (const auto part :
       {&InsideValue::xx, &InsideValue::yy, &InsideValue::xy, &InsideValue::zz,
        &InsideValue::vonMises, &InsideValue::principal1, &InsideValue::principal2,
        &InsideValue::temperature})
    m.*part = 0.5 * (a.*part + b.*part);
  return m;
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
  const std::size_t points = bodies.points.size();
  const std::size_t cells = bodies.corners.size();
  VtuGrid vtu{points, cells, R"(Scalars="von_mises" Vectors="displacement")"};
  std::vector<double> displacements;
  std::vector<double> places;
  std::vector<int> body;
  for (std::size_t i = 0; i < points; ++i) {
    const bem::Vec2 u = bodies.values[i].displacement;
    const auto& [b, x] = bodies.points[i];
    displacements.insert(displacements.end(), {u.x, u.y, 0});
    places.insert(places.end(), {x.x, x.y, 0});
    body.push_back(static_cast<int>(b));
  }
  vtu.pointData = {dataArray("displacement", displacements, 3)};
  for (const Field& field : fields) {
    std::vector<double> values;
    for (const InsideValue& value : bodies.values)
      values.push_back(field.of(value));
    vtu.pointData.push_back(dataArray(field.name, values));
  }
  vtu.pointData.push_back(dataArray("body", body));
  vtu.places = {dataArray("Points", places, 3)};
  std::vector<long long> ends;
  std::vector<long long> offsets;
  for (const auto& corners : bodies.corners) {
    ends.insert(ends.end(), corners.begin(), corners.end());
    offsets.push_back(static_cast<long long>(ends.size()));
  }
  constexpr unsigned char triangle = 5;  // VTK_TRIANGLE
  vtu.topology = {dataArray("connectivity", ends), dataArray("offsets", offsets),
                  dataArray("types", std::vector<unsigned char>(cells, triangle))};
  return vtuText(vtu);
}

std::vector<std::string> fieldNames() {
  std::vector<std::string> names;
  for (const Field& field : fields)
    names.emplace_back(field.name);
  return names;
}

}  // namespace epafi::drivers
