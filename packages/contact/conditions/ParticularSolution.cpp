#include "contact/conditions/ParticularSolution.hpp"

#include "bem/quadrature/Gauss.hpp"

#include <cmath>
#include <utility>

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

/// The coordinates whose powers the terms are.
struct Place {
  Complex first;
  Complex second;
};

Place placeOf(bool isAxisymmetric, Vec2 at) {
  const Complex z = asComplex(at);
  return isAxisymmetric ? Place{at.x, at.y} : Place{z, std::conj(z)};
}

Complex valueAt(const BodyLoads::Terms& terms, const Place& place) {
  Complex result;
  for (const auto& [a, b, c] : terms)
    result += c * power(place.first, a) * power(place.second, b);
  return result;
}

/// The terms of a derivative with respect to one of both coordinates.
BodyLoads::Terms slopes(const BodyLoads::Terms& terms, int BodyLoads::Term::*coordinate) {
  BodyLoads::Terms result;
  for (BodyLoads::Term term : terms)
    if (const int n = term.*coordinate; n > 0) {
      term.c = static_cast<double>(n) * term.c;
      --(term.*coordinate);
      result.push_back(term);
    }
  return result;
}

}  // namespace

Complex ParticularSolution::sum(const BodyLoads::Terms& terms, Vec2 at) const {
  return valueAt(terms, placeOf(loads_.isAxisymmetric, at));
}

// ∂/∂z̄
Complex ParticularSolution::conjugateSlope(const BodyLoads::Terms& terms, Vec2 at) const {
  const Place place = placeOf(loads_.isAxisymmetric, at);
  const Complex second = valueAt(slopes(terms, &BodyLoads::Term::b), place);
  return loads_.isAxisymmetric
             ? 0.5 * (valueAt(slopes(terms, &BodyLoads::Term::a), place) +
                      Complex(0, 1) * second)
             : second;
}

ParticularSolution::ParticularSolution(const BodyLoads& loads, const bem::Lame& lame)
    : loads_(loads),
      lame_(lame),
      forces_(loads.isAxisymmetric ? ofForcesAround(loads, lame) : ofForces(loads, lame)),
      heat_(loads.isAxisymmetric ? ofHeatAround(loads, lame) : ofHeat(loads, lame)) {}

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
          {{1, 0, -b}, {0, 1, -loads.uniform}, {1, 1, -outwards / (2 * (1 - nu))}},
          {}};
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

// Of the uniform force a solution of one stress along the axis, -b y; outwards u ~ x², of spin u ~ x³.
ParticularSolution::Part ParticularSolution::ofForcesAround(const BodyLoads& loads,
                                                            const bem::Lame& lame) {
  const double nu = lame.nu;
  const double stiffness = 2 * lame.mu * (1 + nu);  // Young's modulus
  const double along = loads.uniform.imag();
  const double outwards = loads.uniform.real() / (1 - nu);
  const double spin = loads.linear.real() / (8 * (1 - nu));
  const double slenderness = (1 - 2 * nu) / (2 * lame.mu);
  return {{{1, 1, nu * along / stiffness},
           {0, 2, Complex(0, -along / (2 * stiffness))},
           {2, 0, Complex(0, -along * nu / (2 * stiffness))},
           {2, 0, -outwards * slenderness / 3},
           {3, 0, -spin * slenderness}},
          {{0, 1, -along},
           {1, 0, -outwards * 2 * (1 + nu) / 3},
           {2, 0, -spin * (3 + 2 * nu)}},
          {{1, 0, -outwards * (1 + nu) / 3}, {2, 0, -spin * (1 + 2 * nu)}}};
}

// A temperature linear in y makes no stress; of the others u = ∇Φ with ∇²Φ = m T, where
// ∇² x^n y^b = n² x^(n-2) y^b + b (b-1) x^n y^(b-2), and σ = 2μ (∇∇Φ - m T).
ParticularSolution::Part ParticularSolution::ofHeatAround(const BodyLoads& loads,
                                                          const bem::Lame& lame) {
  const double m = loads.expansion / (1 - lame.nu);
  const double alpha = loads.expansion / (1 + lame.nu);
  const Complex along(0, 1);
  Part part;
  for (auto [a, b, c] : loads.temperature) {
    if (a == 0 && b == 0) {
      part.displacement.insert(part.displacement.end(),
                               {{1, 0, alpha * c}, {0, 1, along * alpha * c}});
      continue;
    }
    if (a == 0 && b == 1) {
      part.displacement.insert(part.displacement.end(),
                               {{1, 1, alpha * c},
                                {0, 2, 0.5 * along * alpha * c},
                                {2, 0, -0.5 * along * alpha * c}});
      continue;
    }
    const Complex heat = -2 * lame.mu * m * c;
    part.trace.push_back({a, b, heat});
    part.hoop.push_back({a, b, heat});
    for (; b >= 0; a += 2, b -= 2) {
      const double n = a + 2;
      const Complex potential = m * c / (n * n);
      const Complex around = 2 * lame.mu * n * potential;  // 2μ/x ∂Φ/∂x
      part.displacement.push_back({a + 1, b, n * potential});
      if (b > 0)
        part.displacement.push_back(
            {a + 2, b - 1, static_cast<double>(b) * along * potential});
      part.trace.push_back({a, b, -around});
      part.hoop.push_back({a, b, around});
      c *= -b * (b - 1) / (n * n);
    }
  }
  return part;
}

// NOLINTNEXTLINE(modernize-pass-by-value): a part of it is replaced
ParticularSolution::ParticularSolution(const ParticularSolution& loads,
                                       std::shared_ptr<const ConductedHeat> heat)
    : ParticularSolution(loads) {
  heat_ = {};
  conducted_ = std::move(heat);
}

Vec2 ParticularSolution::displacementOfForces(Vec2 at) const {
  return asVector(sum(forces_.displacement, at));
}

Vec2 ParticularSolution::displacementOfPolynomials(Vec2 at) const {
  return displacementOfForces(at) + asVector(sum(heat_.displacement, at));
}

ParticularSolution::Value ParticularSolution::ofPolynomials(Vec2 at) const {
  return {displacementOfPolynomials(at), sum(loads_.temperature, at).real(),
          stressOf(forces_, at) + stressOf(heat_, at)};
}

Vec2 ParticularSolution::displacementOf(const ConductedHeat::Value& heat) const {
  return freely() * heat.free + ofConducted() * heat.gradient;
}

ParticularSolution::Stress ParticularSolution::stressOf(
    const ConductedHeat::Value& heat) const {
  return 2 * lame_.mu * ofConducted() * heat.stress;
}

void ParticularSolution::add(const ConductedHeat::Value& heat, Value& value) const {
  value.displacement = value.displacement + displacementOf(heat);
  value.temperature = heat.temperature;
  value.stress = value.stress + stressOf(heat);
}

std::vector<ParticularSolution::Value> ParticularSolution::at(
    const std::vector<Vec2>& points) const {
  std::vector<Value> values;
  values.reserve(points.size());
  for (const Vec2 y : points)
    values.push_back(ofPolynomials(y));
  if (conducted_ == nullptr)
    return values;
  const std::vector<ConductedHeat::Value> heat = conducted_->at(points);
  for (std::size_t k = 0; k < points.size(); ++k)
    add(heat[k], values[k]);
  return values;
}

ParticularSolution::Value ParticularSolution::on(const bem::Mesh& mesh, int element,
                                                 double t) const {
  Value value = ofPolynomials(mesh.scaledPoint(element, t));
  if (conducted_ != nullptr)
    add(conducted_->on(element, t), value);
  return value;
}

Vec2 ParticularSolution::displacement(const bem::Mesh& mesh, int element,
                                      double t) const {
  const Vec2 u = displacementOfPolynomials(mesh.scaledPoint(element, t));
  return conducted_ == nullptr ? u : u + displacementOf(conducted_->on(element, t));
}

ParticularSolution::Stress ParticularSolution::stressOfHeat(const bem::Mesh& mesh,
                                                            int element, double t) const {
  return conducted_ == nullptr ? stressOf(heat_, mesh.scaledPoint(element, t))
                               : stressOf(conducted_->on(element, t));
}

ParticularSolution::Stress ParticularSolution::stressOf(const Part& part, Vec2 at) const {
  const double mean = 0.5 * sum(part.trace, at).real();
  const Complex rest = 2 * lame_.mu * conjugateSlope(part.displacement, at);
  return {mean + rest.real(), mean - rest.real(), rest.imag(), sum(part.hoop, at).real()};
}

Vec2 ParticularSolution::force(Vec2 at) const {
  return asVector(loads_.uniform +
                  loads_.linear * (loads_.isAxisymmetric ? at.x : asComplex(at)));
}

double ParticularSolution::energyDensity(Vec2 at) const {
  const Stress s = stressOf(forces_, at) + stressOf(heat_, at);
  const double trace = s.xx + s.yy + s.hoop;
  const double share =
      loads_.isAxisymmetric ? lame_.nu / (1 + lame_.nu) : lame_.nu;  // of the trace
  return (s.xx * s.xx + s.yy * s.yy + s.hoop * s.hoop + 2 * s.xy * s.xy -
          share * trace * trace) /
         (4 * lame_.mu);
}

namespace {

/// ∫ f over the body from its boundary: ∮ y·n ∫ s f(s y) ds, s in (0, 1); exact for polynomials of
/// degree 8.  Around an axis of revolution 2πx f.
template <class Density>
double integralInside(const bem::Mesh& mesh, const Density& f) {
  const bool isAxisymmetric = mesh.outline().isAxisymmetric();
  const bem::Rule& radial = bem::gaussLegendre(isAxisymmetric ? 6 : 5);
  double sum = 0;
  for (int e = 0; e < mesh.size(); ++e) {
    const bem::Rule& rule = bem::gaussForGiven(mesh[e].degree);
    for (int q = 0; q < rule.size(); ++q) {
      const double t = rule.points[q];
      const Vec2 y = mesh.scaledPoint(e, t);
      double along = 0;
      for (int k = 0; k < radial.size(); ++k) {
        const double s = 0.5 * (1 + radial.points[k]);
        along += 0.5 * radial.weights[k] * s * (isAxisymmetric ? s : 1) * f(s * y);
      }
      sum +=
          mesh.measure(e, t) * rule.weights[q] * dot(y, mesh[e].curve.normal(t)) * along;
    }
  }
  return sum;
}

}  // namespace

ParticularSolution::Energies ParticularSolution::energies(const bem::Mesh& mesh) const {
  Energies result;
  result.own = integralInside(mesh, [&](Vec2 y) { return energyDensity(y); });
  result.work = integralInside(
      mesh, [&](Vec2 y) { return dot(force(y), displacementOfPolynomials(y)); });
  if (conducted_ != nullptr)
    addConducted(mesh, result);
  return result;
}

// With b the forces' solution, Φ and T₀ as in ConductedHeat, s the stress of Φ, κ = 1, around an axis
// κ = 2, ∇²Q = tr σ_b, and by Betti's and Green's formulas
//   ½ ∫ σ_s : C⁻¹ σ_s = ½ ∮ t_s·u_s + κ μ m α' ∫ (∇²Φ)²,   ∫ (∇²Φ)² = ∮ ∇²Φ ∂Φ/∂n - Φ ∂∇²Φ/∂n,
//   ∫ σ_s : C⁻¹ σ_b = ∮ t_s·u_b,
//   ∫ b·u_T = ∮ t_s·u_b - t_b·u_T + α' ∫ T tr σ_b,      ∫ T tr σ_b = ∮ T ∂Q/∂n - Q ∂T/∂n.
void ParticularSolution::addConducted(const bem::Mesh& mesh, Energies& energies) const {
  const double m = ofConducted();
  const double alpha = freely();
  const double heat = (loads_.isAxisymmetric ? 2 : 1) * lame_.mu * m * alpha;
  BodyLoads::Terms q = forces_.trace;
  if (loads_.isAxisymmetric) {  // linear in y
    q.insert(q.end(), forces_.hoop.begin(), forces_.hoop.end());
    for (auto& [a, b, c] : q) {
      a += 2;
      c /= static_cast<double>(a) * a;
    }
  } else {
    for (auto& [a, b, c] : q)
      c /= 4.0 * ++a * ++b;
  }
  for (int e = 0; e < mesh.size(); ++e) {
    const bem::Rule& rule = bem::gaussForGiven(mesh[e].degree);
    for (int k = 0; k < rule.size() && !mesh.isAxis(e); ++k) {
      const double t = rule.points[k];
      const double weight = mesh.measure(e, t) * rule.weights[k];
      const Vec2 y = mesh.scaledPoint(e, t);
      const Vec2 normal = mesh[e].curve.normal(t);
      const ConductedHeat::Value of = conducted_->on(e, t);
      const Vec2 traction = stressOf(of).on(normal);
      const double twofold = dot(traction, displacementOfForces(y));
      energies.own += weight * (0.5 * m * dot(traction, of.gradient) + twofold +
                                heat * (of.stressing * dot(of.gradient, normal) -
                                        of.potential * of.stressingFlow));
      energies.work +=
          weight *
          (twofold - dot(stressOf(forces_, y).on(normal), displacementOf(of)) +
           alpha * (of.temperature * 2 *
                        (std::conj(asComplex(normal)) * conjugateSlope(q, y)).real() -
                    sum(q, y).real() * of.flow));
    }
  }
}

}  // namespace epafi::contact
