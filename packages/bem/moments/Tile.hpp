#pragma once

#include "bem/moments/ElementRuns.hpp"
#include "bem/moments/NearPairs.hpp"

#include <memory>

namespace epafi::bem {

/// Moments of one trial element with a run of up to eight test elements, near or far; all
/// operators are assembled from them.
/// Has work arrays: use one object per thread.
class Tile {
 public:
  explicit Tile(const ElementRuns& runs);

  /// Computes the moments of a trial element with the wanted elements of run r.  The
  /// quadrature of a pair depends on the other elements of its tile: equal results need equal
  /// tiles.  Moments of elements that are not wanted are finite and meaningless.
  void evaluate(int trial, int r, const ElementRange& wanted,
                InstructionSet set = largestInstructionSet());

  const Mesh& mesh() const { return runs_.mesh(); }
  int trial() const { return trial_; }
  const ElementRun& run() const { return runs_[run_]; }
  bool isWanted(int lane) const { return wanted_.contain(run().first + lane); }
  bool isFar(int lane) const { return far_[lane]; }
  const TileMoments& moments() const { return *moments_; }

 private:
  const ElementRuns& runs_;
  int trial_ = 0;
  int run_ = 0;
  ElementRange wanted_;
  bool far_[lanes] = {};
  std::unique_ptr<TileMoments> moments_;
};

}  // namespace epafi::bem
