// What several ranks compute is what LAPACK computes on the whole matrices.
#include "bem/base/Error.hpp"
#include "bem/tpetra/DistributedRows.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <limits>
#include <random>
#include <string>

namespace epafi {

namespace {

using bem::Index;
using bem::Matrix;
using bem::Vector;
using test::difference;
using test::differenceBelow;
using test::mine;

const bem::LapackAlgebra lapack;
constexpr double rounding = 1e-12;

// fewer rows than ranks, about one panel, several, no multiples
constexpr Index sizes[] = {1, 2, 7, 65, 256, 257, 700};

Matrix randomMatrix(Index n, Index m, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> entry(-1, 1);
  Matrix a(n, m);
  for (Index j = 0; j < m; ++j)
    for (Index i = 0; i < n; ++i)
      a(i, j) = entry(random);
  return a;
}

Vector randomVector(Index n, unsigned seed) {
  const Matrix a = randomMatrix(n, 1, seed);
  return {a.data(), a.data() + n};
}

/// Symmetric, with what nobody may read above the diagonal.
Matrix lowerTriangle(Index n, unsigned seed, double shift) {
  Matrix a = randomMatrix(n, n, seed);
  for (Index j = 0; j < n; ++j) {
    a(j, j) += shift;
    for (Index i = 0; i < j; ++i)
      a(i, j) = std::numeric_limits<double>::quiet_NaN();
  }
  return a;
}

Matrix positiveDefinite(Index n) {
  return lowerTriangle(n, 1, 2.0 * static_cast<double>(n));
}

TEUCHOS_UNIT_TEST(TpetraAlgebra, dealsOutEveryRowOnceInOrder) {
  const bem::TpetraAlgebra algebra = test::allRanks();
  for (const Index n : sizes) {
    const bem::Rows rows = algebra.myRows(n);
    Vector owners(n);
    for (Index i = rows.begin; i < rows.end; ++i)
      owners[i] = 1 + algebra.rank();
    owners = algebra.sum(owners);
    TEST_COMPARE(*std::min_element(owners.begin(), owners.end()), >=, 1);
    TEST_ASSERT(std::is_sorted(owners.begin(), owners.end()));
    const auto map = algebra.rowMap(n);
    TEST_EQUALITY(static_cast<Index>(map->getNodeNumElements()), rows.size());
    if (rows.size() > 0)
      TEST_EQUALITY(map->getMinGlobalIndex(), rows.begin);
  }
}

TEUCHOS_UNIT_TEST(TpetraAlgebra, solvesWithTheFactorAsLapackDoes) {
  const bem::TpetraAlgebra algebra = test::allRanks();
  for (const Index n : sizes) {
    const Matrix a = positiveDefinite(n);
    const auto whole = lapack.cholesky(a.copy(), "A");
    const auto factor = algebra.cholesky(mine(algebra, a), "A");
    const Vector b = randomVector(n, 2);
    TEST_COMPARE(difference(factor->solve(b), whole->solve(b)), <, rounding);
    TEST_COMPARE(difference(factor->backward(b), whole->backward(b)), <, rounding);
    for (const Index m : {Index(0), Index(1), Index(63), Index(130)}) {
      const Matrix rows = randomMatrix(n, m, 3);
      TEST_COMPARE(difference(algebra, factor->forward(mine(algebra, rows)),
                              whole->forward(rows.copy())),
                   <, rounding);
    }
  }
}

TEUCHOS_UNIT_TEST(TpetraAlgebra, refusesAnIndefiniteMatrixOnAllRanks) {
  const bem::TpetraAlgebra algebra = test::allRanks();
  for (const Index n : sizes)
    for (const Index row : {Index(0), n / 2, n - 1}) {
      Matrix a = positiveDefinite(n);
      a(row, row) = -1;
      TEST_THROW(algebra.cholesky(mine(algebra, a), "A"), bem::NumericalError);
      // and goes on working
      const Vector b = randomVector(n, 2);
      TEST_COMPARE(difference(algebra.sum(b), b), <=, algebra.processes());
    }
}

TEUCHOS_UNIT_TEST(TpetraAlgebra, namesTheRowThatLapackNames) {
  const bem::TpetraAlgebra algebra = test::allRanks();
  const auto complaint = [](const auto& factorise) -> std::string {
    try {
      factorise();
    } catch (const bem::NumericalError& error) {
      return error.what();
    }
    return "none";
  };
  for (const Index row : {Index(0), Index(255), Index(256), Index(500), Index(699)}) {
    Matrix a = positiveDefinite(700);
    a(row, row) = -1;
    const std::string alone = complaint([&] { lapack.cholesky(a.copy(), "A"); });
    TEST_EQUALITY(complaint([&] { algebra.cholesky(mine(algebra, a), "A"); }), alone);
  }
}

TEUCHOS_UNIT_TEST(TpetraAlgebra, multipliesAsLapackDoes) {
  const bem::TpetraAlgebra algebra = test::allRanks();
  for (const Index n : sizes)
    for (const Index m : {Index(0), Index(1), Index(64), Index(301)}) {
      const Matrix x = randomMatrix(n, m, 4);
      const Matrix y = randomMatrix(n, 17, 5);
      const Matrix z = randomMatrix(m, 17, 9);
      const Matrix c = lowerTriangle(m, 6, 1);
      const Matrix d = lowerTriangle(n, 7, 1);
      TEST_COMPARE(
          differenceBelow(algebra, algebra.addGram(mine(algebra, c), mine(algebra, x)),
                          lapack.addGram(c.copy(), x)),
          <, rounding);
      TEST_COMPARE(
          differenceBelow(algebra,
                          algebra.addOuter(mine(algebra, d), mine(algebra, x), -0.7),
                          lapack.addOuter(d.copy(), x, -0.7)),
          <, rounding);
      TEST_COMPARE(difference(algebra,
                              algebra.addTransposeTimes(
                                  mine(algebra, z), mine(algebra, x), mine(algebra, y)),
                              lapack.addTransposeTimes(z.copy(), x, y)),
                   <, rounding);
      const Vector v = randomVector(m, 8);
      TEST_COMPARE(
          difference(algebra.multiply(mine(algebra, x), n, v), lapack.multiply(x, n, v)),
          <, rounding);
      const Matrix all = algebra.replicate(mine(algebra, x), n);
      TEST_EQUALITY(all.rows(), n);
      TEST_EQUALITY_CONST(difference(lapack, all, x), 0);
    }
}

TEUCHOS_UNIT_TEST(TpetraAlgebra, multipliesASymmetricMatrixByItsLowerTriangle) {
  const bem::TpetraAlgebra algebra = test::allRanks();
  for (const Index n : sizes) {
    const Matrix a = lowerTriangle(n, 9, 1);
    const Vector v = randomVector(n, 10);
    TEST_COMPARE(difference(algebra.multiplySymmetric(mine(algebra, a), v),
                            lapack.multiplySymmetric(a, v)),
                 <, rounding);
  }
}

TEUCHOS_UNIT_TEST(TpetraAlgebra, sumsAndBroadcasts) {
  const bem::TpetraAlgebra algebra = test::allRanks();
  const double rank = algebra.rank();
  const double p = algebra.processes();
  TEST_COMPARE_ARRAYS(algebra.sum({1, rank}), Vector({p, p * (p - 1) / 2}));
  const Vector own = algebra.rank() == 0 ? Vector{3, 4, 5} : Vector{};
  TEST_COMPARE_ARRAYS(algebra.broadcast(own), Vector({3, 4, 5}));
}

}  // namespace

}  // namespace epafi
