#include "contact/problem/Flexibility.hpp"

#include "contact/RandomProblem.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>

namespace epafi {

namespace {

using contact::at;
using contact::Index;
using contact::Matrix;
using contact::Problem;
using contact::Vector;
using System = contact::Flexibility::Operator::System;

/// The largest residual of the three kinds of rows over what their terms add up to.
double residual(const Problem& problem, const System& system, const Matrix& b,
                const Matrix& z) {
  const Index n = problem.size();
  std::vector<double> sums(at(b.rows()));
  std::vector<double> sizes(at(b.rows()));
  const auto add = [&](Index i, double term) {
    sums[i] += term;
    sizes[i] += std::abs(term);
  };
  std::vector<bool> isRow(at(n));
  for (const Index i : system.rows)
    isRow[i] = true;
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n && isRow[i]; ++j)
      add(i, problem.flexibility(i, j) * z(j, 0));
    for (Index k = 0; k < system.motions.columns(); ++k) {
      if (isRow[i])
        add(i, -system.motions(i, k) * z(n + k, 0));
      add(n + k, system.motions(i, k) * z(i, 0));
    }
    if (!isRow[i])
      add(i, z(i, 0));
  }
  for (const auto& [row, column, value] : system.added)
    if (isRow[row])
      add(row, value * z(column, 0));
  for (const auto& [follower, leader, factor] : system.followers)
    add(follower, -factor * z(leader, 0));
  for (Index k = 0; k < system.stiffness.columns(); ++k)
    for (Index l = 0; l < system.stiffness.columns(); ++l)
      add(n + k, system.stiffness(k, l) * z(n + l, 0));
  double worst = 0;
  for (Index i = 0; i < b.rows(); ++i)
    worst = std::max(worst, std::abs(sums[i] - b(i, 0)) / (std::abs(b(i, 0)) + sizes[i]));
  return worst;
}

/// What each coefficient does: solved for, or following a leader by so much.
struct Row {
  bool isSolved = false;
  Index leader = -1;
  double factor = 0;
};

System systemOf(const Problem& problem, const std::vector<Row>& rows) {
  System system;
  system.motions = problem.rigid.copy();
  const auto springs = static_cast<Index>(problem.rigidStiffness.size());
  system.stiffness = Matrix(springs, springs);
  for (Index k = 0; k < springs; ++k)
    system.stiffness(k, k) = problem.stiffness(k);
  for (Index i = 0; i < problem.size(); ++i)
    if (rows[i].isSolved)
      system.rows.push_back(i);
    else if (rows[i].leader >= 0)
      system.followers.push_back({i, rows[i].leader, rows[i].factor});
  // what yields: pressures with their neighbours, shear by itself
  for (Index i = 0; i < problem.size(); ++i) {
    const double yields = 0.3 * problem.flexibility(i, i);
    system.added.push_back({i, i, yields});
    if (const Index next = i ^ 1; i < problem.normals && next < problem.normals)
      system.added.push_back({i, next, 0.1 * problem.flexibility(0, 0)});
  }
  return system;
}

}  // namespace

TEUCHOS_UNIT_TEST(Flexibility, factorsSystemsWithFollowersMotionsAndWhatYields) {
  for (const double springs : {0.0, 3.0}) {
    std::mt19937 random(29);
    test::Recipe recipe = test::Recipe::of("Coulomb", 1, 2);
    recipe.normals = 60;
    recipe.springs = springs;
    const Problem problem = test::randomProblem(recipe, random);
    const Index n = problem.size();
    std::uniform_int_distribution<Index> tangential(problem.normals, n - 1);
    std::uniform_real_distribution<double> number(-1, 1);

    for (const bool followersFirst : {true, false}) {
      // all normals closed, half of the tangentials follow theirs, or nothing at first
      std::vector<Row> rows(at(n));
      for (Index i = 0; i < n; ++i) {
        rows[i].isSolved = i < problem.normals || i % 2 == 0;
        if (!rows[i].isSolved && followersFirst)
          rows[i] = {false, i - problem.normals, 0.3};
      }
      for (int step = 0; step < 40; ++step) {
        const System system = systemOf(problem, rows);
        Matrix b(n + problem.rigidMotions(), 2);
        for (Index i = 0; i < b.rows(); ++i)
          b(i, 0) = number(random);
        const auto factor = problem.flexibility.factor(systemOf(problem, rows));
        TEST_COMPARE(residual(problem, system, b, factor->solve(b.copy())), <, 1e-9);
        for (int change = 0; change < 3; ++change) {
          const Index i = tangential(random);
          const Index normal = i - problem.normals;
          rows[i] = {!rows[i].isSolved};
          if (!rows[i].isSolved && rows[normal].isSolved)
            rows[i] = {false, normal, step % 2 == 0 ? 0.3 : -0.3};
        }
        // a place that opens takes its friction along
        const Index opened = step % problem.normals;
        rows[opened] = rows[opened + problem.normals] = {};
      }
    }
  }
}

}  // namespace epafi
