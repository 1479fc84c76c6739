#include "contact/conditions/RingPotential.hpp"

#include <algorithm>

namespace epafi::contact {

using bem::largestDegree;
using bem::Vec2;
using bem::Vector;

namespace {

/// Of all series but Ψ, which is the integral of one.
constexpr int degree = largestDegree - 1;

double valueOf(const RingPotential::Series& series, double t) {
  return bem::evaluate(series, largestDegree, t);
}

/// ∫ f along the element from -1 on.
RingPotential::Series runningIntegral(const RingPotential::Series& f, double half,
                                      double start) {
  RingPotential::Series sum{};
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
RingPotential::Series slopeOf(const RingPotential::Series& f, double half) {
  RingPotential::Series slope{};
  double sums[2] = {};
  for (std::size_t k = largestDegree; k > 0; --k) {
    sums[k % 2] += f[k];
    slope[k - 1] = (2.0 * static_cast<double>(k) - 1) / half * sums[k % 2];
  }
  return slope;
}

}  // namespace

std::vector<RingPotential::Part> RingPotential::partsOf(const bem::Mesh& mesh) {
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

bem::Mesh RingPotential::meshOf(const bem::Mesh& mesh, int more) const {
  std::vector<bem::Piece> pieces;
  for (const Part& part : parts_) {
    const bem::Piece& piece = mesh[part.element].piece;
    pieces.push_back({piece.edge,
                      part.from == -1 ? piece.start : positionAt(piece, part.from),
                      part.to == 1 ? piece.end : positionAt(piece, part.to),
                      std::min(mesh[part.element].degree + more, largestDegree)});
  }
  return {mesh.sharedOutline(), pieces};
}

RingPotential::RingPotential(const bem::Space& space, const Vector& data)
    : parts_(partsOf(space.mesh())),
      mesh_(meshOf(space.mesh(), largestDegree)),
      surfaces_(bem::surfacesOf(mesh_)),
      flowStarts_(surfaces_.size()),
      potentialStarts_(surfaces_.size()),
      gains_(surfaces_.size()) {
  take(space, data);
}

void RingPotential::take(const bem::Space& space, const Vector& data) {
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
void RingPotential::follow(const RingSources& sources, const Free& free) {
  for (std::size_t k = 0; k < surfaces_.size(); ++k) {
    double rest = 0;
    for (const int e : surfaces_[k].elements) {
      Part& part = parts_[bem::at(e)];
      const bem::Curve& curve = mesh_[e].curve;
      part.rest = bem::project(
          [&](double t) {
            const Vec2 y = curve.point(t);
            return valueOf(part.temperature, t) - free[0] - free[1] * y.y -
                   sources.at(y).temperature;
          },
          degree);
      part.restSlope = slopeOf(part.rest, mesh_[e].half);
      part.restFlow = bem::project(
          [&](double t) {
            const Vec2 normal = curve.normal(t);
            return valueOf(part.flow, t) - free[1] * normal.y -
                   dot(sources.at(curve.point(t)).slope, normal);
          },
          degree);
    }
    forEachPoint(k, [&](int e, double t, double weight) {
      rest += weight / surfaces_[k].size * valueOf(parts_[bem::at(e)].restFlow, t);
    });
    for (const int e : surfaces_[k].elements)
      parts_[bem::at(e)].restFlow[0] -= rest;
    integrateFlow(k);
    gains_[k] = integrateSlope(k);
  }
}

// From the axis on to where the surface is farthest from it, and from its other end likewise.
void RingPotential::integrateFlow(std::size_t surface) {
  const std::vector<int>& elements = surfaces_[surface].elements;
  const auto radius = [&](int e) { return mesh_.scaledPoint(e, 1).x; };
  const auto turn =
      surfaces_[surface].isClosed
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

double RingPotential::integrateSlope(std::size_t surface) {
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

}  // namespace epafi::contact
