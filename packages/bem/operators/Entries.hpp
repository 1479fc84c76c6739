#pragma once

#include "bem/base/Material.hpp"
#include "bem/base/Matrix.hpp"
#include "bem/space/Space.hpp"

namespace epafi::bem {

/// Dense blocks of V, K + 1/2 and W.
struct EntryBlocks {
  Matrix singleLayer;    ///< densities of the tests x densities of the trials
  Matrix doubleLayer;    ///< densities of the tests x displacements of the trials
  Matrix hypersingular;  ///< displacements of the tests x displacements of the trials
};

/// The entries that test elements have with trial elements: the door for operators that
/// do not assemble all.
///
/// Rows and columns are the unknowns of the elements in the order given: an element's
/// densities, and the displacements of its start node and its bubbles, as Space numbers
/// them.  Entries are those of assembleOperators; W of functions whose elements are all
/// far from each other comes from its own kernel (hypersingularBlock), accurate to 1e-11 of
/// its own size where the functions do not change their sign.  By parts, as near, it would
/// have noise of ε (r/h)² of that.
EntryBlocks entries(const Space& space, const Lame& lame, const std::vector<int>& tests,
                    const std::vector<int>& trials);

}  // namespace epafi::bem
