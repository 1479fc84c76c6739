#pragma once

#include "bem/base/Matrix.hpp"
#include "bem/compressed/NearBlocks.hpp"
#include "bem/operators/FarBlocks.hpp"
#include "bem/operators/LocalFunctions.hpp"

#include <vector>

namespace epafi::bem {

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
  /// Functions of an element that are wanted, and their places.
  struct Wanted {
    int element;
    std::vector<std::pair<int, Index>> functions;
  };
  std::vector<Wanted> byElements(const std::vector<Index>& unknowns);
  void addColumn(const std::vector<Wanted>& rows, std::size_t first, const Wanted& column,
                 Matrix& out);
  void addTests(const std::vector<const Wanted*>& rows, const Wanted& column,
                Matrix& out);

  const Space& space_;
  const NearBlocks& near_;
  const std::vector<Unknown>& unknowns_;
  FarBlocks far_;
  std::vector<int> slots_;  ///< of the elements, or -1
  std::vector<FarBlocks::Test> tests_;
};

}  // namespace epafi::bem
