#pragma once

#include "bem/base/Matrix.hpp"
#include "bem/compressed/NearBlocks.hpp"
#include "bem/operators/FarBlocks.hpp"
#include "bem/operators/LocalFunctions.hpp"

#include <vector>

namespace epafi::bem {

/// Functions of an element, and the places of their unknowns in a list.
struct ElementFunctions {
  int element = 0;
  std::vector<std::pair<int, Index>> functions;
};

/// Those of some of the unknowns, in the order of the elements.
std::vector<ElementFunctions> byElements(const Space& space,
                                         const std::vector<Unknown>& unknowns,
                                         const std::vector<Index>& which);

/// Entries of the coupled system for any rows and columns.
///
/// One for each thread: it holds what is being worked on.
class CoupledEntries {
 public:
  /// All outlive it; `unknowns` are those of the space.
  CoupledEntries(const Space& space, const Lame& lame, const NearBlocks& near,
                 const std::vector<Unknown>& unknowns);

  /// Numbers as unknownsOf has them.
  Matrix operator()(const std::vector<Index>& rows, const std::vector<Index>& columns);
  /// The same of rows that are the columns, each pair of elements once.
  Matrix symmetric(const std::vector<Index>& unknowns);

 private:
  void addColumn(const std::vector<ElementFunctions>& rows, std::size_t first,
                 const ElementFunctions& column, Matrix& out);
  void addTests(const std::vector<const ElementFunctions*>& rows,
                const ElementFunctions& column, Matrix& out);

  const Space& space_;
  const NearBlocks& near_;
  const std::vector<Unknown>& unknowns_;
  FarBlocks far_;
  std::vector<FarBlocks::Test> tests_;
};

}  // namespace epafi::bem
