#include "contact/conditions/RingHeat.hpp"

#include "bem/base/Parallel.hpp"
#include "bem/fields/RingFields.hpp"
#include "bem/operators/Laplace.hpp"
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

using Series = bem::LegendreSeries<double>;
constexpr double fourPi = 12.566370614359172;
/// Of all series but Ψ, which is the integral of one.
constexpr int degree = largestDegree - 1;

double valueOf(const Series& series, double t) {
  return bem::evaluate(series, largestDegree, t);
}

/// ∫ f along the element from -1 on.
Series runningIntegral(const Series& f, double half, double start) {
  Series sum{};
  sum[0] = start + half * f[0];
  sum[1] = half * f[0];
  for (std::size_t k = 1; k < largestDegree; ++k) {
    const double c = half / (2.0 * static_cast<double>(k) + 1) * f[k];
    sum[k + 1] += c;
    sum[k - 1] -= c;
  }
  return sum;
}

/// Derivative along the element:  P_k' = Σ (2i+1) P_i,  i = k-1, k-3, ...
Series slopeOf(const Series& f, double half) {
  Series slope{};
  double sums[2] = {};
  for (std::size_t k = largestDegree; k > 0; --k) {
    sums[k % 2] += f[k];
    slope[k - 1] = (2.0 * static_cast<double>(k) - 1) / half * sums[k % 2];
  }
  return slope;
}

/// Best multiples x of two functions whose products with each other and a third one are these.
std::array<double, 2> fitOf(double aa, double ab, double bb, double af, double bf) {
  const double determinant = aa * bb - ab * ab;
  constexpr double alike = 1e-12;
  if (determinant <= alike * aa * bb)
    return {aa > 0 ? af / aa : 0, 0};
  return {(bb * af - ab * bf) / determinant, (aa * bf - ab * af) / determinant};
}

/// f(e, t, weight) of Gauss points on elements, with the area or the length.
template <class Visit>
void forEachPoint(const bem::Mesh& mesh, const std::vector<int>& elements,
                  const Visit& visit) {
  const bem::Rule& rule = bem::gaussLegendre(largestDegree + 1);
  for (const int e : elements)
    for (std::size_t q = 0; q < rule.points.size(); ++q)
      visit(e, rule.points[q], rule.weights[q] * mesh.measure(e, rule.points[q]));
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

std::vector<RingHeat::Part> RingHeat::partsOf(const bem::Mesh& mesh) {
  std::vector<Part> parts;
  for (int e = 0; e < mesh.size(); ++e) {
    const bool meetsAxis =
        mesh.isAxis(e) || mesh.isAxis(mesh[e].previous) || mesh.isAxis(mesh[e].next);
    const auto radius = [&](double t) { return mesh.scaledPoint(e, t).x; };
    const auto divide = [&](double from, double to, const auto& self) -> void {
      const double middle = 0.5 * (from + to);
      const double closest = std::min({radius(from), radius(middle), radius(to)});
      if (meetsAxis || mesh[e].half * (to - from) <= closest) {
        parts.push_back({e, from, to});
        return;
      }
      self(from, middle, self);
      self(middle, to, self);
    };
    divide(-1, 1, divide);
  }
  return parts;
}

/// \param more  degrees of the parts beyond those of the elements
bem::Mesh RingHeat::meshOf(const bem::Mesh& mesh, const std::vector<Part>& parts,
                           int more) {
  std::vector<bem::Piece> pieces;
  for (const Part& part : parts) {
    const bem::Piece& piece = mesh[part.element].piece;
    pieces.push_back({piece.edge,
                      part.from == -1 ? piece.start : positionAt(piece, part.from),
                      part.to == 1 ? piece.end : positionAt(piece, part.to),
                      std::min(mesh[part.element].degree + more, largestDegree)});
  }
  return {mesh.sharedOutline(), pieces};
}

RingHeat::RingHeat(const bem::Space& space, const Vector& data, const Places& places,
                   Vector errors)
    : parts_(partsOf(space.mesh())),
      mesh_(meshOf(space.mesh(), parts_, largestDegree)),
      surfaces_(bem::surfacesOf(mesh_)),
      flowStarts_(surfaces_.size()),
      potentialStarts_(surfaces_.size()),
      gains_(surfaces_.size()),
      missed_(std::move(errors)) {
  for (std::size_t k = 0; k < parts_.size(); ++k)
    if (parts_[k].from == -1)
      firsts_.push_back(k);
  take(space, data);
  addSources(places);
  takeOffFree();
  follow();
  addLine();
  addDipoles(places);
  compare(space.mesh());
  std::array<std::vector<bem::LocalField>, 2> fields;
  for (std::size_t k = 0; k < parts_.size(); ++k)
    for (const bool isPotential : {false, true})
      fields[isPotential ? 1 : 0].push_back(fieldOf(k, isPotential));
  for (std::vector<bem::LocalField>& field : fields)
    inside_.emplace_back(mesh_, bem::lameOfLaplace(true), std::move(field));
}

void RingHeat::take(const bem::Space& space, const Vector& data) {
  const bem::Mesh& mesh = space.mesh();
  for (Part& part : parts_) {
    const int e = part.element;
    const bem::Matrix phi = bem::DisplacementBasis::legendreCoefficients(mesh[e].degree);
    Series temperature{};
    Series flow{};
    for (int k = 0; k <= mesh[e].degree; ++k)
      for (int j = 0; j <= mesh[e].degree; ++j)
        temperature[bem::at(j)] += phi(j, k) * data[bem::at(potentialOf(space, e, k))];
    for (int i = 0; i < mesh[e].densities; ++i)
      flow[bem::at(i)] = data[bem::at(flowOf(space, e, i))];
    const auto inPart = [&](const Series& series) {
      const double middle = 0.5 * (part.from + part.to);
      const double half = 0.5 * (part.to - part.from);
      return bem::project([&](double t) { return valueOf(series, middle + half * t); },
                          degree);
    };
    part.temperature = inPart(temperature);
    part.flow = inPart(flow);
  }
}

// What goes in comes out, if not quite: the rest leaves each surface uniformly.
void RingHeat::follow() {
  for (std::size_t k = 0; k < surfaces_.size(); ++k) {
    double rest = 0;
    for (const int e : surfaces_[k].elements) {
      Part& part = parts_[bem::at(e)];
      const bem::Curve& curve = mesh_[e].curve;
      part.rest = bem::project(
          [&](double t) {
            const Vec2 y = curve.point(t);
            return valueOf(part.temperature, t) - free_[0] - free_[1] * y.y -
                   sources_.at(y).temperature;
          },
          degree);
      part.restSlope = slopeOf(part.rest, mesh_[e].half);
      part.restFlow = bem::project(
          [&](double t) {
            const Vec2 normal = curve.normal(t);
            return valueOf(part.flow, t) - free_[1] * normal.y -
                   dot(sources_.at(curve.point(t)).slope, normal);
          },
          degree);
    }
    forEachPoint(mesh_, surfaces_[k].elements, [&](int e, double t, double weight) {
      rest += weight / surfaces_[k].size * valueOf(parts_[bem::at(e)].restFlow, t);
    });
    for (const int e : surfaces_[k].elements)
      parts_[bem::at(e)].restFlow[0] -= rest;
    integrateFlow(k);
    gains_[k] = integrateSlope(k);
  }
}

// From the axis on to where the surface is farthest from it, and from its other end likewise.
void RingHeat::integrateFlow(std::size_t surface) {
  const std::vector<int>& elements = surfaces_[surface].elements;
  const auto radius = [&](int e) { return mesh_.scaledPoint(e, 1).x; };
  const auto turn = surfaces_[surface].isClosed
                        ? elements.end()
                        : std::max_element(elements.begin(), elements.end(),
                                           [&](int e, int f) { return radius(e) < radius(f); });
  // ∫ r q ds from one end of an element, -1 or 1, to t
  const auto along = [&](int e, double end, double t) {
    const bem::Rule& rule = bem::gaussLegendre(largestDegree);
    double sum = 0;
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
      const double s = end + 0.5 * (t - end) * (1 + rule.points[q]);
      sum += rule.weights[q] * mesh_[e].curve.point(s).x *
             valueOf(parts_[bem::at(e)].restFlow, s);
    }
    return 0.5 * (t - end) * mesh_[e].half * sum;
  };
  const auto take = [&](int e, double end, double start) {
    parts_[bem::at(e)].around = bem::project(
        [&](double t) {
          const double r = mesh_[e].curve.point(t).x;
          return (start + along(e, end, t)) / (r * r);
        },
        degree);
    return start + along(e, end, -end);
  };
  double sum = flowStarts_[surface];
  for (auto e = elements.begin(); e != turn; ++e)
    sum = take(*e, -1, sum);
  sum = flowStarts_[surface];
  for (auto e = elements.end(); e != turn; --e)
    sum = take(*(e - 1), 1, sum);
}

double RingHeat::integrateSlope(std::size_t surface) {
  const bem::Surface& own = surfaces_[surface];
  const auto slope = [&](int e, double t) {
    const Part& part = parts_[bem::at(e)];
    const Vec2 tangent = mesh_[e].curve.tangent(t);
    return tangent.x * mesh_[e].curve.point(t).x * valueOf(part.around, t) +
           tangent.y * valueOf(part.rest, t);
  };
  double length = 0;
  double gain = 0;
  std::vector<Series> slopes;
  for (const int e : own.elements) {
    slopes.push_back(bem::project([&](double t) { return slope(e, t); }, degree));
    length += 2 * mesh_[e].half;
    gain += 2 * mesh_[e].half * slopes.back()[0];
  }
  double start = potentialStarts_[surface];
  for (std::size_t k = 0; k < slopes.size(); ++k) {
    if (own.isClosed)
      slopes[k][0] -= gain / length;
    const int e = own.elements[k];
    parts_[bem::at(e)].potential = runningIntegral(slopes[k], mesh_[e].half, start);
    start = valueOf(parts_[bem::at(e)].potential, 1);
  }
  return own.isClosed ? gain : 0;
}

void RingHeat::addSources(const Places& places) {
  for (std::size_t k = 1; k < surfaces_.size(); ++k) {
    double flow = 0;
    forEachPoint(mesh_, surfaces_[k].elements, [&](int e, double t, double weight) {
      flow += weight * valueOf(parts_[bem::at(e)].flow, t);
    });
    for (const Complex& place : places[k - 1])
      sources_.add({bem::asVector(place), flow / static_cast<double>(places[k - 1].size())});
  }
}

void RingHeat::addDipoles(const Places& places) {
  for (std::size_t k = 1; k < surfaces_.size(); ++k)
    for (const Complex& place : places[k - 1])
      if (surfaces_[k].isClosed)
        sources_.add({bem::asVector(place), 0,
                      place.real() * gains_[k] /
                          (fourPi * static_cast<double>(places[k - 1].size()))});
  if (surfaces_.size() > 1)
    follow();
}

// S of log r is r ∂/∂r log r z = z.
void RingHeat::addLine() {
  if (!surfaces_[0].isClosed)
    return;
  std::array<double, 5> of{};  // of 1, z and S
  forEachPoint(mesh_, surfaces_[0].elements, [&](int e, double t, double weight) {
    const Vec2 y = mesh_.scaledPoint(e, t);
    const double s = y.x * y.x * valueOf(parts_[bem::at(e)].around, t);
    const double terms[] = {1, y.y, y.y * y.y, s, y.y * s};
    for (std::size_t i = 0; i < of.size(); ++i)
      of[i] += weight * terms[i];
  });
  const auto [start, slope] = fitOf(of[0], of[1], of[2], of[3], of[4]);
  sources_.addLine(slope);
  const double z = mesh_.scaledPoint(surfaces_[0].elements.front(), -1).y;
  flowStarts_[0] = -start - slope * z;
  takeOffFree();
  follow();
}

void RingHeat::takeOffFree() {
  std::array<double, 5> of{};  // of 1, z and T without sources
  for (const bem::Surface& surface : surfaces_)
    forEachPoint(mesh_, surface.elements, [&](int e, double t, double weight) {
      const Vec2 y = mesh_.scaledPoint(e, t);
      const double rest =
          valueOf(parts_[bem::at(e)].temperature, t) - sources_.at(y).temperature;
      const double terms[] = {1, y.y, y.y * y.y, rest, y.y * rest};
      for (std::size_t i = 0; i < of.size(); ++i)
        of[i] += weight * terms[i];
    });
  free_ = fitOf(of[0], of[1], of[2], of[3], of[4]);
}

bem::LocalField RingHeat::fieldOf(std::size_t part, bool isPotential) const {
  const Part& own = parts_[part];
  const bem::Curve& curve = mesh_[bem::asInt(static_cast<bem::Index>(part))].curve;
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
  const bem::Mesh tested = meshOf(mesh, parts_, more);
  std::vector<bem::LocalField> fields;
  for (std::size_t k = 0; k < parts_.size(); ++k)
    for (const bool isPotential : {false, true})
      fields.push_back(fieldOf(k, isPotential));
  const bem::RingFields residuals(tested, bem::lameOfLaplace(true), fields, 2);
  const auto imaginary = [&](const bem::LegendreSeries<Complex>& series, double t) {
    return bem::evaluate(series, largestDegree, t).imag();
  };
  for (std::size_t k = 0; k < surfaces_.size(); ++k) {
    std::array<double, 5> of{};  // of 1, log r and Ψ's residual
    forEachPoint(tested, surfaces_[k].elements, [&](int e, double t, double weight) {
      const bem::RingFields::Series& series = residuals.of(e, 0);
      const Part& part = parts_[bem::at(e)];
      const double size = 2 * tested[e].half / tested[e].degree;
      missed_[bem::at(part.element)] +=
          weight *
          (std::pow(imaginary(series.mismatch, t), 2) +
           std::pow(size * (imaginary(series.traction, t) - valueOf(part.restFlow, t)), 2));
      const double log =
          surfaces_[k].isClosed ? std::log(tested.scaledPoint(e, t).x) : 0;
      const double rest = imaginary(residuals.of(e, 1).mismatch, t);
      const double terms[] = {1, log, log * log, rest, log * rest};
      for (std::size_t i = 0; i < of.size(); ++i)
        of[i] += weight * terms[i];
    });
    const auto [constant, ofLog] = fitOf(of[0], of[1], of[2], of[3], of[4]);
    if (k == 0)
      continue;
    const double start = tested.scaledPoint(surfaces_[k].elements.front(), -1).x;
    flowStarts_[k] = ofLog;
    potentialStarts_[k] = constant + (ofLog == 0 ? 0 : ofLog * std::log(start));
  }
  if (surfaces_.size() > 1)
    follow();
}

Vec2 RingHeat::freeAt(Vec2 y) const {
  return {free_[0] * y.x + free_[1] * y.x * y.y,
          free_[0] * y.y + 0.5 * free_[1] * (y.y * y.y - y.x * y.x)};
}

// Φ = z Ψ/2; Laplace's equation gives ∂²Ψ/∂r².
std::vector<RingHeat::Value> RingHeat::at(const std::vector<Vec2>& points) const {
  std::vector<Value> values(points.size());
  constexpr double ofRing = 400;  // ns
  bem::parallelFor(
      {static_cast<bem::Index>(points.size()),
       ofRing * static_cast<double>(points.size()) * mesh_.size()},
      [&](bem::Index k) {
        constexpr double close = 1e-5;  // to the axis
        const Vec2 x = points[bem::at(k)];
        const bem::InteriorValue rest = inside_[0].at(x);
        const bem::InteriorValue potential = inside_[1].at(x);
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
        value.stress = BodyStress{-0.5 * x.y * (second.y + around) - slope.y,
                                  0.5 * x.y * second.y,
                                  0.5 * (slope.x + x.y * second.x),
                                  0.5 * x.y * around - slope.y} +
                       of.stress;
      });
  return values;
}

// ∇∇Φ τ is the derivative of ∇Φ along the surface, the rest of ∇∇Φ follows from its trace.
RingHeat::Value RingHeat::on(int element, double t) const {
  const int first = bem::asInt(static_cast<bem::Index>(firsts_[bem::at(element)]));
  if (mesh_.isAxis(first)) {
    const auto neighbour = [&](int part) { return parts_[bem::at(part)].element; };
    if (t <= -1)
      return on(neighbour(mesh_[first].previous), 1);
    return t >= 1 ? on(neighbour(mesh_[first].next), -1)
                  : at({mesh_.scaledPoint(first, t)})[0];
  }
  std::size_t k = firsts_[bem::at(element)];
  while (parts_[k].to < t && parts_[k].to < 1)
    ++k;
  const Part& part = parts_[k];
  const double s = part.from == -1 && part.to == 1
                       ? t
                       : -1 + 2 * (t - part.from) / (part.to - part.from);
  const bem::Curve& curve = mesh_[bem::asInt(static_cast<bem::Index>(k))].curve;
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
  value.stress = BodyStress{mean + difference - rest, mean - difference - rest, shear,
                            hoop - rest} +
                 of.stress;
  value.flow = valueOf(part.flow, s);
  value.stressingFlow = flow + dot(of.slope, normal);
  return value;
}

}  // namespace epafi::contact
