#pragma once

#include "bem/base/Matrix.hpp"

namespace epafi::bem {

/// The processes that share a run.
///
/// Vectors, meshes and dense matrices every process has whole, and computes with them by itself;
/// of compressed operators it has a part.  What decides is rank 0's.  All calls are collective.
///                                                                     [doc/decisions/0068]
class Processes {
 public:
  virtual ~Processes() = default;

  /// The sum over all processes, in place of each one's own; the same bits on all of them.
  virtual Vector sum(Vector mine) const = 0;

  /// What rank 0 has, also where others have more or fewer numbers.
  virtual Vector broadcast(Vector root) const = 0;
  /// The same of a decision.
  bool agreed(bool mine) const { return broadcast({mine ? 1.0 : 0.0}).front() != 0; }

  virtual int rank() const = 0;
  virtual int count() const = 0;
};

class OneProcess final : public Processes {
 public:
  Vector sum(Vector mine) const override { return mine; }
  Vector broadcast(Vector root) const override { return root; }
  int rank() const override { return 0; }
  int count() const override { return 1; }
};

/// Never destroyed before what refers to it.
inline const Processes& oneProcess() {
  static const OneProcess one;
  return one;
}

}  // namespace epafi::bem
