#include "contact/problem/Flexibility.hpp"

#include "bem/algebra/Products.hpp"
#include "contact/RandomProblem.hpp"
#include "contact/problem/BodyFlexibility.hpp"

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

/// A chain of bodies, each with two of the joints and its own motions; D a sum over bodies.
TEUCHOS_UNIT_TEST(Flexibility, sumsOverBodiesAreWhatTheyAddUpTo) {
  constexpr Index bodies = 20;
  constexpr Index atJoint = 3;  // normals, and as many tangentials
  constexpr Index motions = 2;  // of a body
  std::mt19937 random(41);
  std::uniform_real_distribution<double> number(-1, 1);
  Problem problem;
  problem.normals = atJoint * (bodies - 1);
  problem.tangentials.resize(at(problem.normals), contact::Tangential(0, {}));
  const Index n = problem.size();
  std::vector<contact::BodyFlexibility::Part> parts;
  problem.rigid = Matrix(n, motions * (bodies - 1));
  for (Index b = 0; b < bodies; ++b) {
    contact::BodyFlexibility::Part part;
    for (const Index first : {Index{0}, problem.normals})
      for (Index i = std::max<Index>(atJoint * (b - 1), 0);
           i < std::min(atJoint * (b + 1), problem.normals); ++i)
        part.columns.push_back(first + i);
    const auto size = static_cast<Index>(part.columns.size());
    Matrix root(size, size);
    for (Index i = 0; i < size; ++i) {
      for (Index j = 0; j < size; ++j)
        root(i, j) = number(random);
      // the first body is held
      for (Index k = 0; b > 0 && k < motions; ++k)
        problem.rigid(part.columns[at(i)], motions * (b - 1) + k) = number(random);
    }
    part.entries = bem::product(root, bem::transposed(root));
    parts.push_back(std::move(part));
  }
  std::vector<std::vector<Index>> columns;
  for (const auto& part : parts)
    columns.push_back(part.columns);
  TEST_ASSERT(contact::BodyFlexibility::isSparse(n, columns));
  const contact::BodyFlexibility sum(n, std::move(parts));
  problem.flexibility = sum.formed();
  for (Index k = 0; k < problem.rigid.columns(); ++k)
    problem.rigidLoad.push_back(number(random));

  Vector x;
  for (Index i = 0; i < n; ++i)
    x.push_back(number(random));
  const Vector whole = problem.flexibility.times(x);
  const auto [value, magnitude] = sum.product(x);
  for (Index i = 0; i < n; ++i) {
    TEST_COMPARE(std::abs(value[at(i)] - whole[at(i)]), <, 1e-13 * magnitude[at(i)]);
    TEST_COMPARE(magnitude[at(i)], >=, std::abs(whole[at(i)]));
  }

  std::uniform_int_distribution<int> kind(0, 3);
  for (int trial = 0; trial < 20; ++trial) {
    // most joints closed; tangentials stick, follow their pressures or slip freely
    std::vector<Row> rows(at(n));
    for (Index i = 0; i < problem.normals; ++i) {
      rows[at(i)].isSolved = trial == 0 || kind(random) > 0 || i % atJoint == 0;
      Row& shear = rows[at(problem.normals + i)];
      const int what = kind(random);
      shear.isSolved = trial == 0 || what > 1 || i % atJoint < 2;
      if (!shear.isSolved && what == 1 && rows[at(i)].isSolved)
        shear = {false, i, trial % 2 == 0 ? 0.3 : -0.3};
    }
    const System system = systemOf(problem, rows);
    Matrix b(n + problem.rigidMotions(), 2);
    for (Index i = 0; i < b.rows(); ++i)
      b(i, 0) = number(random);
    const Matrix z = sum.factor(systemOf(problem, rows))->solve(b.copy());
    TEST_COMPARE(residual(problem, system, b, z), <, 1e-9);
    for (Index i = 0; i < z.rows(); ++i)
      TEST_EQUALITY(z(i, 1), 0);
  }

  // a body that nothing holds
  std::vector<Row> rows(at(n));
  for (Index i = 0; i < n; ++i)
    rows[at(i)].isSolved = i % problem.normals >= atJoint;
  for (Index i = 0; i < n; ++i)
    for (Index k = 0; k < motions; ++k)
      problem.rigid(i, k) = i % problem.normals < atJoint ? problem.rigid(i, k) : 0;
  TEST_THROW(sum.factor(systemOf(problem, rows)), contact::SingularJacobian);
}

}  // namespace epafi
