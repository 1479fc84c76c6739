#include "bem/operators/Kernel.hpp"

#include "bem/mesh/Surfaces.hpp"
#include "bem/operators/FarBlocks.hpp"
#include "bem/operators/RingBlocks.hpp"
#include "bem/operators/TileBlocks.hpp"

#include <cmath>

namespace epafi::bem {

namespace {

class PlaneElasticity final : public Kernel {
 public:
  explicit PlaneElasticity(const Lame& lame) : lame_(lame) {}

  int components() const override { return 2; }
  double stiffness() const override { return youngOf(lame_); }
  std::unique_ptr<PairColumns> pairs(const Space& space) const override {
    return std::make_unique<TileBlocks<KelvinMoments>>(space, KelvinMoments{lame_});
  }
  std::unique_ptr<FarBlocks> far(const Space& space) const override {
    return std::make_unique<FarQuadrature<KelvinPoints>>(space, KernelConstants(lame_));
  }
  // Both of a node, and across the line to the node that is farthest from it.
  std::vector<Index> resting(const Space& space) const override {
    const Mesh& mesh = space.mesh();
    int farthest = 0;
    Vec2 offset{};
    for (int e = 0; e < mesh.size() && mesh.outline().edge(mesh[e].piece.edge).loop == 0;
         ++e) {
      const Vec2 d = mesh.difference(mesh.at(e, -1), mesh.at(0, -1));
      if (length(d) > length(offset)) {
        farthest = e;
        offset = d;
      }
    }
    const int across = std::abs(offset.x) > std::abs(offset.y) ? 1 : 0;
    return {space.displacement(0, 0, 0), space.displacement(0, 0, 1),
            space.displacement(farthest, 0, across)};
  }

 private:
  Lame lame_;
};

class RingElasticity final : public Kernel {
 public:
  explicit RingElasticity(const Lame& lame) : lame_(lame) {}

  int components() const override { return 2; }
  double stiffness() const override { return youngOf(lame_); }
  std::unique_ptr<PairColumns> pairs(const Space& space) const override {
    return std::make_unique<RingBlocks>(space, lame_);
  }
  std::unique_ptr<FarBlocks> far(const Space& space) const override {
    return std::make_unique<FarQuadrature<RingPoints>>(space, RingLame(lame_));
  }
  std::vector<Index> resting(const Space& space) const override {
    return {space.displacement(surfacesOf(space.mesh()).front().elements.front(), 0, 1)};
  }

 private:
  Lame lame_;
};

class Laplace final : public Kernel {
 public:
  int components() const override { return 1; }
  double stiffness() const override { return 1; }
  std::unique_ptr<PairColumns> pairs(const Space& space) const override {
    return std::make_unique<TileBlocks<LaplaceMoments>>(space, LaplaceMoments{});
  }
  std::unique_ptr<FarBlocks> far(const Space& space) const override {
    return std::make_unique<FarQuadrature<LaplacePoints>>(space,
                                                          LaplacePoints::Constants{});
  }
  std::vector<Index> resting(const Space& space) const override {
    return {space.displacement(0, 0, 0)};
  }
};

}  // namespace

std::shared_ptr<const Kernel> elasticKernel(const Outline& outline, const Lame& lame) {
  if (outline.isAxisymmetric())
    return std::make_shared<const RingElasticity>(lame);
  return std::make_shared<const PlaneElasticity>(lame);
}

std::shared_ptr<const Kernel> laplaceKernel() {
  return std::make_shared<const Laplace>();
}

}  // namespace epafi::bem
