// Ranks sum, agree, and fail together: a failure on one reaches all of them, whatever they are about
// to do.
#include "bem/base/Error.hpp"
#include "bem/tpetra/MpiProcesses.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <Tpetra_Core.hpp>

#include <optional>

namespace epafi {

namespace {

bem::MpiProcesses allRanks() { return bem::MpiProcesses(Tpetra::getDefaultComm()); }

TEUCHOS_UNIT_TEST(MpiProcesses, sumAndBroadcast) {
  using bem::Vector;
  const bem::MpiProcesses processes = allRanks();
  const double rank = processes.rank();
  const double p = processes.count();
  TEST_COMPARE_ARRAYS(processes.sum({1, rank}), Vector({p, p * (p - 1) / 2}));
  const Vector own = processes.rank() == 0 ? Vector{3, 4, 5} : Vector{};
  TEST_COMPARE_ARRAYS(processes.broadcast(own), Vector({3, 4, 5}));
  TEST_ASSERT(processes.agreed(processes.rank() == 0));  // what the first one decides
  TEST_ASSERT(!processes.agreed(processes.rank() > 0));
}

/// As a program's outermost block does it.
template <class Work>
std::optional<bem::Failure> attempt(const bem::MpiProcesses& processes,
                                    const Work& work) {
  try {
    work();
    processes.consent().confirm();
    return std::nullopt;
  } catch (const bem::FailedElsewhere& elsewhere) {
    return elsewhere.failure;
  } catch (const std::exception& error) {
    return processes.consent().report({2, error.what()});
  }
}

/// Collective calls, with room for a failure of one rank before each.
template <class Fault>
void compute(const bem::MpiProcesses& processes, const Fault& fault) {
  for (int place = 0; place < 3; ++place) {
    fault(2 * place);
    const bem::Vector sum = processes.sum(bem::Vector(100, 1.0));
    fault(2 * place + 1);
    (void)processes.broadcast(sum);
  }
}

TEUCHOS_UNIT_TEST(Consent, isGivenWhereNobodyFails) {
  const bem::MpiProcesses processes = allRanks();
  TEST_ASSERT(!attempt(processes, [&] { compute(processes, [](int) {}); }));
}

TEUCHOS_UNIT_TEST(Consent, endsAllRanksWithTheMessageOfTheOneThatFails) {
  const bem::MpiProcesses processes = allRanks();
  for (int place = 0; place < 6; ++place)
    for (int rank = 0; rank < processes.count(); ++rank) {
      const std::string message = bem::message("rank ", rank, " at ", place);
      const auto failure = attempt(processes, [&] {
        compute(processes, [&](int here) {
          if (here == place && processes.rank() == rank)
            throw bem::NumericalError(message);
        });
      });
      TEST_ASSERT(failure.has_value());
      TEST_EQUALITY(failure->message, message);
      TEST_EQUALITY_CONST(failure->code, 2);
    }
}

TEUCHOS_UNIT_TEST(Consent, agreesOnTheLowestOfSeveralFailures) {
  const bem::MpiProcesses processes = allRanks();
  const auto failure = attempt(processes, [&] {
    throw bem::NumericalError(bem::message("rank ", processes.rank()));
  });
  TEST_ASSERT(failure.has_value());
  TEST_EQUALITY_CONST(failure->message, "rank 0");
}

}  // namespace

}  // namespace epafi
