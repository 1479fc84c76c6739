#include "drivers/output/InsideVtu.hpp"

#include "bem/base/Error.hpp"
#include "drivers/output/BoundaryVtk.hpp"
#include "drivers/output/Csv.hpp"
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
};

/// Where a point of the boundary lies.
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
        &InsideValue::vonMises, &InsideValue::principal1, &InsideValue::principal2})
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

template <class Value>
std::string array(const char* type, const char* name, int components, std::size_t size,
                  const Value& value) {
  std::string text =
      bem::message("<DataArray type=\"", type, "\" Name=\"", name,
                   "\" NumberOfComponents=\"", components, "\" format=\"ascii\">\n");
  for (std::size_t i = 0; i < size; ++i)
    text += value(i) + "\n";
  return text + "</DataArray>\n";
}

std::string vector(bem::Vec2 v) { return exactly(v.x) + " " + exactly(v.y) + " 0"; }

}  // namespace

FilledBodies fill(const BodyInsides& insides) {
  FilledBodies all;
  for (std::size_t b = 0; b < insides.size(); ++b) {
    const Triangulation own = triangulate(insides.mesh(b));
    std::vector<InsideValue> values(own.points.size());
    const auto n = static_cast<long>(values.size());
#pragma omp parallel for schedule(dynamic, 16)
    for (long k = 0; k < n; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const InsidePoint point{b, own.points[i]};
      const bool boundary =
          own.onBoundary[i] || !insides.mesh(b).outline().contains(point.x);
      values[i] = boundary ? onBoundary(insides, point) : insides.at(point);
    }
    const auto first = static_cast<int>(all.values.size());
    for (const auto& c : own.corners)
      all.corners.push_back({first + c[0], first + c[1], first + c[2]});
    for (const bem::Vec2 x : own.points)
      all.points.push_back({b, x});
    all.values.insert(all.values.end(), values.begin(), values.end());
  }
  return all;
}

std::string vtuFile(const FilledBodies& bodies) {
  const std::vector<InsideValue>& values = bodies.values;
  const std::size_t points = bodies.points.size();
  const std::size_t cells = bodies.corners.size();
  VtuGrid vtu{points, cells, R"(Scalars="von_mises" Vectors="displacement")"};
  vtu.pointData = array("Float64", "displacement", 3, points,
                        [&](std::size_t i) { return vector(values[i].displacement); });
  for (const Field& field : fields)
    vtu.pointData += array("Float64", field.name, 1, points,
                           [&](std::size_t i) { return exactly(field.of(values[i])); });
  vtu.pointData += array("Int64", "body", 1, points,
                         [&](std::size_t i) { return number(bodies.points[i].body); });
  vtu.places = array("Float64", "Points", 3, points,
                     [&](std::size_t i) { return vector(bodies.points[i].x); });
  vtu.topology =
      array("Int64", "connectivity", 1, cells,
            [&](std::size_t i) {
              const auto& c = bodies.corners[i];
              return bem::message(c[0], " ", c[1], " ", c[2]);
            }) +
      array("Int64", "offsets", 1, cells,
            [](std::size_t i) { return std::to_string(3 * (i + 1)); }) +
      array("UInt8", "types", 1, cells, [](std::size_t) { return std::string("5"); });
  return vtuText(vtu);
}

std::vector<std::string> fieldNames() {
  std::vector<std::string> names;
  for (const Field& field : fields)
    names.emplace_back(field.name);
  return names;
}

}  // namespace epafi::drivers
