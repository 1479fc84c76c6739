#pragma once

#include "bem/base/Material.hpp"
#include "bem/base/Matrix.hpp"
#include "bem/moments/ElementRuns.hpp"
#include "bem/space/Space.hpp"

#include <vector>

namespace epafi::bem {

/// What elements far from a test element E contribute to <W φ, P̂_i e_a>_E and to
/// <K' ψ, P̂_i e_a>_E, one column for each (i, a): a run of sources at a time into a buffer of
/// densities, from which derivatives are gathered at the nodes.
class FarTractionRows {
 public:
  /// \throws InputError for densities beyond the degree of their element.
  FarTractionRows(const Space& space, const Lame& lame);

  /// The sources that are not far, as ElementRuns::choose says.
  std::vector<int> near(int element, int largestOuter) const;

  /// Sets the columns first + 2 i + a, i < moments, of `hypersingular` (displacements)
  /// and `adjoint` (densities).  Sources are far as ElementRuns::choose says.  Calls with
  /// different columns may run at the same time.
  void write(int element, int moments, int largestOuter, Index first,
             Matrix& hypersingular, Matrix& adjoint) const;

 private:
  /// Rows of nodes that follow one another, and so do the densities before and behind
  /// them, `count` of each.
  struct Nodes {
    Index row;
    Index onPrevious;
    Index onNext;
    Index count;
  };
  struct Bubble {
    Index row;
    Index density;
    double slope;
  };

  void appendNode(Index row, Index onPrevious, Index onNext);
  void gatherSlopes(const double* slopes, double* column) const;

  const Space& space_;
  Lame lame_;
  ElementRuns runs_;
  std::vector<Nodes> nodes_;
  std::vector<Bubble> bubbles_;
};

}  // namespace epafi::bem
