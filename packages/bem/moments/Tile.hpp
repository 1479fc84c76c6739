#pragma once

#include "bem/moments/ElementRuns.hpp"
#include "bem/moments/NearPairs.hpp"

#include <memory>

namespace epafi::bem {

/// The moments of one trial element with a run of up to eight test elements, near or far:
/// what all operators are made of.
/// One for each thread: it holds what is being worked on.
class Tile {
 public:
  explicit Tile(const ElementRuns& runs);

  /// Of a trial element and the wanted elements of run r.  A tile is computed as a whole:
  /// what else is in it decides on the quadrature, so callers that want equal results must
  /// form equal tiles.  Moments of other lanes are finite and mean nothing.
  void evaluate(int trial, int r, const ElementRange& wanted,
                InstructionSet set = largestInstructionSet());

  const Mesh& mesh() const { return runs_.mesh(); }
  int trial() const { return trial_; }
  const ElementRun& run() const { return runs_[run_]; }
  bool isWanted(int lane) const { return wanted_.contain(run().first + lane); }
  bool isFar(int lane) const { return far_[lane]; }
  const TileMoments& moments() const { return *moments_; }

 private:
  FarBatch batch_{};  // first, as it is aligned
  const ElementRuns& runs_;
  int trial_ = 0;
  int run_ = 0;
  ElementRange wanted_;
  bool far_[lanes] = {};
  std::unique_ptr<TileMoments> moments_;
  NearMoments near_;
};

}  // namespace epafi::bem
