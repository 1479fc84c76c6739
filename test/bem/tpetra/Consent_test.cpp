// A failure on one rank reaches all of them, whatever they are about to do.
#include "bem/base/Error.hpp"
#include "bem/tpetra/DistributedRows.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <optional>

namespace epafi {

namespace {

/// As a program's outermost block does it.
template <class Work>
std::optional<bem::Failure> attempt(const bem::TpetraAlgebra& algebra, const Work& work) {
  try {
    work();
    algebra.consent().confirm();
    return std::nullopt;
  } catch (const bem::FailedElsewhere& elsewhere) {
    return elsewhere.failure;
  } catch (const std::exception& error) {
    return algebra.consent().report({2, error.what()});
  }
}

/// Much that is collective, with room for a failure of one rank before each call.
template <class Fault>
void compute(const bem::TpetraAlgebra& algebra, const Fault& fault) {
  const bem::Index n = 100;
  const bem::Rows rows = algebra.myRows(n);
  bem::Matrix a(rows.size(), n);
  for (bem::Index i = 0; i < rows.size(); ++i)
    a(i, rows.begin + i) = 4;
  fault(0);
  const bem::Matrix copy = a.copy();
  a = algebra.addGram(std::move(a), copy);
  fault(1);
  const bem::Vector x = algebra.multiplySymmetric(a, bem::Vector(100, 1.0));
  fault(2);
  const auto factor = algebra.cholesky(std::move(a), "A");
  fault(3);
  const bem::Vector y = factor->solve(x);
  fault(4);
  (void)algebra.broadcast(factor->backward(y));
  fault(5);
}

TEUCHOS_UNIT_TEST(Consent, isGivenWhereNobodyFails) {
  const bem::TpetraAlgebra algebra = test::allRanks();
  TEST_ASSERT(!attempt(algebra, [&] { compute(algebra, [](int) {}); }));
}

TEUCHOS_UNIT_TEST(Consent, endsAllRanksWithTheMessageOfTheOneThatFails) {
  const bem::TpetraAlgebra algebra = test::allRanks();
  for (int place = 0; place < 6; ++place)
    for (int rank = 0; rank < algebra.processes(); ++rank) {
      const std::string message = bem::message("rank ", rank, " at ", place);
      const auto failure = attempt(algebra, [&] {
        compute(algebra, [&](int here) {
          if (here == place && algebra.rank() == rank)
            throw bem::NumericalError(message);
        });
      });
      TEST_ASSERT(failure.has_value());
      TEST_EQUALITY(failure->message, message);
      TEST_EQUALITY_CONST(failure->code, 2);
    }
}

TEUCHOS_UNIT_TEST(Consent, agreesOnTheLowestOfSeveralFailures) {
  const bem::TpetraAlgebra algebra = test::allRanks();
  const auto failure = attempt(
      algebra, [&] { throw bem::NumericalError(bem::message("rank ", algebra.rank())); });
  TEST_ASSERT(failure.has_value());
  TEST_EQUALITY_CONST(failure->message, "rank 0");
}

}  // namespace

}  // namespace epafi
