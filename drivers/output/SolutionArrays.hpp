#pragma once

#include "drivers/run/Level.hpp"

#include <variant>
#include <vector>

namespace epafi::drivers {

/// An array of solution.hdf, stored row by row.
struct SolutionArray {
  const char* name = nullptr;
  std::size_t columns = 1;
  std::variant<std::vector<double>, std::vector<int>> numbers{};
  std::size_t taken = 0;  ///< how many numbers have been read into a level
};

/// The numbers of a level as in solution.hdf and in the order of the checksum: body by
/// body; for a path step by step, within a step body by body.
using SolutionArrays = std::vector<SolutionArray>;

/// All arrays of solution.hdf, empty.
SolutionArrays emptyArrays();

SolutionArrays arraysOf(Level level);

/// The inverse of arraysOf.
/// \throws bem::InputError if the sizes do not match, or for an unknown state.
Level levelOf(SolutionArrays arrays);

}  // namespace epafi::drivers
