#include "bem/assembly/PairBatch.hpp"

#include "bem/assembly/NearPair.hpp"

#include <algorithm>

namespace epafi::bem {

PairBatch::PairBatch(const Mesh& mesh)
    : mesh_(mesh),
      farMoments_(std::make_unique<FarMoments>()),
      pair_(std::make_unique<PairMoments>()) {}

void PairBatch::choose(int e, int first, int last) {
  e_ = e;
  first_ = first;
  PairOrder order;
  int columns = 0;
  const BoundaryPoint middle = mesh_.at(e, 0);
  for (int lane = 0; lane < lanes; ++lane) {
    const int f = first + lane;
    near_[lane] = true;
    far_.drop(lane);
    if (f >= last)
      continue;
    const Vec2 w = mesh_.difference(middle, mesh_.at(f, 0));
    PairOrder own;
    near_[lane] = isNear(mesh_, e, f, w, own);
    if (near_[lane])
      continue;
    far_.set(lane, w, mesh_[f]);
    order = {std::max(order.outer, own.outer), std::max(order.inner, own.inner)};
    columns = std::max(columns, mesh_[f].degree);
  }
  if (columns > 0)
    farMoments(mesh_[e], far_, mesh_[e].degree, columns, order, *farMoments_);
}

const PairMoments& PairBatch::at(int f) {
  const int lane = f - first_;
  if (near_[lane])
    nearPairMoments(mesh_, e_, f, *pair_);
  else
    extractLane(*farMoments_, lane, mesh_[f].tangent, mesh_[e_].degree, mesh_[f].degree,
                *pair_);
  return *pair_;
}

}  // namespace epafi::bem
