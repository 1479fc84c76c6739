#pragma once

#include "contact/problem/Problem.hpp"

namespace epafi::test {

/// The classical frictionless problem on which full steps from zero visit three active
/// sets for ever.
inline contact::Problem cyclingProblem() {
  using contact::Index;
  const double d[3][3] = {{9, -4, -5}, {-4, 5, 7}, {-5, 7, 10}};
  contact::Problem problem;
  problem.normals = 3;
  contact::Matrix flexibility(3, 3);
  for (Index i = 0; i < 3; ++i)
    for (Index j = 0; j < 3; ++j)
      flexibility(i, j) = d[i][j];
  problem.flexibility = std::move(flexibility);
  problem.offset = {8, -3, -2};
  problem.rigid = contact::Matrix(3, 0);
  return problem;
}

}  // namespace epafi::test
