#include "bem/fields/Interior.hpp"

#include "bem/base/Parallel.hpp"
#include "bem/fields/PointHeaps.hpp"
#include "bem/fields/RingInterior.hpp"
#include "bem/fields/SourceGroups.hpp"
#include "bem/moments/ElementPotential.hpp"
#include "bem/simd/Dispatch.hpp"

#include <algorithm>

namespace epafi::bem {

namespace {

/// Eight points, and what the elements so far give there.
struct Targets {
  AlignedLane x{};
  AlignedLane y{};
  ComplexLanes displacement{};
  SumsOf<ComplexLanes> sums[2]{};  ///< of ψ and u'
};

/// Adds the sums of ψ and u'.
EPAFI_INLINE void addTo(Targets& to, const SumsOf<ComplexPack> (&own)[2]) {
  for (std::size_t i = 0; i < 2; ++i) {
    SumsOf<ComplexLanes>& sum = to.sums[i];
    sum.overW.store(sum.overW.load() + own[i].overW);
    sum.overConj.store(sum.overConj.load() + own[i].overConj);
    sum.cubic.store(sum.cubic.load() + own[i].cubic);
  }
}

/// What a carrier of an element has of u, du/ds and ψ.
struct Share {
  Complex value;
  Complex slope;
  Complex density;
};

struct Addition {
  const Lame& lame;
  const ElementPotential& kernels;
  const std::vector<Share>& shares;
  Targets& to;

  template <Division>
  EPAFI_INLINE void run() const {
    ComplexPack displacement = to.displacement.load();
    SumsOf<ComplexPack> sums[2];
    for (int k = 0; k < kernels.size(); ++k) {
      const KernelLanes& of = kernels[k];
      const Share& share = shares[static_cast<std::size_t>(k)];
      const ComplexPack overConj = of.overConj.load();
      const SumsOf<ComplexPack> unit{conj(overConj), overConj, of.cubic.load()};
      const ComplexPack log{load(of.log.lane), Pack{}};
      const ComplexPack whole{Pack{} + kernels.whole(k), Pack{}};
      const Complex normal = kernels.normal(k);
      const double normalPart = std::real(std::conj(normal) * share.value);
      displacement =
          displacement +
          singleLayer(lame, share.density * log, share.density * whole,
                      std::conj(share.density) * of.phase.load()) -
          doubleLayer(lame, normal * share.value * unit, Complex(normalPart) * unit);
      sums[0] = sums[0] + share.density * unit;
      sums[1] = sums[1] + share.slope * unit;
    }
    to.displacement.store(displacement);
    addTo(to, sums);
  }
};

void addElement(const Lame& lame, const Element& element, const LocalField& field,
                std::vector<Targets>& targets) {
  ElementPotential kernels(element.curve, std::max(element.degree, element.densities) + 1,
                           ElementPotential::Need::All);
  std::vector<Share> shares;
  shares.reserve(static_cast<std::size_t>(kernels.size()));
  for (int k = 0; k < kernels.size(); ++k)
    shares.push_back({kernels.share(field.value, k), kernels.share(field.slope, k),
                      kernels.share(field.density, k)});
  for (Targets& to : targets) {
    kernels.evaluate(to.x, to.y);
    dispatch(Addition{lame, kernels, shares, to});
  }
}

/// The densities of groups.
enum Density : std::size_t { psi, slope, normalValue, normalPart, densityCount };

/// Adds what a group does, by its expansions; z = x - c, of the densities of log|w| and of
/// w/conj(w):
///
///   ∫ g log|w| = log|z| M_0 - 1/2 Σ (q^k M_k + conj(q^k N_k))/k,   k >= 1,
///   ∫ conj(g) w/conj(w) = conj Σ q^(k+1) (conj(z) M_k - P_k) / R
struct FarAddition {
  const Lame& lame;
  const SourceGroups::Group& group;
  std::size_t terms;
  Targets& to;

  template <Division>
  EPAFI_INLINE void run() const {
    const ComplexPack z{load(to.x.lane) - group.centre.real(),
                        load(to.y.lane) - group.centre.imag()};
    Pack square;
    squareOf(z, square);
    const ComplexPack overZ = (1.0 / square) * conj(z);
    const ComplexPack q = group.radius * overZ;
    ComplexPack plain[3];
    constexpr std::size_t ofConjugate[3] = {psi, slope, normalPart};
    ComplexPack conjugate[3];
    ComplexPack twice[3];
    ComplexPack twiceShifted[3];
    ComplexPack shifted;
    ComplexPack logs[2];
    ComplexPack power = overZ;  // q^(k+1) / R
    for (std::size_t k = 0; k < terms; ++k) {
      const SourceGroups::Group::Moments& m = group.moments[k];
      const ComplexPack next = static_cast<double>(k + 1) * power;
      for (std::size_t i = 0; i < 3; ++i) {
        plain[i] = plain[i] + m.plain[i] * power;
        conjugate[i] = conjugate[i] + m.conjugate[ofConjugate[i]] * power;
        twice[i] = twice[i] + m.plain[i] * next;
        twiceShifted[i] = twiceShifted[i] + m.shifted[i] * next;
      }
      shifted = shifted + m.shifted[psi] * power;
      if (k > 0) {
        const ComplexPack part = (1.0 / static_cast<double>(k)) * power;
        logs[0] = logs[0] + m.plain[psi] * part;
        logs[1] = logs[1] + m.conjugate[psi] * part;
      }
      power = power * q;
    }
    const auto sumsOf = [&](std::size_t i) -> SumsOf<ComplexPack> {
      return {plain[i], conj(conjugate[i]),
              conj(overZ * (conj(z) * twice[i] - twiceShifted[i]))};
    };
    Pack logOfSquare;
    logarithm(square, logOfSquare);
    const Complex all = group.moments.front().plain[psi];
    const ComplexPack whole{Pack{} + all.real(), Pack{} + all.imag()};
    const ComplexPack log =
        (0.5 * logOfSquare) * whole - 0.5 * (z * logs[0] + conj(z * logs[1]));
    const SumsOf<ComplexPack> normal = sumsOf(normalValue);
    to.displacement.store(
        to.displacement.load() +
        singleLayer(lame, log, whole, conj(conj(z) * plain[psi] - shifted)) -
        doubleLayer(lame, normal, normal));
    addTo(to, {sumsOf(psi), sumsOf(slope)});
  }
};

}  // namespace

Interior::Interior(const Space& space, const Lame& lame, const Vector& u,
                   const Vector& psi)
    : space_(space), lame_(lame), inner_(space.withoutRotation(u)), psi_(psi) {
  if (space.rotation() != nullptr)
    rotation_ = space.rotation()->amount(u);
  if (!space.mesh().outline().isAxisymmetric())
    return;
  std::vector<LocalField> fields;
  for (int e = 0; e < space.mesh().size(); ++e)
    fields.push_back(field(e));
  rings_ = std::make_shared<const RingInterior>(space.mesh(), lame, std::move(fields));
}

void Interior::setDensities(int e, const Rule& rule, std::vector<Complex>& g) const {
  const Element& element = space_.mesh()[e];
  const LocalField own = field(e);
  auto next = g.begin();
  for (const double t : rule.points) {
    const Complex value = evaluate(own.value, element.degree, t);
    const Complex normal = asComplex(element.curve.normal(t));
    next[psi] = evaluate(own.density, element.densities - 1, t);
    next[slope] = evaluate(own.slope, element.degree - 1, t);
    next[normalValue] = normal * value;
    next[normalPart] = std::real(std::conj(normal) * value);
    next += densityCount;
  }
}

std::vector<InteriorValue> Interior::at(const std::vector<Vec2>& points) const {
  const Mesh& mesh = space_.mesh();
  if (rings_ != nullptr)
    return rings_->at(points);
  std::vector<InteriorValue> values(points.size());
  constexpr std::size_t atOnce = 8 * lanes;
  const PointHeaps heaps(points, atOnce);
  // groups cost what a heap of points does in all elements one by one
  const ElementRuns runs(mesh);
  constexpr int smallest = 2;
  const SourceGroups groups(
      runs, densityCount,
      [this](int e, const Rule& rule, std::vector<Complex>& g) {
        setDensities(e, rule, g);
      },
      heaps.size() > 1 ? smallest : mesh.size());
  constexpr double ofPoint = 20000;  // ns
  const double work = ofPoint * static_cast<double>(points.size());
  parallelFor({static_cast<Index>(heaps.size()), work}, [&](Index index) {
    const std::size_t heap = bem::at(index);
    std::vector<Targets> targets(heaps.packsOf(heap));
    for (std::size_t k = 0; k < targets.size() * lanes; ++k) {
      const Vec2 x = points[heaps.number(heap, k)];
      targets[k / lanes].x.lane[k % lanes] = x.x;
      targets[k / lanes].y.lane[k % lanes] = x.y;
    }
    groups.visit(
        heaps.centre(heap), heaps.radius(heap),
        [&](const SourceGroups::Group& group) {
          for (Targets& to : targets)
            dispatch(FarAddition{lame_, group, group.terms, to});
        },
        [&](int r) {
          for (int e = runs[r].first; e < runs[r].last; ++e)
            addElement(lame_, mesh[e], field(e), targets);
        });
    for (std::size_t k = 0; k < heaps.pointsOf(heap); ++k) {
      const Targets& own = targets[k / lanes];
      const std::size_t lane = k % lanes;
      const Vec2 x = points[heaps.number(heap, k)];
      Complex displacement = own.displacement[lane];
      if (space_.rotation() != nullptr)
        displacement += rotation_ * asComplex(space_.rotation()->at(x));
      const auto sumsOf = [&](const SumsOf<ComplexLanes>& of) {
        return SourceSums{of.overW[lane], of.overConj[lane], of.cubic[lane]};
      };
      const FieldSums sums{sumsOf(own.sums[0]), sumsOf(own.sums[1])};
      const Complex onX = traction(lame_, Complex(1, 0), sums);
      const Complex onY = traction(lame_, Complex(0, 1), sums);
      values[heaps.number(heap, k)] = {asVector(displacement), onX.real(), onY.imag(),
                                       0.5 * (onX.imag() + onY.real())};
    }
  });
  return values;
}

}  // namespace epafi::bem
