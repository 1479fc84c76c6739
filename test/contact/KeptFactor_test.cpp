#include "contact/newton/KeptFactor.hpp"

#include "contact/RandomProblem.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>

namespace epafi {

namespace {

using contact::at;
using contact::Index;
using contact::KeptFactor;
using contact::Matrix;
using contact::Problem;
using contact::Vector;
using Rows = std::vector<KeptFactor::Row>;

/// The largest residual of the three kinds of rows over what their terms add up to.
double residual(const Problem& problem, const Matrix& motions, const Rows& rows,
                const Vector& b, const Vector& z) {
  const Index n = problem.size();
  double worst = 0;
  const auto count = [&](double rest, double size) {
    worst = std::max(worst, std::abs(rest) / size);
  };
  for (Index i = 0; i < n; ++i) {
    double sum = rows[i].isSolved ? 0 : z[i];
    double size = std::abs(b[i]) + std::abs(sum);
    const auto add = [&](double term) {
      sum += term;
      size += std::abs(term);
    };
    for (Index j = 0; j < n && rows[i].isSolved; ++j)
      add(problem.flexibility(i, j) * z[j]);
    for (Index k = 0; k < motions.columns() && rows[i].isSolved; ++k)
      add(-motions(i, k) * z[n + k]);
    for (const KeptFactor::Row::Share& share : rows[i].followed)
      add(-share.factor * z[share.leader]);
    count(sum - b[i], size);
  }
  for (Index k = 0; k < motions.columns(); ++k) {
    double sum = 0;
    double size = std::abs(b[n + k]);
    for (Index i = 0; i < n; ++i) {
      sum += motions(i, k) * z[i];
      size += std::abs(motions(i, k) * z[i]);
    }
    count(sum - b[n + k], size);
  }
  return worst;
}

}  // namespace

TEUCHOS_UNIT_TEST(KeptFactor, solvesSystemsThatDifferInFewRows) {
  std::mt19937 random(29);
  test::Recipe recipe;
  recipe.normals = 60;
  recipe.law = "Coulomb";
  recipe.rigidMotions = 2;
  const Problem problem = test::randomProblem(recipe, random);
  const Matrix motions = problem.rigid.copy();
  const Index n = problem.size();
  std::uniform_int_distribution<Index> tangential(problem.normals, n - 1);
  std::uniform_real_distribution<double> number(-1, 1);

  // all normals closed, half of the tangentials follow theirs
  Rows rows(at(n));
  for (Index i = 0; i < n; ++i) {
    rows[i].isSolved = i < problem.normals || i % 2 == 0;
    if (!rows[i].isSolved)
      rows[i].followed = {{i - problem.normals, 0.3}};
  }
  contact::FactorMemory memory;
  const Rows first = rows;
  for (int step = 0; step < 40; ++step) {
    const auto factor = KeptFactor::make(problem.flexibility, motions, rows, memory);
    TEST_ASSERT(factor != nullptr);
    if (factor == nullptr)
      return;
    Vector b;
    for (Index i = 0; i < n + motions.columns(); ++i)
      b.push_back(number(random));
    TEST_COMPARE(residual(problem, motions, rows, b, factor->solve(b)), <, 1e-9);
    // the one before answers as before, whatever was kept since
    const auto again = KeptFactor::make(problem.flexibility, motions, first, memory);
    TEST_COMPARE(residual(problem, motions, first, b, again->solve(b)), <, 1e-9);
    TEST_COMPARE(residual(problem, motions, rows, b, factor->solve(b)), <, 1e-9);
    for (int change = 0; change < 3; ++change) {
      KeptFactor::Row& row = rows[tangential(random)];
      const Index i = &row - rows.data();
      row.isSolved = !row.isSolved;
      row.followed.clear();
      if (!row.isSolved && rows[i - problem.normals].isSolved)
        row.followed = {{i - problem.normals, step % 2 == 0 ? 0.3 : -0.3}};
    }
    // a place that opens takes its friction along
    const Index opened = step % problem.normals;
    rows[opened].isSolved = false;
    rows[opened + problem.normals].isSolved = false;
    rows[opened + problem.normals].followed.clear();
  }
}

}  // namespace epafi
