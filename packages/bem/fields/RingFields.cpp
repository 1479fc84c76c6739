#include "bem/fields/RingFields.hpp"

#include "bem/algebra/LuFactor.hpp"
#include "bem/base/Parallel.hpp"
#include "bem/fields/RingGroups.hpp"
#include "bem/moments/RingTile.hpp"
#include "bem/simd/Dispatch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace epafi::bem {

namespace {

constexpr double turn = 6.2831853071795865;

/// Polynomials by which fields are tested, beyond those of the densities.
constexpr int more = 4;

/// What is tested by P_j on an element: the components of V ψ - K u, of W u + K' ψ what multiplies
/// v_r', v_z', v_r and v_z.
enum Part { mismatchR, mismatchZ, slopeR, slopeZ, valueR, valueZ, parts };

/// So many runs of elements cost what the forces of a group do.
constexpr int smallestGroup = 8;
/// From elements to what stands for a group, besides its own distance [half their length].
constexpr double distanceOfGroups = zOfCircles;

/// A point of each element of a run.
struct Places {
  const ElementLanes& elements;
  double t;
  RingTargets& to;

  template <Division>
  EPAFI_INLINE void run() const {
    const ElementLanes::Points x = elements.at(Pack{} + t);
    store(to.x.lane, load(elements.wx) + x.place.re);
    store(to.y.lane, load(elements.wy) + x.place.im);
    store(to.tangentX.lane, x.tangent.re);
    store(to.tangentY.lane, x.tangent.im);
  }
};

/// Adds what an element does to the eight of a run; sums: of each state parts x columns.
struct Addition {
  const RingTile& tile;
  const LocalField* fields;
  std::size_t states;
  int rows;
  int columns;
  double half;
  std::vector<AlignedLane>& sums;

  template <Division>
  EPAFI_INLINE void run() const {
    for (std::size_t state = 0; state < states; ++state)
      for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j)
          add(fields[state], i, j, state * parts * static_cast<std::size_t>(columns));
  }

 private:
  using K = RingKernels;

  EPAFI_INLINE const Pack& of(int kernel, int i, int j) const {
    return load(tile.at(kernel, i, j));
  }
  EPAFI_INLINE void addTo(Part part, std::size_t first, int j, const Pack& value) const {
    const std::size_t to = first + static_cast<std::size_t>(part * columns + j);
    bem::add(sums[to].lane, (turn * half) * value);
  }

  EPAFI_INLINE void add(const LocalField& field, int i, int j, std::size_t first) const {
    const RingLame& lame = tile.lame();
    const double a = field.density[i].real();
    const double b = field.density[i].imag();
    const double sr = field.slope[i].real();
    const double sz = field.slope[i].imag();
    const double vr = field.value[i].real();
    const double vz = field.value[i].imag();
    const Pack& e1 = of(K::e1, i, j);
    const Pack& e0 = of(K::e0, i, j);
    const Pack& rr = of(K::rr, i, j);
    const Pack& zz = of(K::zz, i, j);
    const Pack& rz = of(K::rz, i, j);
    const Pack& zr = of(K::zr, i, j);
    const Pack radial = lame.part * e1 + rr;
    const Pack axial = lame.part * e0 + zz;
    addTo(mismatchR, first, j,
          a * (lame.a * e1 + lame.b * rr) + (b * lame.b) * zr -
              lame.doubled * (sr * zr - sz * radial) - vr * of(K::ofX, i, j));
    addTo(mismatchZ, first, j,
          (a * lame.b) * rz + b * (lame.a * e0 + lame.b * zz) -
              lame.doubled * (sr * axial - sz * rz) - vr * of(K::ofX + 1, i, j) -
              vz * of(K::ofX + 2, i, j));
    addTo(slopeR, first, j,
          sr * (lame.curl * (e0 - of(K::es, i, j)) - lame.squared * axial) +
              (sz * lame.squared) * rz + vr * of(K::xSlope, i, j) +
              lame.doubled * (a * rz + b * axial));
    addTo(slopeZ, first, j,
          (sr * lame.squared) * zr + sz * (lame.curl * e1 - lame.squared * radial) +
              vr * of(K::xSlope + 1, i, j) - lame.doubled * (a * radial + b * zr));
    addTo(valueR, first, j,
          sr * of(K::ySlope, i, j) + sz * of(K::ySlope + 1, i, j) +
              vr * of(K::both, i, j) + a * of(K::ofY, i, j) + b * of(K::ofY + 1, i, j));
    addTo(valueZ, first, j, b * of(K::ofY + 2, i, j));
  }
};

/// Adds what groups do to the eight of a run.
void addGroups(const RingGroups& all, const std::vector<const RingGroup*>& groups,
               const ElementLanes& run, std::size_t states, int columns,
               std::vector<AlignedLane>& sums) {
  const int order = smoothOrderOfCircles + (columns + 1) / 2 +
                    static_cast<int>(std::ceil(2 * run.largestAngle));
  const WeightedLegendre& table = weightedLegendre(order);
  for (int q = 0; q < order; ++q) {
    RingTargets targets;
    dispatch(Places{run, gaussLegendre(order).points[at(q)], targets});
    std::vector<AlignedLane> fields(4 * states);
    for (const RingGroup* group : groups)
      all.add(*group, targets, fields.data());
    constexpr Part to[4] = {mismatchR, mismatchZ, valueR, valueZ};
    for (std::size_t state = 0; state < states; ++state)
      for (int part = 0; part < 4; ++part)
        for (int j = 0; j < columns; ++j)
          for (int lane = 0; lane < lanes; ++lane)
            sums[(state * parts + at(to[part])) * at(columns) + at(j)].lane[lane] +=
                table[q][at(j)] * fields[4 * state + at(part)].lane[lane];
  }
}

/// Of one state: a lane of the sums.
struct Tested {
  const AlignedLane* first;
  int columns;
  int lane;

  double operator()(Part part, int j) const {
    return first[part * columns + j].lane[lane];
  }
};

/// φ_k = (P_k - P_{k-2})/√(2(2k-1)) of values of P.
double bubble(int k, const double* legendre) {
  return (legendre[k] - legendre[k - 2]) / std::sqrt(2.0 * (2 * k - 1));
}

Matrix solved(Matrix system, Matrix right) {
  const LuFactor factor(std::move(system));
  factor.solve(right);
  return right;
}

/// The series with the tested products, \param terms of V ψ - (K + 1/2) u; two fewer of the
/// traction, as it is tested by bubbles.
RingFields::Series seriesOf(const Mesh& mesh, int e, const LocalField& field, int terms,
                            const Tested& tested) {
  const double half = mesh[e].half;
  const int bubbles = terms - 1;
  Matrix gram(terms, terms);
  Matrix pairing(bubbles, bubbles);
  Matrix mismatch(terms, 2);
  Matrix traction(bubbles, 2);
  for (int j = 0; j < terms; ++j) {
    mismatch(j, 0) = half * tested(mismatchR, j);
    mismatch(j, 1) = half * tested(mismatchZ, j);
  }
  for (int k = 2; k <= terms; ++k) {
    const double slope = std::sqrt(0.5 * (2 * k - 1));
    const double scale = half / std::sqrt(2.0 * (2 * k - 1));
    traction(k - 2, 0) = slope * tested(slopeR, k - 1) +
                         scale * (tested(valueR, k) - tested(valueR, k - 2));
    traction(k - 2, 1) = slope * tested(slopeZ, k - 1) +
                         scale * (tested(valueZ, k) - tested(valueZ, k - 2));
  }
  const Rule& rule = gaussLegendre(terms + 3 + mesh[e].curve.pointsOfTurning());
  std::array<double, largestDegree + 2> legendre{};
  for (int q = 0; q < rule.size(); ++q) {
    const double t = rule.points[at(q)];
    const double weight = rule.weights[at(q)] * mesh.measure(e, t);
    legendreValues(terms, t, legendre.data());
    const Complex u = evaluate(field.value, mesh[e].densities, t);
    const Complex psi = evaluate(field.density, mesh[e].densities - 1, t);
    for (int j = 0; j < terms; ++j) {
      mismatch(j, 0) -= 0.5 * weight * legendre[at(j)] * u.real();
      mismatch(j, 1) -= 0.5 * weight * legendre[at(j)] * u.imag();
      for (int k = 0; k < terms; ++k)
        gram(k, j) += weight * legendre[at(k)] * legendre[at(j)];
    }
    for (int k = 2; k <= terms; ++k) {
      const double test = weight * bubble(k, legendre.data());
      traction(k - 2, 0) += 0.5 * test * psi.real();
      traction(k - 2, 1) += 0.5 * test * psi.imag();
      for (int i = 0; i < bubbles; ++i)
        pairing(k - 2, i) += test * legendre[at(i)];
    }
  }
  mismatch = solved(std::move(gram), std::move(mismatch));
  traction = solved(std::move(pairing), std::move(traction));
  RingFields::Series series;
  for (int j = 0; j < terms; ++j)
    series.mismatch[at(j)] = {mismatch(j, 0), mismatch(j, 1)};
  for (int i = 0; i < bubbles; ++i)
    series.traction[at(i)] = {traction(i, 0), traction(i, 1)};
  return series;
}

}  // namespace

int RingFields::terms(int element) const {
  return std::min(mesh_[element].densities + more, largestDegree + 1);
}

RingFields::RingFields(const Mesh& mesh, const Lame& lame,
                       const std::vector<LocalField>& fields, std::size_t states)
    : mesh_(mesh), states_(states), series_(fields.size()) {
  const ElementRuns runs(mesh_);
  const RingGroups groups(
      runs, lame,
      [&](int e, double t, std::size_t state) -> RingGroups::Value {
        const LocalField& field = fields[at(e) * states + state];
        return {evaluate(field.density, mesh_[e].densities - 1, t),
                evaluate(field.value, mesh_[e].degree, t)};
      },
      states, smallestGroup);
  constexpr double ofPair = 2e3;  // ns
  const double work = ofPair * static_cast<double>(mesh_.size()) * mesh_.size();
  parallelFor(
      {runs.size(), work}, [&] { return RingTile(lame, more); },
      [&](RingTile& tile, Index index) {
        const int r = asInt(index);
        const ElementLanes& run = runs[r];
        const int columns = tile.columnsOf(run);
        const auto size = static_cast<std::size_t>(parts * columns);
        std::vector<AlignedLane> sums(states_ * size);
        const auto addElement = [&](int e) {
          if (mesh_.isAxis(e))
            return;
          tile.evaluate(runs, e, r, {run.first, run.last});
          dispatch(Addition{tile, &fields[at(e) * states_], states_,
                            mesh_[e].densities + 1, columns, mesh_[e].half, sums});
        };
        std::vector<const RingGroup*> far;
        groups.visit(
            asComplex(run.centre), run.radius + distanceOfGroups * run.largestHalf,
            [&](const RingGroup& group) { far.push_back(&group); },
            [&](int near) {
              for (int e = runs[near].first; e < runs[near].last; ++e)
                addElement(e);
            });
        if (!far.empty())
          addGroups(groups, far, run, states_, columns, sums);
        for (int f = run.first; f < run.last; ++f)
          for (std::size_t k = 0; k < states_ && !mesh_.isAxis(f); ++k)
            series_[at(f) * states_ + k] =
                seriesOf(mesh_, f, fields[at(f) * states_ + k], terms(f),
                         {&sums[k * size], columns, f - run.first});
      });
}

}  // namespace epafi::bem
