#include "drivers/output/BodyInsides.hpp"

#include "drivers/output/Csv.hpp"

namespace epafi::drivers {

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
