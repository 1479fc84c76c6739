#include "bem/tpetra/Consent.hpp"

#include <chrono>
#include <thread>

namespace epafi::bem {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds patience(1500);

bool completed(MPI_Request& request) {
  int flag = 0;
  MPI_Test(&request, &flag, MPI_STATUS_IGNORE);
  return flag != 0;
}

}  // namespace

Consent::Consent(MPI_Comm comm, LastResort lastResort)
    : lastResort_(std::move(lastResort)) {
  MPI_Comm_dup(comm, &comm_);
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &processes_);
}

Consent::~Consent() { MPI_Comm_free(&comm_); }

void Consent::confirm() const {
  if (processes_ == 1)
    return;
  int failing = 0;
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Iallreduce(&processes_, &failing, 1, MPI_INT, MPI_MIN, comm_, &request);
  MPI_Wait(&request, MPI_STATUS_IGNORE);
  if (failing < processes_)
    throw FailedElsewhere(announce(failing, {}));
}

Failure Consent::report(const Failure& mine) const {
  if (processes_ == 1)
    return mine;
  int failing = 0;
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Iallreduce(&rank_, &failing, 1, MPI_INT, MPI_MIN, comm_, &request);
  for (const auto deadline = Clock::now() + patience; !completed(request);) {
    if (Clock::now() > deadline) {
      if (lastResort_)
        lastResort_(mine);
      MPI_Abort(comm_, mine.code);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return announce(failing, mine);
}

Failure Consent::announce(int failingRank, const Failure& mine) const {
  int header[2] = {mine.code, static_cast<int>(mine.message.size())};
  MPI_Bcast(header, 2, MPI_INT, failingRank, comm_);
  std::string message = mine.message;
  message.resize(static_cast<std::size_t>(header[1]));
  MPI_Bcast(message.data(), header[1], MPI_CHAR, failingRank, comm_);
  return {header[0], message};
}

}  // namespace epafi::bem
