#pragma once

#include "bem/moments/ElementRuns.hpp"
#include "bem/moments/NearPair.hpp"

#include <memory>

namespace epafi::bem {

/// The moments of one element with a run of up to eight others, far ones all at once.
/// One for each thread: it holds what is being worked on.
class PairBatch {
 public:
  explicit PairBatch(const ElementRuns& runs);

  /// Prepares the pairs of e and the wanted elements of run r.  A batch is
  /// computed as a whole: what else is in it decides on the quadrature, so callers that
  /// want equal results must form equal batches.
  void choose(int e, int r, const ElementRange& wanted);

  /// True when f, one of the chosen, is far.
  bool isFar(int f) const { return chosen_.far[f % lanes]; }

  /// The moments of (e, f), f one of the chosen; valid until the next call.
  const PairMoments& at(int f);

 private:
  FarBatch batch_{};  // first, as it is aligned
  const ElementRuns& runs_;
  int e_ = 0;
  FarLanes chosen_;
  std::unique_ptr<FarMoments> farMoments_;
  NearMoments near_;
  std::unique_ptr<PairMoments> pair_;
};

}  // namespace epafi::bem
