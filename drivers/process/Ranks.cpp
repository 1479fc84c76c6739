#include "drivers/process/Ranks.hpp"

#include "bem/base/Error.hpp"
#include "bem/tpetra/BelosSolver.hpp"
#include "bem/tpetra/MpiProcesses.hpp"
#include "drivers/process/ExitCode.hpp"
#include "drivers/process/Interrupt.hpp"

#include <Tpetra_Core.hpp>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>

namespace epafi::drivers {

namespace {

/// Environment variables that Open MPI, MPICH, its derivatives and srun of Slurm set.
bool startedByLauncher() {
  const char* variables[] = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK",
                             "MPI_LOCALNRANKS"};
  return std::any_of(std::begin(variables), std::end(variables),
                     [](const char* name) { return std::getenv(name) != nullptr; });
}

}  // namespace

Ranks::Ranks() : underMpirun_(startedByLauncher()) {
  if (underMpirun_)
    tpetra();
}

Ranks::~Ranks() = default;

const bem::MpiProcesses& Ranks::tpetra() const {
  if (tpetra_ == nullptr) {
    // not the arguments of main: Kokkos would interpret --threads and --help
    std::string name = "epafi";
    char* names[] = {name.data(), nullptr};
    char** argv = names;
    int argc = 1;
    scope_ = std::make_unique<Tpetra::ScopeGuard>(&argc, &argv);
    tpetra_ = std::make_unique<const bem::MpiProcesses>(Tpetra::getDefaultComm(), tell);
  }
  return *tpetra_;
}

const bem::Processes& Ranks::processes() const {
  if (underMpirun_)
    return *tpetra_;
  return alone_;
}

std::unique_ptr<const bem::SingleLayerSolver> Ranks::belosSolver(
    const bem::BelosOptions& options) const {
  return std::make_unique<const bem::BelosSolver>(tpetra(), options);
}

void Ranks::listenToSignals() const {
  catchSignals(underMpirun_ ? Grace::None : Grace::Second,
               isFirst() ? Voice::Loud : Voice::Silent);
}

bem::Failure Ranks::currentFailure() {
  try {
    throw;
  } catch (const bem::InputError& error) {
    return {BadInput, error.what()};
  } catch (const Interrupted& interrupted) {
    return {Signalled + interrupted.signal, interrupted.advice};
  } catch (const std::bad_alloc&) {
    return {Breakdown, "the memory does not suffice for this level"};
  } catch (const std::exception& error) {
    return {Breakdown, error.what()};
  } catch (const char* error) {  // NOX throws strings
    return {Breakdown, error};
  } catch (...) {
    return {Breakdown, "an unknown exception"};
  }
}

void Ranks::confirm() const {
  if (underMpirun_)
    tpetra_->consent().confirm();
}

bem::Failure Ranks::agree(const bem::Failure& mine) const {
  return underMpirun_ ? tpetra_->consent().report(mine) : mine;
}

void tell(const bem::Failure& failure) {
  // one write, so that messages of mpirun do not split it
  std::cerr << "epafi: " + failure.message + "\n" << std::flush;
}

bem::Vector largestOverRanks(const bem::Processes& processes, const bem::Vector& mine) {
  const std::size_t n = mine.size();
  const std::size_t ranks = processes.count();
  bem::Vector all(ranks * n);
  std::copy(mine.begin(), mine.end(),
            all.begin() + processes.rank() * static_cast<std::ptrdiff_t>(n));
  all = processes.sum(std::move(all));
  bem::Vector largest = mine;
  for (std::size_t r = 0; r < ranks; ++r)
    for (std::size_t i = 0; i < n; ++i)
      largest[i] = std::max(largest[i], all[r * n + i]);
  return largest;
}

}  // namespace epafi::drivers
