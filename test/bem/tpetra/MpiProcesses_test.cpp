#include "bem/tpetra/AllRanks.hpp"

#include <Teuchos_UnitTestHarness.hpp>

namespace epafi {

namespace {

using bem::Vector;

TEUCHOS_UNIT_TEST(MpiProcesses, sumAndBroadcast) {
  const bem::MpiProcesses processes = test::allRanks();
  const double rank = processes.rank();
  const double p = processes.count();
  TEST_COMPARE_ARRAYS(processes.sum({1, rank}), Vector({p, p * (p - 1) / 2}));
  const Vector own = processes.rank() == 0 ? Vector{3, 4, 5} : Vector{};
  TEST_COMPARE_ARRAYS(processes.broadcast(own), Vector({3, 4, 5}));
}

TEUCHOS_UNIT_TEST(MpiProcesses, agreeOnWhatTheFirstOneDecides) {
  const bem::MpiProcesses processes = test::allRanks();
  TEST_ASSERT(processes.agreed(processes.rank() == 0));
  TEST_ASSERT(!processes.agreed(processes.rank() > 0));
}

}  // namespace

}  // namespace epafi
