#include "bem/base/Parallel.hpp"

#include "bem/base/BlasThreads.hpp"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <omp.h>
#include <thread>
#include <vector>

namespace epafi::bem {

namespace {

/// Does this thread work on rounds of which others may have some?
thread_local bool isInside = false;

/// Threads that sleep until there is something to do: OpenMP's own keep asking for a while,
/// which takes the processor from whatever else the machine has to do.
class Team {
 public:
  ~Team() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      ends_ = true;
    }
    called_.notify_all();
    for (std::thread& member : members_)
      member.join();
  }

  /// Calls work() here and on up to so many members, which may come late: those that have
  /// not begun when it returns here are not waited for.  \pre work does not throw.
  void run(std::size_t members, const std::function<void()>& work) {
    const std::unique_lock<std::mutex> turn(turn_, std::try_to_lock);
    if (!turn.owns_lock())  // another thread of the application has them
      return work();
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      grow(members);
      work_ = &work;
      wanted_ = std::min(members, members_.size());
    }
    for (std::size_t k = 0; k < members; ++k)
      called_.notify_one();
    work();
    std::unique_lock<std::mutex> lock(mutex_);
    wanted_ = 0;
    finished_.wait(lock, [&] { return working_ == 0; });
  }

 private:
  /// As far as the system has threads.
  void grow(std::size_t members) {
    try {
      while (members_.size() < members)
        members_.emplace_back([this] { serve(); });
    } catch (const std::exception&) {  // no more: those that there are do it
    }
  }

  void serve() {
    std::unique_lock<std::mutex> lock(mutex_);
    for (;;) {
      called_.wait(lock, [&] { return ends_ || wanted_ > 0; });
      if (ends_)
        return;
      --wanted_;
      ++working_;
      const std::function<void()>& work = *work_;
      lock.unlock();
      work();
      lock.lock();
      if (--working_ == 0)
        finished_.notify_one();
    }
  }

  std::mutex turn_;
  std::mutex mutex_;
  std::condition_variable called_;
  std::condition_variable finished_;
  const std::function<void()>* work_ = nullptr;
  std::size_t wanted_ = 0;   ///< members that may still begin
  std::size_t working_ = 0;  ///< members that have begun
  bool ends_ = false;
  std::vector<std::thread> members_;
};

Team& team() {
  static Team members;
  return members;
}

/// Threads of which each has so much to do [ns].
int threadsWith(double least, double work) {
  if (isInside)
    return 1;
  const double most = omp_get_max_threads();
  return static_cast<int>(std::clamp(work / least, 1.0, most));
}

}  // namespace

int threadsFor(double work) {
  constexpr double least = 1e5;
  return threadsWith(least, work);
}

int blasThreadsFor(double work) {
  constexpr double least = 2e7;
  return threadsWith(least, work);
}

bool Rounds::take(Index& first, Index& last) {
  first = next_.fetch_add(job_.atOnce);
  last = std::min(first + job_.atOnce, job_.rounds);
  return first < last;
}

void onThreads(const Job& job, const std::function<void(Rounds&)>& worker) {
  if (job.rounds <= 0)
    return;
  Rounds rounds(job);
  const Index shares = (job.rounds + job.atOnce - 1) / job.atOnce;
  const Index threads = std::min<Index>(threadsFor(job.work), shares);
  if (threads == 1)
    return worker(rounds);
  const BlasThreads serial(1);
  std::exception_ptr failure;
  std::mutex failing;
  team().run(at(threads - 1), [&] {
    isInside = true;
    try {
      worker(rounds);
    } catch (...) {
      rounds.stop();
      const std::lock_guard<std::mutex> lock(failing);
      if (failure == nullptr)
        failure = std::current_exception();
    }
    isInside = false;
  });
  if (failure != nullptr)
    std::rethrow_exception(failure);
}

}  // namespace epafi::bem
