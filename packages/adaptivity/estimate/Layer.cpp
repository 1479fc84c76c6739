#include "adaptivity/estimate/Layer.hpp"

#include "bem/basis/Legendre.hpp"
#include "bem/geometry/NormalRay.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace epafi::adaptivity {

using bem::Vec2;
using bem::Vector;

namespace {

/// m with the mean zero at the points of m'.
std::vector<Vec2> integrated(const std::vector<bem::BoundaryValue>& values,
                             const Vector& weights, double length) {
  std::vector<Vec2> m;
  Vec2 sum{};
  Vec2 mean{};
  for (std::size_t q = 0; q < values.size(); ++q) {
    const Vec2 half = 0.5 * weights[q] * values[q].mismatch;
    m.push_back(sum + half);
    sum = m.back() + half;
    mean = mean + (weights[q] / length) * m.back();
  }
  for (Vec2& here : m)
    here = here - mean;
  return m;
}

}  // namespace

Layer layerBehind(const bem::Mesh& mesh, const contact::Conditions& conditions,
                  int element) {
  const bem::Outline& outline = mesh.outline();
  const int own = mesh[element].piece.edge;
  const Vec2 x = mesh.scaledPoint(element, 0);
  const Vec2 n = mesh[element].curve.normal(0);
  Layer layer;
  outline.curves().search(
      [&](const bem::Disc& disc) {
        constexpr double rounding = 1 + 1e-9;
        const Vec2 way = disc.middle - x;
        return std::abs(cross(n, way)) <= rounding * disc.radius &&
               -dot(n, way) <= layer.thickness + rounding * disc.radius;
      },
      [&](std::size_t k) {
        const int behind = static_cast<int>(k);
        const bem::Edge& edge = outline.edge(behind);
        if (behind == own || edge.previous == own || edge.next == own)
          return;
        const auto here = crossing(x, n, edge.curve);
        if (!here || !isOn(*here, edge.curve) || !(here->distance < 0) ||
            !(-here->distance < layer.thickness))
          return;
        layer = {-here->distance, conditions.dirichlet.count(edge.boundary) +
                                          conditions.contact.count(edge.boundary) >
                                      0};
      });
  return layer;
}

Layer::Stiffness Layer::beyondHalfPlane(const bem::Lame& lame, double length) const {
  const double slender = length / thickness;
  // 2 M/μ, or less where material escapes along the layer
  constexpr double squeezed = 3;
  const double across = std::min(4 * (1 - lame.nu) / std::max(1 - 2 * lame.nu, 0.0),
                                 squeezed * slender * slender);
  return {std::max(0.0, across * slender - squeezed) / length,
          std::max(0.0, 2 * (slender - 1)) / length};
}

double Layer::square(const bem::Lame& lame, const bem::Mesh& mesh, int e,
                     const std::vector<bem::BoundaryValue>& values) const {
  const bem::Element& element = mesh[e];
  if (!(2 * element.half > thickness))
    return 0;
  Vector weights;  // by arc length
  for (const bem::BoundaryValue& value : values)
    weights.push_back(value.weight * (element.half / mesh.measure(e, value.place.t)));
  const std::vector<Vec2> m = integrated(values, weights, 2 * element.half);
  constexpr int terms = 16;
  std::array<double, terms + 1> legendre{};
  std::array<Vec2, terms + 1> series{};
  Vec2 rest{};  // of the integrals of squares
  for (std::size_t q = 0; q < values.size(); ++q) {
    const double t = values[q].place.t;
    const Vec2 here{dot(m[q], element.curve.normal(t)),
                    dot(m[q], element.curve.tangent(t))};
    bem::legendreValues(terms, t, legendre.data());
    for (std::size_t k = 0; k <= terms; ++k)
      series[k] = series[k] + weights[q] * legendre[k] * here;
    rest = rest + weights[q] * Vec2{here.x * here.x, here.y * here.y};
  }
  double square = 0;
  for (std::size_t k = 1; k <= terms; ++k) {
    const Stiffness stiffer =
        beyondHalfPlane(lame, 2 * element.half / static_cast<double>(k));
    const double factor = (static_cast<double>(k) + 0.5) / element.half;
    const Vec2 part = factor * Vec2{series[k].x * series[k].x, series[k].y * series[k].y};
    rest = rest - part;
    square += stiffer.across * part.x + stiffer.along * part.y;
    if (k == terms)
      square +=
          stiffer.across * std::max(rest.x, 0.0) + stiffer.along * std::max(rest.y, 0.0);
  }
  return square * (mesh.measure(e, 0) / element.half);
}

}  // namespace epafi::adaptivity
