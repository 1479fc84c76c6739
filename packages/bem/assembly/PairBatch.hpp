#pragma once

#include "bem/assembly/FarPairs.hpp"

#include <memory>

namespace epafi::bem {

/// The moments of one element with up to eight others in a row, far ones all at once.
/// One for each thread: it holds what is being worked on.
class PairBatch {
 public:
  explicit PairBatch(const Mesh& mesh);

  /// Prepares the pairs (e, first) ... (e, last - 1), at most `lanes`.  A batch is
  /// computed as a whole: what else is in it decides on the quadrature, so callers that
  /// want equal results must form equal batches.
  void choose(int e, int first, int last);

  /// The moments of (e, f), f one of the chosen; valid until the next call.
  const PairMoments& at(int f);

 private:
  const Mesh& mesh_;
  int e_ = 0;
  int first_ = 0;
  bool near_[lanes] = {};
  FarBatch far_{};
  std::unique_ptr<FarMoments> farMoments_;
  std::unique_ptr<PairMoments> pair_;
};

}  // namespace epafi::bem
