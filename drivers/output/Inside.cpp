#include "drivers/output/Inside.hpp"

#include "drivers/output/Csv.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::drivers {

namespace {

/// Depth of the points that stand for the boundary, over half the element length.
constexpr double skin = 1e-3;
/// Smallest distance to the ends of an element, over half the element length.
constexpr double end = 0.05;

}  // namespace

BodyInsides::BodyInsides(const Scene& scene, const Level& level, const SolvedState& step)
    : scene_(scene), spaces_(scene, level) {
  for (const auto& conditions :
       spaces_.conditionsAt(level.timeOf(step, scene.endOfPath())))
    inside_.push_back(conditions.inside);
  for (std::size_t b = 0; b < size(); ++b) {
    displacements_.emplace_back(spaces_.space(b), step.displacement[b]);
    fields_.emplace_back(spaces_.space(b), scene.lame(b), step.displacement[b],
                         step.density[b]);
  }
}

InsideValue BodyInsides::inUnits(
    std::size_t body, bem::Vec2 scaled, const bem::InteriorValue& field,
    const contact::ParticularSolution::Value& particular) const {
  const bem::Material& material = scene_.bodies[body].material;
  const bem::Units units = scene_.units();
  InsideValue value;
  value.displacement = units.length * field.displacement;
  value.xx = units.stress * field.xx;
  value.yy = units.stress * field.yy;
  value.xy = units.stress * field.xy;
  if (const contact::BodyLoadSolution& inside = inside_[body]) {
    const auto stress = inside->stress(scaled);
    value.displacement = value.displacement + units.length * particular.displacement;
    value.xx += units.stress * stress.xx;
    value.yy += units.stress * stress.yy;
    value.xy += units.stress * stress.xy;
  }
  value.zz = material.planeStress ? 0 : material.poissonsRatio * (value.xx + value.yy);
  if (const contact::BodyLoadSolution& inside = inside_[body]) {
    value.zz += units.stress * inside->stressAcross(particular.temperature);
    value.temperature = particular.temperature;
  }
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
  InsideValue value = at({{b, mesh(b).outline().physical(x)}}).front();
  bem::Vec2 u = displacements_[b].at(e, t);
  if (inside_[b])
    u = u + inside_[b]->displacement(mesh(b), e, t);
  value.displacement = scene_.units().length * u;
  return value;
}

double BodyInsides::workAtPoint(std::size_t b) const {
  constexpr double ofElement = 200;  // ns
  return ofElement * mesh(b).size();
}

std::vector<InsideValue> BodyInsides::at(const std::vector<InsidePoint>& points) const {
  std::vector<InsideValue> values(points.size());
  for (std::size_t b = 0; b < size(); ++b) {
    std::vector<std::size_t> own;
    std::vector<bem::Vec2> places;
    std::vector<bool> isImage;
    for (std::size_t k = 0; k < points.size(); ++k)
      if (points[k].body == b) {
        own.push_back(k);
        bem::Vec2 x = points[k].x;
        bem::Vec2 drawn = scene_.drawn(x);
        isImage.push_back(scene_.symmetry &&
                          scene_.symmetry.across(x) * scene_.symmetry.across(drawn) < 0);
        places.push_back(mesh(b).outline().scaled(drawn));
      }
    const std::vector<bem::InteriorValue> fields = fields_[b].at(places);
    std::vector<contact::ParticularSolution::Value> particular(places.size());
    if (inside_[b])
      particular = inside_[b]->at(places);
    for (std::size_t k = 0; k < own.size(); ++k) {
      InsideValue& value = values[own[k]];
      value = inUnits(b, places[k], fields[k], particular[k]);
      if (isImage[k]) {
        value.displacement = scene_.symmetry.mirrored(value.displacement);
        value.xy = -value.xy;
      }
    }
  }
  return values;
}

std::string BodyInsides::csv(const std::vector<InsidePoint>& points,
                             const std::vector<InsideValue>& values) const {
  std::string csv;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool outside = points[i].body == size();
    InsideValue value = values[i];
    CsvRow row = {{"x", exactly(points[i].x.x)}, {"y", exactly(points[i].x.y)}};
    for (const InsideField& field : insideFields) {
      row.emplace_back(field.name, outside ? "" : exactly(field.of(value)));
      if (&field.of(value) == &value.vonMises)
        row.emplace_back("body", outside ? "" : scene_.bodies[points[i].body].name);
    }
    addRow(row, csv);
  }
  return csv;
}

}  // namespace epafi::drivers
