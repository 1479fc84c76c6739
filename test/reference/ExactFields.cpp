#include "reference/ExactFields.hpp"

#include "bem/basis/Legendre.hpp"
#include "bem/quadrature/Gauss.hpp"

#include <array>
#include <cmath>

namespace epafi::reference {

using bem::Vec2;
using bem::Vector;

namespace {

/// Points per element for smooth fields: exact to degree 59.
constexpr int order = 30;

}  // namespace

ExactField constantStress(const bem::Lame& lame, PlaneStressTensor sigma,
                          double rotation) {
  const double trace = lame.nu * (sigma.xx + sigma.yy);
  const double xx = (sigma.xx - trace) / (2 * lame.mu);
  const double yy = (sigma.yy - trace) / (2 * lame.mu);
  const double xy = sigma.xy / (2 * lame.mu);
  const auto displacement = [=](Vec2 x) {
    return Vec2{xx * x.x + (xy - rotation) * x.y, (xy + rotation) * x.x + yy * x.y};
  };
  return {displacement, [sigma](Vec2) { return sigma; }};
}

ExactField pointForce(const bem::Lame& lame, Vec2 x0, Vec2 e) {
  const auto displacement = [=](Vec2 x) {
    const Vec2 d = x - x0;
    const double r2 = dot(d, d);
    return -0.5 * lame.a * std::log(r2) * e + lame.b * dot(d, e) / r2 * d;
  };
  const double factor = 1 / (4 * std::acos(-1.0) * (1 - lame.nu));
  const double shear = 1 - 2 * lame.nu;
  const auto stress = [=](Vec2 x) {
    const Vec2 d = x - x0;
    const double r2 = dot(d, d);
    const double de = dot(d, e);
    const double c = factor / r2;
    return PlaneStressTensor{
        c * (shear * (de - 2 * d.x * e.x) - 2 * d.x * d.x * de / r2),
        c * (shear * (de - 2 * d.y * e.y) - 2 * d.y * d.y * de / r2),
        c * (-shear * (d.x * e.y + d.y * e.x) - 2 * d.x * d.y * de / r2)};
  };
  return {displacement, stress};
}

Vector displacementOf(const bem::Space& space, const ExactField& field) {
  return space.interpolate(field.displacement);
}

Vector tractionOf(const bem::Space& space, const ExactField& field) {
  Vector psi(space.densities());
  const bem::Rule& rule = bem::gaussLegendre(order);
  const bem::Mesh& mesh = space.mesh();
  for (int e = 0; e < mesh.size(); ++e)
    for (int q = 0; q < rule.size(); ++q) {
      const Vec2 x = mesh.scaledPoint(e, rule.points[q]);
      const Vec2 traction = field.stress(x) * mesh[e].curve.normal(rule.points[q]);
      std::array<double, bem::largestDegree + 1> legendre{};
      bem::legendreValues(mesh[e].degree - 1, rule.points[q], legendre.data());
      for (int i = 0; i < mesh[e].degree; ++i) {
        const double w = rule.weights[q] * legendre[i] * (2 * i + 1) / 2;
        psi[space.density(e, i, 0)] += w * traction.x;
        psi[space.density(e, i, 1)] += w * traction.y;
      }
    }
  return psi;
}

double tractionError(const bem::Space& space, const Vector& psi,
                     const ExactField& field) {
  const bem::Rule& rule = bem::gaussLegendre(order);
  const bem::Mesh& mesh = space.mesh();
  double error = 0;
  double size = 0;
  for (int e = 0; e < mesh.size(); ++e)
    for (int q = 0; q < rule.size(); ++q) {
      const Vec2 exact = field.stress(mesh.scaledPoint(e, rule.points[q])) *
                         mesh[e].curve.normal(rule.points[q]);
      const Vec2 difference = space.densityAt(psi, e, rule.points[q]) - exact;
      error += mesh[e].half * rule.weights[q] * dot(difference, difference);
      size += mesh[e].half * rule.weights[q] * dot(exact, exact);
    }
  return std::sqrt(error / size);
}

}  // namespace epafi::reference
