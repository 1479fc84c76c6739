#include "contact/conditions/RingHeat.hpp"

#include "bem/base/Parallel.hpp"
#include "bem/fields/RingFields.hpp"
#include "bem/operators/RingLaplace.hpp"
#include "contact/conditions/PlaneHeat.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace epafi::contact {

using bem::Complex;
using bem::largestDegree;
using bem::Vec2;
using bem::Vector;

namespace {

using Part = RingPotential::Part;
using Series = RingPotential::Series;
constexpr double fourPi = 12.566370614359172;
/// Of all series but Ψ, which is the integral of one.
constexpr int degree = largestDegree - 1;

double valueOf(const Series& series, double t) {
  return bem::evaluate(series, largestDegree, t);
}

/// Best multiples x of two functions whose products with each other and a third one are these.
std::array<double, 2> fitOf(double aa, double ab, double bb, double af, double bf) {
  const double determinant = aa * bb - ab * ab;
  constexpr double alike = 1e-12;
  if (determinant <= alike * aa * bb)
    return {aa > 0 ? af / aa : 0, 0};
  return {(bb * af - ab * bf) / determinant, (aa * bf - ab * af) / determinant};
}

}  // namespace

RingHeat::Places RingHeat::placesInHoles(const bem::Mesh& mesh) {
  const Places inLoops = PlaneHeat::placesInHoles(mesh.outline());
  const std::vector<bem::Surface> surfaces = bem::surfacesOf(mesh);
  Places places;
  for (std::size_t k = 1; k < surfaces.size(); ++k) {
    const int first = surfaces[k].elements.front();
    const int last = surfaces[k].elements.back();
    const int loop = mesh.outline().edge(mesh[first].piece.edge).loop;
    if (surfaces[k].isClosed)
      places.push_back(inLoops[bem::at(loop - 1)]);
    else
      places.push_back(
          {{0, 0.5 * (mesh.scaledPoint(first, -1).y + mesh.scaledPoint(last, 1).y)}});
  }
  return places;
}

RingHeat::RingHeat(const bem::Space& space, const Vector& data, const Places& places,
                   Vector errors)
    : surface_(space, data), missed_(std::move(errors)) {
  for (std::size_t k = 0; k < parts().size(); ++k)
    if (parts()[k].from == -1)
      firsts_.push_back(k);
  addSources(places);
  takeOffFree();
  follow();
  addLine();
  addDipoles(places);
  compare(space.mesh());
  std::array<std::vector<bem::LocalField>, 2> fields;
  for (std::size_t k = 0; k < parts().size(); ++k)
    for (const bool isPotential : {false, true})
      fields[isPotential ? 1 : 0].push_back(fieldOf(k, isPotential));
  for (std::vector<bem::LocalField>& field : fields)
    inside_.emplace_back(mesh(), bem::lameOfRingLaplace(), std::move(field));
}

void RingHeat::addSources(const Places& places) {
  for (std::size_t k = 1; k < surfaces().size(); ++k) {
    double flow = 0;
    surface_.forEachPoint(k, [&](int e, double t, double weight) {
      flow += weight * valueOf(parts()[bem::at(e)].flow, t);
    });
    for (const Complex& place : places[k - 1])
      sources_.add(
          {bem::asVector(place), flow / static_cast<double>(places[k - 1].size())});
  }
}

void RingHeat::addDipoles(const Places& places) {
  for (std::size_t k = 1; k < surfaces().size(); ++k)
    for (const Complex& place : places[k - 1])
      if (surfaces()[k].isClosed)
        sources_.add({bem::asVector(place), 0,
                      place.real() * surface_.gain(k) /
                          (fourPi * static_cast<double>(places[k - 1].size()))});
  if (surfaces().size() > 1)
    follow();
}

// S of log r is r ∂/∂r log r z = z.
void RingHeat::addLine() {
  if (!surfaces()[0].isClosed)
    return;
  std::array<double, 5> of{};  // of 1, z and S
  surface_.forEachPoint(0, [&](int e, double t, double weight) {
    const Vec2 y = mesh().scaledPoint(e, t);
    const double s = y.x * y.x * valueOf(parts()[bem::at(e)].around, t);
    const double terms[] = {1, y.y, y.y * y.y, s, y.y * s};
    for (std::size_t i = 0; i < of.size(); ++i)
      of[i] += weight * terms[i];
  });
  const auto [start, slope] = fitOf(of[0], of[1], of[2], of[3], of[4]);
  sources_.addLine(slope);
  const double z = mesh().scaledPoint(surfaces()[0].elements.front(), -1).y;
  surface_.addStarts(0, -start - slope * z, 0);
  takeOffFree();
  follow();
}

void RingHeat::takeOffFree() {
  std::array<double, 5> of{};  // of 1, z and T without sources
  for (std::size_t k = 0; k < surfaces().size(); ++k)
    surface_.forEachPoint(k, [&](int e, double t, double weight) {
      const Vec2 y = mesh().scaledPoint(e, t);
      const double rest =
          valueOf(parts()[bem::at(e)].temperature, t) - sources_.at(y).temperature;
      const double terms[] = {1, y.y, y.y * y.y, rest, y.y * rest};
      for (std::size_t i = 0; i < of.size(); ++i)
        of[i] += weight * terms[i];
    });
  free_ = fitOf(of[0], of[1], of[2], of[3], of[4]);
}

bem::LocalField RingHeat::fieldOf(std::size_t part, bool isPotential) const {
  const Part& own = parts()[part];
  const bem::Curve& curve = mesh()[bem::asInt(static_cast<bem::Index>(part))].curve;
  bem::LocalField field;
  const auto take = [](const Series& from, bem::LegendreSeries<Complex>& to) {
    for (std::size_t k = 0; k < from.size(); ++k)
      to[k] = {0, from[k]};
  };
  if (!isPotential) {
    take(own.rest, field.value);
    take(own.restSlope, field.slope);
    take(own.restFlow, field.density);
    return field;
  }
  take(own.potential, field.value);
  take(bem::project(
           [&](double t) {
             const Vec2 normal = curve.normal(t);
             return normal.x * curve.point(t).x * valueOf(own.around, t) +
                    normal.y * valueOf(own.rest, t);
           },
           degree),
       field.density);
  return field;
}

// Both integral equations say what T and q miss.  Of Ψ in a hole they miss what is without effect
// inside, a constant and, where the hole is off the axis, a multiple of log r, of which S is constant.
void RingHeat::compare(const bem::Mesh& mesh) {
  constexpr int more = 2;
  const bem::Mesh tested = surface_.meshOf(mesh, more);
  std::vector<bem::LocalField> fields;
  for (std::size_t k = 0; k < parts().size(); ++k)
    for (const bool isPotential : {false, true})
      fields.push_back(fieldOf(k, isPotential));
  const bem::RingFields residuals(tested, bem::lameOfRingLaplace(), fields, 2);
  const auto imaginary = [&](const bem::LegendreSeries<Complex>& series, double t) {
    return bem::evaluate(series, largestDegree, t).imag();
  };
  for (std::size_t k = 0; k < surfaces().size(); ++k) {
    std::array<double, 5> of{};  // of 1, log r and Ψ's residual
    surface_.forEachPoint(k, [&](int e, double t, double weight) {
      const bem::RingFields::Series& series = residuals.of(e, 0);
      const Part& part = parts()[bem::at(e)];
      const double size = 2 * tested[e].half / tested[e].degree;
      missed_[bem::at(part.element)] +=
          weight *
          (std::pow(imaginary(series.mismatch, t), 2) +
           std::pow(size * (imaginary(series.traction, t) - valueOf(part.restFlow, t)),
                    2));
      const double log =
          surfaces()[k].isClosed ? std::log(tested.scaledPoint(e, t).x) : 0;
      const double rest = imaginary(residuals.of(e, 1).mismatch, t);
      const double terms[] = {1, log, log * log, rest, log * rest};
      for (std::size_t i = 0; i < of.size(); ++i)
        of[i] += weight * terms[i];
    });
    const auto [constant, ofLog] = fitOf(of[0], of[1], of[2], of[3], of[4]);
    if (k == 0)
      continue;
    const double start = tested.scaledPoint(surfaces()[k].elements.front(), -1).x;
    surface_.addStarts(k, ofLog, constant + (ofLog == 0 ? 0 : ofLog * std::log(start)));
  }
  if (surfaces().size() > 1)
    follow();
}

Vec2 RingHeat::freeAt(Vec2 y) const {
  return {free_[0] * y.x + free_[1] * y.x * y.y,
          free_[0] * y.y + 0.5 * free_[1] * (y.y * y.y - y.x * y.x)};
}

// Φ = z Ψ/2; Laplace's equation gives ∂²Ψ/∂r².
std::vector<RingHeat::Value> RingHeat::at(const std::vector<Vec2>& points) const {
  std::vector<Value> values(points.size());
  const std::vector<bem::InteriorValue> rests = inside_[0].at(points);
  const std::vector<bem::InteriorValue> potentials = inside_[1].at(points);
  constexpr double ofPoint = 1000;  // ns
  bem::parallelFor(
      {static_cast<bem::Index>(points.size()),
       ofPoint * static_cast<double>(points.size())},
      [&](bem::Index k) {
        constexpr double close = 1e-5;  // to the axis
        const Vec2 x = points[bem::at(k)];
        const bem::InteriorValue& rest = rests[bem::at(k)];
        const bem::InteriorValue& potential = potentials[bem::at(k)];
        const double psi = potential.displacement.y;
        const Vec2 slope{2 * potential.xy, potential.yy};
        const Vec2 second{2 * rest.xy, rest.yy};  // ∂²Ψ/∂r∂z, ∂²Ψ/∂z²
        const double around = x.x > close ? slope.x / x.x : -0.5 * second.y;
        const RingSources::Value of = sources_.at(x);
        Value& value = values[bem::at(k)];
        value.temperature =
            free_[0] + free_[1] * x.y + rest.displacement.y + of.temperature;
        value.free = freeAt(x);
        value.potential = 0.5 * x.y * psi + of.potential;
        value.gradient = 0.5 * Vec2{x.y * slope.x, psi + x.y * slope.y} + of.gradient;
        value.stressing = slope.y + of.temperature;
        value.stress =
            BodyStress{-0.5 * x.y * (second.y + around) - slope.y, 0.5 * x.y * second.y,
                       0.5 * (slope.x + x.y * second.x), 0.5 * x.y * around - slope.y} +
            of.stress;
      });
  return values;
}

// ∇∇Φ τ is the derivative of ∇Φ along the surface, the rest of ∇∇Φ follows from its trace.
RingHeat::Value RingHeat::on(int element, double t) const {
  const int first = bem::asInt(static_cast<bem::Index>(firsts_[bem::at(element)]));
  if (mesh().isAxis(first)) {
    const auto neighbour = [&](int part) { return parts()[bem::at(part)].element; };
    if (t <= -1)
      return on(neighbour(mesh()[first].previous), 1);
    return t >= 1 ? on(neighbour(mesh()[first].next), -1)
                  : at({mesh().scaledPoint(first, t)})[0];
  }
  std::size_t k = firsts_[bem::at(element)];
  while (parts()[k].to < t && parts()[k].to < 1)
    ++k;
  const Part& part = parts()[k];
  const double s = part.from == -1 && part.to == 1
                       ? t
                       : -1 + 2 * (t - part.from) / (part.to - part.from);
  const bem::Curve& curve = mesh()[bem::asInt(static_cast<bem::Index>(k))].curve;
  const Vec2 y = curve.point(s);
  const Vec2 tangent = curve.tangent(s);
  const Vec2 normal = curve.normal(s);
  const RingSources::Value of = sources_.at(y);
  const double rest = valueOf(part.rest, s);
  const double flow = valueOf(part.restFlow, s);
  const double around = valueOf(part.around, s);
  const double psi = valueOf(part.potential, s);
  const double radial = y.x * around;  // ∂Ψ/∂r
  const Vec2 slope = 0.5 * Vec2{tangent.y * radial + y.y * (flow - tangent.x * around),
                                tangent.x * radial + 2 * tangent.y * rest +
                                    y.y * valueOf(part.restSlope, s)};
  const double hoop = 0.5 * y.y * around;
  const double mean = 0.5 * (rest - hoop);
  const Vec2 left = slope - mean * tangent;
  const double difference = left.x * tangent.x - left.y * tangent.y;
  const double shear = left.x * tangent.y + left.y * tangent.x;
  Value value;
  value.temperature = valueOf(part.temperature, s);
  value.free = freeAt(y);
  value.potential = 0.5 * y.y * psi + of.potential;
  value.gradient = 0.5 * Vec2{y.y * radial, psi + y.y * rest} + of.gradient;
  value.stressing = rest + of.temperature;
  value.stress =
      BodyStress{mean + difference - rest, mean - difference - rest, shear, hoop - rest} +
      of.stress;
  value.flow = valueOf(part.flow, s);
  value.stressingFlow = flow + dot(of.slope, normal);
  return value;
}

}  // namespace epafi::contact
