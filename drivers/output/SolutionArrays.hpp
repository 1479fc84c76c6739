#pragma once

#include "drivers/run/Level.hpp"

#include <variant>
#include <vector>

namespace epafi::drivers {

/// An array of solution.hdf, row by row.
struct SolutionArray {
  const char* name = nullptr;
  std::size_t columns = 1;
  std::variant<std::vector<double>, std::vector<int>> numbers{};
  std::size_t taken = 0;  ///< how many have gone into a level
};

/// A level's numbers as they stand in solution.hdf, in the order of the checksum: those of the
/// bodies one body after the other, those of a path one step after the other, in a step again
/// the bodies.
using SolutionArrays = std::vector<SolutionArray>;

/// All of them, without numbers.
SolutionArrays emptyArrays();

SolutionArrays arraysOf(Level level);

/// And back, what arrays say of a level.
/// \throws bem::InputError if they do not go together, or hold a state that there is not.
Level levelOf(SolutionArrays arrays);

}  // namespace epafi::drivers
