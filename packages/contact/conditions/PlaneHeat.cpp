#include "contact/conditions/PlaneHeat.hpp"

#include "bem/base/Parallel.hpp"
#include "bem/compressed/Laplace.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace epafi::contact {

using bem::asComplex;
using bem::asVector;
using bem::Complex;
using bem::largestDegree;
using bem::Vec2;
using bem::Vector;

namespace {

using Series = bem::CauchyIntegral::Series;
constexpr double twoPi = 6.283185307179586;
constexpr Complex imaginary{0, 1};

Complex valueOf(const Series& series, double t) {
  return bem::evaluate(series, largestDegree, t);
}

/// half ∫ f dt from -1 on.
Series runningIntegral(const Series& f, double half, Complex start) {
  Series sum{};
  sum[0] = start + half * f[0];
  sum[1] = half * f[0];
  for (std::size_t k = 1; k < largestDegree; ++k) {
    const Complex c = half / (2.0 * static_cast<double>(k) + 1) * f[k];
    sum[k + 1] += c;
    sum[k - 1] -= c;
  }
  return sum;
}

/// f τ, of which the last term is left for its integral.
Series timesTangent(const Series& f, const bem::Curve& curve) {
  return bem::project(
      [&](double t) { return valueOf(f, t) * asComplex(curve.tangent(t)); },
      largestDegree - 1);
}

/// Of a function of the place y on an element.
template <class Function>
Series seriesOf(const bem::Mesh& mesh, int e, const Function& function) {
  return bem::project(
      [&](double t) -> Complex { return function(asComplex(mesh.scaledPoint(e, t))); },
      largestDegree);
}

void add(Complex factor, const Series& series, Series& to) {
  for (std::size_t k = 0; k < to.size(); ++k)
    to[k] += factor * series[k];
}

/// ∮ f ds of the series f of the elements.
template <class SeriesOf>
Complex around(const std::vector<int>& elements, const bem::Mesh& mesh,
               const SeriesOf& seriesOfElement) {
  Complex sum;
  for (const int e : elements)
    sum += 2 * mesh[e].half * seriesOfElement(e)[0];
  return sum;
}

/// Places in a hole, along its middle: as far from the boundary as from each other; of a circle its
/// centre.
// NOLINTNEXTLINE(readability-function-cognitive-complexity): loops over curves and samples
std::vector<Complex> placesIn(const bem::Outline& outline, int loop) {
  std::vector<const bem::Curve*> curves;
  for (const bem::Edge& edge : outline.edges())
    if (edge.loop == loop)
      curves.push_back(&edge.curve);
  const int samples = std::clamp(256 / static_cast<int>(curves.size()), 4, 64);
  std::vector<Complex> line;
  for (const bem::Curve* curve : curves)
    for (int i = 0; i < samples; ++i)
      line.push_back(asComplex(curve->point(-1 + (2.0 * i) / samples)));
  double size = 0;
  for (const Complex y : line)
    size = std::max(size, 0.5 * std::abs(y - line.front()));
  const auto distance = [&](Complex z) {
    double least = size;
    for (const bem::Curve* curve : curves)
      least = std::min(least, curve->distance(asVector(z)));
    return least;
  };
  // does a ray to the right leave the hole?
  const auto isIn = [&](Complex z) {
    bool isOdd = false;
    for (std::size_t k = 0; k < line.size(); ++k) {
      const Complex a = line[k] - z;
      const Complex b = line[(k + 1) % line.size()] - z;
      if ((a.imag() > 0) != (b.imag() > 0))
        isOdd ^= (a.real() * b.imag() - a.imag() * b.real() > 0) == (b.imag() > 0);
    }
    return isOdd;
  };
  std::vector<std::pair<double, Complex>> found;
  for (const bem::Curve* curve : curves)
    for (int i = 0; i < samples; ++i) {
      const double t = -1 + (2.0 * i + 1) / samples;
      std::pair<double, Complex> best;
      constexpr int ways = 42;  // down to 1e-4 of the size
      double way = size;
      for (int k = 0; k < ways; ++k, way *= 0.8) {
        const Complex z = asComplex(curve->point(t) + way * curve->normal(t));
        if (const double depth = distance(z); depth > best.first && isIn(z))
          best = {depth, z};
      }
      found.push_back(best);
    }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& x, const auto& y) { return x.first > y.first; });
  constexpr std::size_t most = 64;
  std::vector<std::pair<double, Complex>> chosen;
  for (const auto& [depth, z] : found)
    if (chosen.size() < most && depth > 0.5 * found.front().first &&
        std::all_of(chosen.begin(), chosen.end(),
                    [&, z = z, depth = depth](const auto& c) {
                      return std::abs(c.second - z) >= 0.5 * (c.first + depth);
                    }))
      chosen.emplace_back(depth, z);
  std::vector<Complex> places;
  places.reserve(chosen.size());
  for (const auto& [depth, z] : chosen)
    places.push_back(z);
  return places;
}

}  // namespace

PlaneHeat::Places PlaneHeat::placesInHoles(const bem::Outline& outline) {
  Places places;
  for (int loop = 1; loop < outline.loops(); ++loop)
    places.push_back(placesIn(outline, loop));
  return places;
}

PlaneHeat::PlaneHeat(const bem::Space& space, const Vector& data, const Places& places,
                     Vector errors)
    : missed_(std::move(errors)) {
  const bem::Mesh& mesh = space.mesh();
  for (int e = 0; e < mesh.size(); ++e) {
    const int degree = mesh[e].degree;
    const bem::Matrix phi = bem::DisplacementBasis::legendreCoefficients(degree);
    Series& temperature = temperatures_.emplace_back();
    for (int k = 0; k <= degree; ++k)
      for (int j = 0; j <= degree; ++j)
        temperature[bem::at(j)] += phi(j, k) * data[bem::at(potentialOf(space, e, k))];
    Series& flow = flows_.emplace_back();
    for (int i = 0; i < mesh[e].densities; ++i)
      flow[bem::at(i)] = data[bem::at(flowOf(space, e, i))];
  }
  const std::vector<bem::Surface> loops = bem::surfacesOf(mesh);
  cauchy_.emplace(mesh, densities(mesh, loops, places));
  follow(loops);
}

// f = T + i ∫ q ds along each loop, less what the sources have; what goes in comes out, if not
// quite: the rest leaves the outer loop uniformly.
void PlaneHeat::startDensities(const bem::Mesh& mesh,
                               const std::vector<bem::Surface>& loops,
                               const Places& places, std::vector<Pair>& densities) {
  const auto flowOf = [&](int e) { return flows_[bem::at(e)]; };
  double rest = 0;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const double flow = around(loops[k].elements, mesh, flowOf).real();
    rest += flow / loops[0].size;
    for (std::size_t i = 0; k > 0 && i < places[k - 1].size(); ++i)
      sources_.push_back({places[k - 1][i],
                          -flow / twoPi / static_cast<double>(places[k - 1].size()),
                          Complex{}});
  }
  for (const bem::Surface& loop : loops) {
    Complex start;
    for (const int e : loop.elements) {
      Series& f = densities[bem::at(e)][0];
      f = temperatures_[bem::at(e)];
      Series q = flows_[bem::at(e)];
      if (!sources_.empty()) {
        add(-1, seriesOf(mesh, e, [&](Complex y) { return ofSources(y).temperature; }),
            f);
        const auto flow = [&](double t) -> Complex {
          return (ofSources(asComplex(mesh.scaledPoint(e, t))).slope *
                  asComplex(mesh[e].curve.normal(t)))
              .real();
        };
        add(-1, bem::project(flow, largestDegree), q);
      }
      if (&loop == &loops[0])
        q[0] -= rest;
      const Series conjugate = runningIntegral(q, mesh[e].half, start);
      start = valueOf(conjugate, 1);
      add(imaginary, conjugate, f);
    }
  }
}

// Each loop's imaginary constant and that of ∫ f dy are its own: inside a hole's they do nothing,
// of the outer one they are a rigid motion.
std::vector<PlaneHeat::Pair> PlaneHeat::densities(const bem::Mesh& mesh,
                                                  const std::vector<bem::Surface>& loops,
                                                  const Places& places) {
  std::vector<Pair> all(bem::at(mesh.size()));
  startDensities(mesh, loops, places, all);
  const auto along = [&](int e) {
    return timesTangent(all[bem::at(e)][0], mesh[e].curve);
  };
  std::size_t next = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {  // holes run clockwise
    const Complex gain = around(loops[k + 1].elements, mesh, along);
    for (std::size_t i = 0; i < places[k].size(); ++i)
      sources_[next++].dipole =
          imaginary / twoPi / static_cast<double>(places[k].size()) * gain;
  }
  for (int e = 0; e < mesh.size() && !sources_.empty(); ++e)
    add(-1,
        seriesOf(mesh, e,
                 [&](Complex y) {
                   Complex sum;
                   for (const Source& source : sources_)
                     sum += source.dipole / (y - source.place);
                   return sum;
                 }),
        all[bem::at(e)][0]);
  // ∮ ȳ dy = 2i area
  const auto conjugate = [&](int e) {
    return seriesOf(mesh, e, [](Complex y) { return std::conj(y); });
  };
  const Complex gain = around(loops[0].elements, mesh, along) /
                       around(loops[0].elements, mesh, [&](int e) {
                         return timesTangent(conjugate(e), mesh[e].curve);
                       });
  for (const int e : loops[0].elements)
    add(-gain, conjugate(e), all[bem::at(e)][0]);
  for (const bem::Surface& loop : loops) {
    const auto meanOf = [&](std::size_t n) {
      return around(loop.elements, mesh, [&](int e) { return all[bem::at(e)][n]; }) /
             loop.size;
    };
    const Complex turning(0, meanOf(0).imag());
    Complex start;
    for (const int e : loop.elements) {
      auto& [f, integral] = all[bem::at(e)];
      f[0] -= turning;
      integral = runningIntegral(along(e), mesh[e].half, start);
      start = valueOf(integral, 1);
    }
    const Complex shift = meanOf(1);
    for (const int e : loop.elements)
      all[bem::at(e)][1][0] -= shift;
  }
  return all;
}

void PlaneHeat::follow(const std::vector<bem::Surface>& loops) {
  const bem::Mesh& mesh = cauchy_->mesh();
  integrals_.resize(bem::at(mesh.size()));
  std::vector<std::vector<Complex>> missed(bem::at(mesh.size()));
  constexpr double ofPair = 2e3;  // ns
  const auto size = static_cast<bem::Index>(mesh.size());
  bem::parallelFor({size, ofPair * static_cast<double>(size * size)}, [&](bem::Index e) {
    constexpr int beyond = 7;
    const int degree = std::min(mesh[bem::asInt(e)].degree + beyond, largestDegree);
    const bem::Rule& rule = bem::gaussLegendre(degree + 1);
    const auto values = cauchy_->on(bem::asInt(e), rule.points);
    std::size_t next = 0;
    integrals_[bem::at(e)] =
        bem::project([&](double) { return values[next++][1]; }, degree);
    for (std::size_t q = 0; q < values.size(); ++q)
      missed[bem::at(e)].push_back(
          values[q][0] - valueOf(cauchy_->density(bem::asInt(e))[0], rule.points[q]));
  });
  const auto forEachPoint = [&](const bem::Surface& loop, const auto& visit) {
    for (const int e : loop.elements) {
      const bem::Rule& rule =
          bem::gaussLegendre(static_cast<int>(missed[bem::at(e)].size()));
      for (std::size_t q = 0; q < rule.points.size(); ++q)
        visit(e, mesh[e].half * rule.weights[q], missed[bem::at(e)][q]);
    }
  };
  for (const bem::Surface& loop : loops) {
    double turning = 0;
    forEachPoint(loop, [&](int, double weight, Complex value) {
      turning += weight / loop.size * value.imag();
    });
    forEachPoint(loop, [&](int e, double weight, Complex value) {
      missed_[bem::at(e)] += weight * std::norm(value - imaginary * turning);
    });
  }
}

PlaneHeat::Value PlaneHeat::whole(const OfSources& of, double temperature,
                                  Complex integral) {
  const double mean = -0.5 * of.temperature;
  const Complex rest = 0.25 * of.secondSlopes;
  Value value;
  value.temperature = temperature;
  value.free = asVector(integral);
  value.potential = of.potential;
  value.gradient = asVector(of.gradient);
  value.stress = {mean + rest.real(), mean - rest.real(), rest.imag()};
  value.stressing = of.temperature;
  return value;
}

std::vector<PlaneHeat::Value> PlaneHeat::at(const std::vector<Vec2>& points) const {
  const auto pairs = cauchy_->at(points);
  std::vector<Value> values;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const OfSources of = ofSources(asComplex(points[k]));
    values.push_back(whole(of, pairs[k][0].real() + of.temperature, pairs[k][1]));
  }
  return values;
}

PlaneHeat::Value PlaneHeat::on(int element, double t) const {
  const bem::Mesh& mesh = cauchy_->mesh();
  const OfSources of = ofSources(asComplex(mesh.scaledPoint(element, t)));
  Value value = whole(of, valueOf(temperatures_[bem::at(element)], t).real(),
                      valueOf(integrals_[bem::at(element)], t));
  value.flow = valueOf(flows_[bem::at(element)], t).real();
  value.stressingFlow = (of.slope * asComplex(mesh[element].curve.normal(t))).real();
  return value;
}

// Φ = A |w|² (log|w| - 1)/4 + Re(C w̄) log|w|/2
PlaneHeat::OfSources PlaneHeat::ofSources(Complex z) const {
  OfSources sum;
  for (const auto& [place, a, c] : sources_) {
    const Complex w = z - place;
    const Complex direction = w / std::conj(w);
    const double square = std::norm(w);
    const double log = 0.5 * std::log(square);
    sum.temperature += a * log + (c / w).real();
    sum.slope += a / w - c / (w * w);
    sum.potential +=
        0.25 * a * square * (log - 1) + 0.5 * (c * std::conj(w)).real() * log;
    sum.gradient +=
        0.25 * (a * (2 * log - 1) * w + (2 * log + 1) * c + std::conj(c) * direction);
    sum.secondSlopes += a * direction + (c - std::conj(c) * direction) / std::conj(w);
  }
  return sum;
}

}  // namespace epafi::contact
