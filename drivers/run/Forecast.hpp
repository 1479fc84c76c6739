#pragma once

#include "drivers/process/Ranks.hpp"
#include "drivers/run/BodySpaces.hpp"

#include <optional>
#include <string>

namespace epafi::drivers {

/// What solving a level will take at its peak, all processes together [MiB].
///
/// Per body with u displacements, d densities, m multipliers, n elements
///
///   8 (3.85 u d + 2.4 m²) + 13000 n  bytes,
///
/// K with its transpose, V and S in halves, traction rows, D and what is made on the way
/// (doc/decisions/0016), fitted to the peaks of 56 levels; 47 MiB a process for the program.
double forecastMemory(const BodySpaces& spaces, int processes);

/// The same of compressed operators: 24 kB per displacement and density, and 3 kB more for each
/// further process, as measured with degree 1 (doc/benchmarks/compression.md, mpi.md).
double forecastCompressedMemory(const BodySpaces& spaces, int processes);

/// Why a level is not begun that would not fit; nothing if it does.  `forecast` is its own;
/// `limit` the scene's, else what is free.  Collective.
std::optional<std::string> tooLarge(int level, const Size& size, double forecast,
                                    const std::optional<double>& limit,
                                    const Ranks& ranks);

}  // namespace epafi::drivers
