#pragma once

#include "bem/base/Matrix.hpp"

namespace epafi::bem {

/// The processes of a run.
///
/// Vectors, meshes and dense matrices are replicated and computed redundantly; compressed operators
/// are distributed.  Decisions are those of rank 0.  All calls are collective.
///                                                                     [doc/decisions/0068]
class Processes {
 public:
  virtual ~Processes() = default;

  /// Sum of `mine` over all processes, bitwise equal on all of them.
  virtual Vector sum(Vector mine) const = 0;

  /// The vector of rank 0; vectors of other processes may have any size.
  virtual Vector broadcast(Vector root) const = 0;
  /// The decision of rank 0.
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

/// The only process; a static object, so that references to it stay valid.
inline const Processes& oneProcess() {
  static const OneProcess one;
  return one;
}

}  // namespace epafi::bem
