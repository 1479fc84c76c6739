#include "bem/base/Parallel.hpp"

#include "bem/base/BlasThreads.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <dlfcn.h>
#include <mutex>
#include <new>
#include <omp.h>
#include <stdexcept>
#include <thread>

namespace epafi::bem {
namespace {

constexpr double large = 1e9;  // ns

/// So many threads of OpenMP while it lives.
class Threads {
 public:
  explicit Threads(int threads) { omp_set_num_threads(threads); }
  ~Threads() { omp_set_num_threads(before_); }
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

 private:
  int before_ = omp_get_max_threads();
};

/// Counts those who come.
class Meeting {
 public:
  /// Waits until so many have come, but not forever.
  void wait(int expected, std::chrono::milliseconds most = std::chrono::minutes(1)) {
    std::unique_lock<std::mutex> lock(mutex_);
    ++come_;
    changed_.notify_all();
    changed_.wait_for(lock, most, [&] { return come_ >= expected; });
  }
  int come() const { return come_; }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int come_ = 0;
};

TEUCHOS_UNIT_TEST(ParallelFor, visitsEachRoundOnce) {
  for (const int count : {1, 2, 4}) {
    const Threads threads(count);
    for (const Index rounds : {0, 1, 2, 7, 100, 1001})
      for (const Index atOnce : {1, 16}) {
        std::vector<std::atomic<int>> visits(at(rounds));
        Meeting meeting;
        const Index shares = (rounds + atOnce - 1) / atOnce;
        const int expected = static_cast<int>(std::min<Index>(count, shares));
        parallelFor(
            {rounds, large, atOnce},
            [&] {
              meeting.wait(expected);
              return 0;
            },
            [&](int, Index k) { ++visits[at(k)]; });
        TEST_ASSERT(std::all_of(visits.begin(), visits.end(),
                                [](const auto& n) { return n == 1; }));
      }
  }
}

TEUCHOS_UNIT_TEST(ParallelFor, givesEachThreadAWorkspace) {
  const Threads threads(4);
  std::atomic<int> made = 0;
  std::atomic<int> wrong = 0;
  struct Workspace {
    std::thread::id owner = std::this_thread::get_id();
  };
  Meeting meeting;
  parallelFor(
      {1000, large},
      [&] {
        ++made;
        meeting.wait(4);
        return Workspace();
      },
      [&](Workspace& own, Index) {
        if (own.owner != std::this_thread::get_id())
          ++wrong;
      });
  TEST_EQUALITY(made, 4);
  TEST_EQUALITY(wrong, 0);
}

// From one round among many, from all at once, and from a workspace.
TEUCHOS_UNIT_TEST(ParallelFor, throwsToItsCaller) {
  for (const int count : {1, 2, 4}) {
    const Threads threads(count);
    for (const Index bad : {0, 500, 999})
      TEST_THROW(parallelFor({1000, large},
                             [&](Index k) {
                               if (k == bad)
                                 throw std::out_of_range("bad");
                             }),
                 std::out_of_range);
    TEST_THROW(parallelFor({1000, large}, [](Index) { throw std::bad_alloc(); }),
               std::bad_alloc);
    TEST_THROW(
        parallelFor(
            {1000, large}, []() -> int { throw std::bad_alloc(); }, [](int&, Index) {}),
        std::bad_alloc);
  }
}

TEUCHOS_UNIT_TEST(ParallelFor, leavesOutWhatHasNotBegunWhenOneThrows) {
  const Threads threads(2);
  constexpr Index rounds = 1000000;
  std::atomic<Index> visits = 0;
  TEST_THROW(parallelFor({rounds, large},
                         [&](Index k) {
                           ++visits;
                           if (k == 0)
                             throw std::bad_alloc();
                         }),
             std::bad_alloc);
  TEST_COMPARE(visits, <, rounds);
}

/// One more would have a moment to come.
int threadsOf(const Job& job, int expected) {
  Meeting meeting;
  onThreads(job, [&](Rounds&) {
    meeting.wait(expected);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  });
  return meeting.come();
}

TEUCHOS_UNIT_TEST(ParallelFor, keepsSmallWorkOnOneThread) {
  const Threads threads(4);
  TEST_EQUALITY(threadsOf({1000, 1e4}, 1), 1);
  TEST_EQUALITY(threadsOf({1000, large}, 4), 4);
  TEST_EQUALITY(threadsOf({1, large}, 1), 1);
  TEST_EQUALITY(threadsOf({32, large, 16}, 2), 2);
  TEST_EQUALITY(threadsFor(0), 1);
  TEST_EQUALITY(threadsFor(large), 4);
  TEST_EQUALITY(blasThreadsFor(1e6), 1);
  TEST_EQUALITY(blasThreadsFor(large), 4);
}

TEUCHOS_UNIT_TEST(ParallelFor, throwsToItsCallerFromAnotherThread) {
  const Threads threads(2);
  const auto caller = std::this_thread::get_id();
  Meeting meeting;
  TEST_THROW(parallelFor({2, large},
                         [&](Index) {
                           meeting.wait(2);
                           if (std::this_thread::get_id() != caller)
                             throw std::bad_alloc();
                         }),
             std::bad_alloc);
  TEST_EQUALITY(threadsOf({2, large}, 2), 2);  // and goes on
}

TEUCHOS_UNIT_TEST(ParallelFor, givesLoopsInItsRoundsOneThread) {
  const Threads threads(2);
  std::atomic<int> several = 0;
  Meeting meeting;
  parallelFor({2, large}, [&](Index) {
    meeting.wait(2);
    if (threadsFor(large) > 1 || blasThreadsFor(large) > 1)
      ++several;
  });
  TEST_EQUALITY(meeting.come(), 2);
  TEST_EQUALITY(several, 0);
  TEST_EQUALITY(threadsFor(large), 2);  // behind them
}

/// OpenBLAS' own functions, null where another BLAS is loaded.
struct OpenBlas {
  int (*threads)() = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT,
                                                       "openblas_get_num_threads"));
  void (*setThreads)(int) =
      reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"));
};

// However the lives of limits overlap, the least one holds, and none is left behind.
TEUCHOS_UNIT_TEST(BlasThreads, ofTwoThreadsLimitEachOther) {
  const OpenBlas blas;
  if (blas.threads == nullptr || blas.setThreads == nullptr)
    return;
  const int before = blas.threads();
  constexpr int unlimited = 4;
  blas.setThreads(unlimited);
  for (const int other : {1, 2, 3}) {
    constexpr int own = 2;
    Meeting first;
    Meeting second;
    int beside = 0;  // what the first one saw when both held
    int after = 0;   // and the second one when the first was gone
    std::thread one([&] {
      {
        const BlasThreads limit(own);
        first.wait(2);
        second.wait(2);
        beside = blas.threads();
      }
      first.wait(3);
    });
    std::thread two([&] {
      first.wait(2);
      const BlasThreads limit(other);
      second.wait(2);
      first.wait(4);
      after = blas.threads();
    });
    one.join();
    two.join();
    out << "limits of " << own << " and " << other << ": ";
    TEST_EQUALITY(beside, std::min(own, other));
    TEST_EQUALITY(after, other);
    TEST_EQUALITY(blas.threads(), unlimited);
  }
  blas.setThreads(before);
}

}  // namespace
}  // namespace epafi::bem
