#include "contact/conditions/ParticularSolution.hpp"

#include <cmath>

namespace epafi::contact {

using bem::asComplex;
using bem::asVector;
using bem::Complex;
using bem::Vec2;

namespace {

Complex power(Complex z, int n) {
  Complex result = 1;
  for (int k = 0; k < n; ++k)
    result *= z;
  return result;
}

Complex sum(const BodyLoads::Terms& terms, Complex z) {
  Complex result;
  for (const auto& [a, b, c] : terms)
    result += c * power(z, a) * power(std::conj(z), b);
  return result;
}

/// ∂/∂z̄
Complex conjugateSlope(const BodyLoads::Terms& terms, Complex z) {
  Complex result;
  for (const auto& [a, b, c] : terms)
    if (b > 0)
      result += static_cast<double>(b) * c * power(z, a) * power(std::conj(z), b - 1);
  return result;
}

}  // namespace

ParticularSolution::ParticularSolution(const BodyLoads& loads, const bem::Lame& lame)
    : loads_(loads),
      lame_(lame),
      forces_(ofForces(loads, lame)),
      heat_(ofHeat(loads, lame)) {}

// With w = u₁ + i u₂:  σxx + σyy = 4 (λ+μ) Re ∂w/∂z,  σxx - σyy + 2i σxy = 4 μ ∂w/∂z̄.  The first
// one is written out, since λ -> ∞ as ν -> 1/2.
ParticularSolution::Part ParticularSolution::ofForces(const BodyLoads& loads,
                                                      const bem::Lame& lame) {
  const double mu = lame.mu;
  const double nu = lame.nu;
  const Complex b = std::conj(loads.uniform);
  const double outwards = loads.linear.real();
  const Complex turning(0, loads.linear.imag());
  const Complex cubic = -(outwards * (1 - 2 * nu) / (2 * (1 - nu)) + turning) / (8 * mu);
  return {{{2, 0, -(1 - 2 * nu) / (4 * mu) * b}, {2, 1, cubic}},
          {{1, 0, -b}, {0, 1, -loads.uniform}, {1, 1, -outwards / (2 * (1 - nu))}}};
}

// Of a temperature Re f(z)  w = α' ∫ f dz;  of the other terms  w = m/2 ∫ T dz, z̄ held.
ParticularSolution::Part ParticularSolution::ofHeat(const BodyLoads& loads,
                                                    const bem::Lame& lame) {
  const double m = loads.expansion / (1 - lame.nu);
  Part part;
  for (const auto& [a, b, c] : loads.temperature) {
    const Complex integral = c / static_cast<double>(a + 1);
    if (b == 0) {  // its conjugate is the term that has a = 0
      part.displacement.push_back(
          {a + 1, 0, (a == 0 ? 1 : 2) * loads.expansion * integral});
    } else if (a > 0) {
      part.displacement.push_back({a + 1, b, 0.5 * m * integral});
      part.trace.push_back({a, b, -2 * lame.mu * m * c});
    }
  }
  return part;
}

Vec2 ParticularSolution::displacement(Vec2 at) const {
  return displacementOfForces(at) + asVector(sum(heat_.displacement, asComplex(at)));
}

Vec2 ParticularSolution::displacementOfForces(Vec2 at) const {
  return asVector(sum(forces_.displacement, asComplex(at)));
}

ParticularSolution::Stress ParticularSolution::stressOf(const Part& part, Vec2 at) const {
  const Complex z = asComplex(at);
  const double mean = 0.5 * sum(part.trace, z).real();
  const Complex rest = 2 * lame_.mu * conjugateSlope(part.displacement, z);
  return {mean + rest.real(), mean - rest.real(), rest.imag()};
}

ParticularSolution::Stress ParticularSolution::stress(Vec2 at) const {
  const Stress a = stressOf(forces_, at);
  const Stress b = stressOf(heat_, at);
  return {a.xx + b.xx, a.yy + b.yy, a.xy + b.xy};
}

Vec2 ParticularSolution::force(Vec2 at) const {
  return asVector(loads_.uniform + loads_.linear * asComplex(at));
}

double ParticularSolution::temperature(Vec2 at) const {
  return sum(loads_.temperature, asComplex(at)).real();
}

double ParticularSolution::energyDensity(Vec2 at) const {
  const Stress s = stress(at);
  const double trace = s.xx + s.yy;
  return (s.xx * s.xx + s.yy * s.yy + 2 * s.xy * s.xy - lame_.nu * trace * trace) /
         (4 * lame_.mu);
}

}  // namespace epafi::contact
