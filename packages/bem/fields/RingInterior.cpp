#include "bem/fields/RingInterior.hpp"

#include "bem/base/Parallel.hpp"
#include "bem/moments/RingKernels.hpp"
#include "bem/simd/Dispatch.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::bem {

/// u = (cρ, u₀ + e(z - z₀)), e = -2ν/(1-ν) c: no stress along the axis, the same one across it.
struct RingInterior::Uniform {
  double radial = 0;  ///< c
  double axial = 0;   ///< e
  double start = 0;   ///< u₀
  double height = 0;  ///< z₀
  double stress = 0;
};

/// u_r and u_z with their derivatives, λ div u.
struct RingInterior::Sum {
  double r[3] = {};
  double z[3] = {};
  double pressure = 0;
};

namespace {

double sumOf(const Pack& x) {
  return ((x[0] + x[1]) + (x[2] + x[3])) + ((x[4] + x[5]) + (x[6] + x[7]));
}

/// Parameter of the largest ellipse with foci ±1 that does not contain z.
double ellipse(const Complex& z) {
  constexpr double far = 1e3;
  const double distance = std::abs(z);
  if (!(distance < far))
    return far;
  const double sum = std::abs(z + std::sqrt(z - 1.0) * std::sqrt(z + 1.0));
  return std::max(sum, 1 / sum);
}

/// Number of packs of Gauss points for a polynomial of a degree times the kernels; more than the
/// largest if no rule will do.
int packsFor(double ellipse, int degree, int largest) {
  constexpr double digits = 40;  // log of the error
  int packs = 1;
  while (packs <= largest && (2 * lanes * packs - degree) * std::log(ellipse) < digits)
    ++packs;
  return packs;
}

/// Adds what eight points do to x.
template <class Sources, class Uniform, class Sum>
struct Addition {
  const Sources& from;
  const ComplexLanes* w;  ///< x - y where it is known better
  Vec2 x;
  const RingLame& lame;
  double ofPressure;  ///< 4μν
  const Uniform& uniform;
  Sum& to;

  template <Division How>
  EPAFI_INLINE void run() const {
    constexpr double laplace = 0.079577471545947668;  // 1/4π
    const ComplexPack place = from.place.load();
    const ComplexPack tangent = from.tangent.load();
    const ComplexPack value = from.value.load();
    const ComplexPack slope = from.slope.load();
    const ComplexPack density = from.density.load();
    const Pack& weight = load(from.weight.lane);
    const Pack& radius = place.re;
    const Pack area = weight * radius;
    const Pack zero{};
    const Pack& nr = tangent.im;
    const Pack nz = -tangent.re;

    // without the uniform state; u_r as it is, all else times the radius
    const Pack ur = weight * (value.re - uniform.radial * radius);
    const Pack uz =
        area * (value.im - uniform.start - uniform.axial * (place.im - uniform.height));
    const Pack sr = area * (slope.re - uniform.radial * tangent.re);
    const Pack sz = area * (slope.im - uniform.axial * tangent.im);
    const Pack a = area * (density.re - uniform.stress * nr);
    const Pack b = area * density.im;
    const Pack mr = -sz - nr * ur;  // M u
    const Pack mz = sr - nz * ur;
    const Pack pr = lame.b * a - lame.doubled * mr;  // times P
    const Pack pz = lame.b * b - lame.doubled * mz;
    const Pack er = lame.a * a - (lame.doubled * lame.part) * mr;  // times E₁
    const Pack ez = lame.a * b - (lame.doubled * lame.part) * mz;  // times E₀
    const Pack kr = (laplace * radius) * ur;
    const Pack kz = laplace * uz;

    const ComplexPack off =
        w != nullptr ? w->load() : ComplexPack{x.x - radius, x.y - place.im};
    const RingJet dr{off.re, zero + 1.0, zero};
    const RingJet dz{off.im, zero, zero + 1.0};
    const RingJet rho{zero + x.x, zero + 1.0, zero};
    const RingJet product = radius * rho;
    RingFunctionsOf<RingJet> ring;
    ringFunctions<How>(dr * dr + dz * dz, 4.0 * product, ring);
    const RingJet sum = ring.g1 + ring.g2;
    const RingJet difference = ring.g1 - ring.g2;
    const RingJet drSum = dr * sum;
    const RingJet outer = drSum + (2.0 * radius) * ring.g2;
    const RingJet inner = drSum - 2.0 * (rho * ring.g2);
    const RingJet dzSum = dz * sum;
    const RingJet flow = nr * dr + nz * dz;
    const RingJet across = (2.0 * nr) * rho;

    const RingJet radial =
        er * ring.e1 + pr * (dr * dr * difference - 4.0 * (product * ring.g3)) +
        pz * (dz * outer) - kr * (flow * difference - across * (ring.g2 - 2.0 * ring.g3));
    const RingJet axial = ez * ring.e0 + pr * (dz * inner) + pz * (dz * dzSum) -
                          kz * (flow * sum - across * ring.g2);
    const Pack pressure = pr * inner.value + pz * dzSum.value;
    to.r[0] += sumOf(radial.value);
    to.r[1] += sumOf(radial.r);
    to.r[2] += sumOf(radial.z);
    to.z[0] += sumOf(axial.value);
    to.z[1] += sumOf(axial.r);
    to.z[2] += sumOf(axial.z);
    to.pressure -= ofPressure * sumOf(pressure);
  }
};

}  // namespace

RingInterior::RingInterior(const Mesh& mesh, const Lame& lame,
                           std::vector<LocalField> fields)
    : mesh_(mesh), lame_(lame), fields_(std::move(fields)) {
  std::vector<Curve> curves;
  for (int e = 0; e < mesh_.size(); ++e)
    if (!mesh_.isAxis(e)) {
      elements_.push_back(e);
      curves.push_back(mesh_[e].curve);
    }
  surface_ = CurveTree(std::move(curves));
  for (int e = 0; e < mesh_.size(); ++e)
    for (int size = 1; size <= packs; ++size) {
      const Rule& rule = gaussLegendre(size * lanes);
      for (int k = 0; k < size; ++k)
        whole_.push_back(sources(e, &rule.points[k * lanes], &rule.weights[k * lanes]));
    }
}

RingInterior::Sources RingInterior::sources(int e, const double* places,
                                            const double* weights) const {
  const Element& element = mesh_[e];
  const LocalField& field = fields_[bem::at(e)];
  Sources to;
  for (int lane = 0; lane < lanes; ++lane) {
    const double t = places[lane];
    to.weight.lane[lane] = element.half * weights[lane];
    to.place.set(lane, asComplex(element.curve.point(t)));
    to.tangent.set(lane, asComplex(element.curve.tangent(t)));
    to.value.set(lane, evaluate(field.value, element.degree, t));
    to.slope.set(lane, evaluate(field.slope, element.degree - 1, t));
    to.density.set(lane, evaluate(field.density, element.densities - 1, t));
  }
  return to;
}

RingInterior::Uniform RingInterior::uniformOf(double radial, double start,
                                              double height) const {
  const double nu = lame_.nu;
  return {radial, -2 * nu / (1 - nu) * radial, start, height,
          2 * lame_.mu * (1 + nu) / (1 - nu) * radial};
}

RingInterior::Uniform RingInterior::uniformNear(Vec2 x) const {
  const auto [curve, t, distance] = surface_.nearest(x);
  const int closest = elements_[curve];
  const Element& element = mesh_[closest];
  const Vec2 place = element.curve.point(t);
  const Complex u = evaluate(fields_[bem::at(closest)].value, element.degree, t);
  return uniformOf(place.x > 0 ? u.real() / place.x : 0, u.imag(), place.y);
}

void RingInterior::add(int e, Vec2 x, const Uniform& uniform, Sum& sum) const {
  constexpr int deepest = 50;
  constexpr int ofArcs = 8;  // degrees that normals of arcs are worth
  const Element& element = mesh_[e];
  const int degree = std::max(element.degree, element.densities) +
                     (element.curve.isStraight() ? 0 : ofArcs);
  const RelativeTarget target = element.curve.seen(x);
  const Complex image = element.curve.seen({-x.x, x.y}).z;
  const RingLame lame(lame_);
  const auto addPart = [&](const Sources& from, const ComplexLanes* w) {
    dispatch(Addition<Sources, Uniform, Sum>{from, w, x, lame, 4 * lame_.mu * lame_.nu,
                                             uniform, sum});
  };
  const auto addBetween = [&](double from, double to, int depth,
                              const auto& self) -> void {
    const double middle = 0.5 * (from + to);
    const double half = 0.5 * (to - from);
    // from the nearer end, where an end of the element is the singular point
    const Complex z = middle < 0 ? (target.zPlus1 - (1 + middle)) / half
                                 : (target.zMinus1 + (1 - middle)) / half;
    const int count =
        packsFor(std::min(ellipse(z), ellipse((image - middle) / half)), degree, packs);
    if (count > packs && depth < deepest) {
      self(from, middle, depth + 1, self);
      self(middle, to, depth + 1, self);
      return;
    }
    const int size = std::min(count, packs);
    if (depth == 0) {
      const std::size_t first =
          bem::at(e) * (packs * (packs + 1) / 2) + bem::at(size * (size - 1) / 2);
      for (int k = 0; k < size; ++k)
        addPart(whole_[first + bem::at(k)], nullptr);
      return;
    }
    const Rule& rule = gaussLegendre(size * lanes);
    for (int k = 0; k < size; ++k) {
      double places[lanes];
      double weights[lanes];
      ComplexLanes w;
      for (int lane = 0; lane < lanes; ++lane) {
        const int q = k * lanes + lane;
        places[lane] = middle + half * rule.points[bem::at(q)];
        weights[lane] = half * rule.weights[bem::at(q)];
        const Complex off = middle < 0 ? target.zPlus1 - (1 + places[lane])
                                       : target.zMinus1 + (1 - places[lane]);
        w.set(lane, std::conj(off) * element.curve.factor(target, places[lane]));
      }
      addPart(sources(e, places, weights), &w);
    }
  };
  addBetween(-1, 1, 0, addBetween);
}

void RingInterior::add(const RingGroup& group, Vec2 x, const Uniform& uniform,
                       Sum& sum) const {
  const double shares[] = {1, -uniform.radial,
                           uniform.axial * uniform.height - uniform.start};
  const RingLame lame(lame_);
  const Uniform none;
  const auto addPoints = [&](const Sources& eight) {
    dispatch(Addition<Sources, Uniform, Sum>{eight, nullptr, x, lame,
                                             4 * lame_.mu * lame_.nu, none, sum});
  };
  const auto addAll = [&](const RingPointSources& from,
                          const std::vector<Complex>& values,
                          ComplexLanes Sources::*what) {
    for (std::size_t first = 0; first < from.places.size(); first += lanes) {
      Sources eight;
      for (int lane = 0; lane < lanes; ++lane) {
        const std::size_t k = std::min(first + bem::at(lane), from.places.size() - 1);
        const auto& place = from.places[k];
        eight.place.set(lane, {place[0], place[1]});
        eight.weight.lane[lane] = first + bem::at(lane) == k ? 1 : 0;
        Complex value = 0;
        for (std::size_t state = 0; state < std::size(shares); ++state)
          value += shares[state] * values[k * std::size(shares) + state];
        (eight.*what).set(lane, value);
      }
      addPoints(eight);
    }
  };
  addAll(group.circle, group.circle.forces, &Sources::density);
  Sources piece;
  const Rule& rule = gaussLegendre(lanes);
  const double half = group.halfOfPiece();
  double size = 0;
  for (std::size_t state = 0; state < std::size(shares); ++state)
    size += shares[state] * group.swelled[state];
  for (int lane = 0; lane < lanes; ++lane) {
    const double t = rule.points[bem::at(lane)];
    const auto& place = group.swelling.places[bem::at(lane)];
    piece.weight.lane[lane] = half * rule.weights[bem::at(lane)];
    piece.place.set(lane, {place[0], place[1]});
    piece.tangent.set(lane, {0, 1});
    piece.value.set(lane, size * (1 - t * t));
    piece.slope.set(lane, -2 * t / half * size);
  }
  addPoints(piece);
  addAll(group.ends, group.ends.displacements, &Sources::slope);
}

RingGroups RingInterior::groupsOf(const ElementRuns& runs, int smallest) const {
  const Uniform stretch = uniformOf(1, 0, 0);
  const auto values = [&](int e, double t, std::size_t state) -> RingGroups::Value {
    const Element& element = mesh_[e];
    const LocalField& field = fields_[bem::at(e)];
    if (state == 0)
      return {evaluate(field.density, element.densities - 1, t),
              evaluate(field.value, element.degree, t)};
    if (state == 2)
      return {0, {0, 1}};
    const Vec2 place = element.curve.point(t);
    return {stretch.stress * element.curve.normal(t).x,
            {place.x, stretch.axial * place.y}};
  };
  return RingGroups(runs, lame_, values, 3, smallest);
}

std::vector<InteriorValue> RingInterior::at(const std::vector<Vec2>& points) const {
  constexpr std::size_t few = 64;  // groups cost what these do in all elements one by one
  constexpr int smallest = 8;
  const ElementRuns runs(mesh_);
  const RingGroups groups = groupsOf(runs, points.size() > few ? smallest : mesh_.size());
  std::vector<InteriorValue> values(points.size());
  constexpr double ofElement = 200;  // ns
  parallelFor(
      {static_cast<Index>(points.size()),
       ofElement * static_cast<double>(points.size()) * mesh_.size()},
      [&](Index k) { values[bem::at(k)] = at(points[bem::at(k)], runs, groups); });
  return values;
}

InteriorValue RingInterior::at(Vec2 x, const ElementRuns& runs,
                               const RingGroups& groups) const {
  constexpr double close = 1e-5;  // to the axis, where u_r/ρ is du_r/dρ
  const Uniform uniform = uniformNear(x);
  Sum sum;
  groups.visit(
      asComplex(x), 0, [&](const RingGroup& group) { add(group, x, uniform, sum); },
      [&](int r) {
        for (int e = runs[r].first; e < runs[r].last; ++e)
          if (!mesh_.isAxis(e))
            add(e, x, uniform, sum);
      });
  const double stiffness = 2 * lame_.mu;
  InteriorValue value;
  value.displacement = {
      sum.r[0] + uniform.radial * x.x,
      sum.z[0] + uniform.start + uniform.axial * (x.y - uniform.height)};
  const double across = sum.pressure + uniform.stress;
  value.xx = across + stiffness * sum.r[1];
  value.yy = sum.pressure + stiffness * sum.z[2];
  value.xy = lame_.mu * (sum.r[2] + sum.z[1]);
  value.zz = across + stiffness * (x.x > close ? sum.r[0] / x.x : sum.r[1]);
  return value;
}

}  // namespace epafi::bem
