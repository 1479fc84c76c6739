#pragma once

#include "bem/base/Matrix.hpp"
#include "bem/compressed/NearBlocks.hpp"
#include "bem/operators/FarBlocks.hpp"
#include "bem/operators/Kernel.hpp"
#include "bem/operators/LocalFunctions.hpp"

#include <vector>

namespace epafi::bem {

/// Local functions of an element and the positions of their unknowns in a list.
struct ElementFunctions {
  int element = 0;
  std::vector<std::pair<int, Index>> functions;
};

/// ElementFunctions of the unknowns `which`, in ascending order of the elements, but of none on an axis
/// of revolution.
std::vector<ElementFunctions> byElements(const Space& space,
                                         const std::vector<Unknown>& unknowns,
                                         const std::vector<Index>& which);

/// Entries of the coupled system for any rows and columns.
///
/// Has work arrays: use one object per thread.
class CoupledEntries {
 public:
  /// Refers to its arguments.  \param unknowns unknownsOf(space), then additional ones
  CoupledEntries(const Space& space, const Kernel& kernel, const NearBlocks& near,
                 const std::vector<Unknown>& unknowns);

  /// Submatrix of these rows and columns, numbered as in `unknowns`.
  Matrix operator()(const std::vector<Index>& rows, const std::vector<Index>& columns);
  /// Principal submatrix; computes each pair of elements once.
  Matrix symmetric(const std::vector<Index>& unknowns);

 private:
  void addColumn(const std::vector<ElementFunctions>& rows, std::size_t first,
                 const ElementFunctions& column, Matrix& out);
  void addTests(const std::vector<const ElementFunctions*>& rows,
                const ElementFunctions& column, Matrix& out);

  const Space& space_;
  const NearBlocks& near_;
  const std::vector<Unknown>& unknowns_;
  std::unique_ptr<FarBlocks> far_;
  std::vector<FarBlocks::Test> tests_;
};

}  // namespace epafi::bem
