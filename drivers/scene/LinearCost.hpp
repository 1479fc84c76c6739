#pragma once

#include <vector>

namespace epafi::drivers {

/// What a body brings to a level.
struct BodySize {
  double displacements = 0;
  double densities = 0;
  double multipliers = 0;
  double elements = 0;
  double grading = 1;  ///< largest over smallest element
  double met = 0;      ///< normal multipliers that act on another body, too
};

/// What a level takes, foretold from sizes alone.
struct Cost {
  double seconds;  ///< CPU, but for estimates and results, which all methods share
  double memory;   ///< peak [MiB], the program's own included
};

/// Memory of a process without matrices [MiB].
constexpr double programMemory = 47;

/// Up to so many multipliers of all bodies D is formed where operators are compressed, once
/// for all steps of a path: beyond, eliminations in the tree cost less.
int formedUpTo(int steps);

/// With dense matrices; bodies of u displacements, d densities, m multipliers, n elements,
/// M multipliers in all, on a path of so many steps,
///
///   Σ (d³/3 + d² u + u² d + u³/3 + u² m + 3 u m² + m³) / 42e9 + 2e-8 u d  +  steps N,
///   N = 3.5e-8 M² + 1.4e-11 M³  s,
///   Σ 8 (3.85 u d + 2.4 m²) + 13000 n  bytes:
///
/// what Cholesky's factors, S, D and the densities' responses multiply, the assembly, Newton's
/// steps; K with its transpose, V and S in halves, traction rows, D and what is made on the way
/// (doc/decisions/0016), fitted to the peaks of 56 levels.  Every process has all of it.
Cost denseCost(const std::vector<BodySize>& bodies, int steps, int processes);

/// With compressed operators,
///
///   Σ 9e-5 g (u + d) + 2.7e-3 c  +  2.7e-7 M² + steps N  s,
///   Σ 14e3 g' (u + d) + 36e3 m + 6e5 c  bytes,
///
/// where meshes graded l times by two have larger ranks, g = 1 + 0.01 l, g' = 1 + 0.13 l, and
/// what faces another body at c normal multipliers stays in skeletons.  Where D is not formed,
/// 3.1e-4 steps M in place of what M takes.  Of a path everything that results are made from is
/// kept, 450 (u + d) bytes a step; every process but the first adds 3e3 (u + d), the top of the
/// tree and vectors.
///                                                          [doc/benchmarks/compression.md]
Cost compressedCost(const std::vector<BodySize>& bodies, int steps, int processes);

}  // namespace epafi::drivers
