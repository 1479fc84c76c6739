#include "bem/moments/PairBatch.hpp"

#include "bem/moments/NearPair.hpp"

namespace epafi::bem {

PairBatch::PairBatch(const ElementRuns& runs)
    : runs_(runs),
      farMoments_(std::make_unique<FarMoments>()),
      pair_(std::make_unique<PairMoments>()) {}

void PairBatch::choose(int e, int r, const ElementRange& wanted) {
  e_ = e;
  chosen_ = runs_.choose(e, r, wanted, batch_);
  if (chosen_.count == 0)
    return;
  const Element& element = runs_.mesh()[e];
  farMoments(element, batch_, {element.degree, chosen_.columns},
             {chosen_.smooth.outer + degreeShare(element.degree),
              chosen_.smooth.inner + degreeShare(chosen_.columns)},
             *farMoments_);
}

const PairMoments& PairBatch::at(int f) {
  const Mesh& mesh = runs_.mesh();
  if (!isFar(f))
    near_.evaluate(mesh, e_, f, *farMoments_, f % lanes);
  extractLane(*farMoments_, f % lanes, mesh[f].tangent, mesh[e_].degree, mesh[f].degree,
              *pair_);
  return *pair_;
}

}  // namespace epafi::bem
