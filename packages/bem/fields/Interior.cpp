#include "bem/fields/Interior.hpp"

#include "bem/base/Parallel.hpp"
#include "bem/fields/PointSources.hpp"
#include "bem/fields/RingInterior.hpp"
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
  PointSources::Sums sums;
};

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
    Pack sums[2][6] = {};
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
      PointSources::addProducts(share.density, overConj, unit.cubic, sums[0]);
      PointSources::addProducts(share.slope, overConj, unit.cubic, sums[1]);
    }
    to.displacement.store(displacement);
    for (int field = 0; field < 2; ++field)
      for (int part = 0; part < 6; ++part)
        add(to.sums.of[field][part].lane, sums[field][part]);
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
    dispatch(largestInstructionSet(), Addition{lame, kernels, shares, to});
  }
}

}  // namespace

Interior::Interior(const Space& space, const Lame& lame, const Vector& u,
                   const Vector& psi)
    : space_(space), lame_(lame) {
  const Vector inner = space.withoutRotation(u);
  for (int e = 0; e < space.mesh().size(); ++e)
    fields_.push_back(localField(space, inner, psi, e));
  if (space.rotation() != nullptr)
    rotation_ = space.rotation()->amount(u);
  if (space.mesh().outline().isAxisymmetric())
    rings_ = std::make_shared<const RingInterior>(space.mesh(), lame, fields_);
}

std::vector<InteriorValue> Interior::at(const std::vector<Vec2>& points) const {
  constexpr std::size_t atOnce = 8 * lanes;
  constexpr double ofElement = 30;  // ns
  const Mesh& mesh = space_.mesh();
  std::vector<InteriorValue> values(points.size());
  if (rings_ != nullptr) {
    constexpr double ofRing = 200;  // ns
    parallelFor({static_cast<Index>(points.size()),
                 ofRing * static_cast<double>(points.size()) * mesh.size()},
                [&](Index k) { values[bem::at(k)] = rings_->at(points[bem::at(k)]); });
    return values;
  }
  const std::size_t rounds = (points.size() + atOnce - 1) / atOnce;
  const double work = ofElement * static_cast<double>(points.size()) * mesh.size();
  parallelFor({static_cast<Index>(rounds), work}, [&](Index round) {
    const std::size_t first = bem::at(round) * atOnce;
    const std::size_t last = std::min(first + atOnce, points.size());
    std::vector<Targets> targets((last - first + lanes - 1) / lanes);
    for (std::size_t k = 0; k < targets.size() * lanes; ++k) {
      const Vec2 x = points[std::min(first + k, last - 1)];
      targets[k / lanes].x.lane[k % lanes] = x.x;
      targets[k / lanes].y.lane[k % lanes] = x.y;
    }
    for (int e = 0; e < mesh.size(); ++e)
      addElement(lame_, mesh[e], fields_[bem::at(e)], targets);
    for (std::size_t k = first; k < last; ++k) {
      const Targets& own = targets[(k - first) / lanes];
      const std::size_t lane = (k - first) % lanes;
      Complex displacement = own.displacement[lane];
      if (space_.rotation() != nullptr)
        displacement += rotation_ * asComplex(space_.rotation()->at(points[k]));
      const FieldSums sums = own.sums.at(lane);
      const Complex onX = traction(lame_, Complex(1, 0), sums);
      const Complex onY = traction(lame_, Complex(0, 1), sums);
      values[k] = {asVector(displacement), onX.real(), onY.imag(),
                   0.5 * (onX.imag() + onY.real())};
    }
  });
  return values;
}

}  // namespace epafi::bem
