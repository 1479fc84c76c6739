#pragma once

#include "bem/base/DenseAlgebra.hpp"
#include "bem/tpetra/Consent.hpp"

#include <memory>
#include <optional>

namespace Tpetra {
class ScopeGuard;
}

namespace epafi::drivers {

/// The processes of a run: those that mpirun has started, else this one, which then
/// leaves MPI alone.
class Ranks {
 public:
  /// Starts MPI under mpirun.
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  const bem::DenseAlgebra& algebra() const { return *algebra_; }

  /// One rank writes files and speaks.
  bool isFirst() const { return algebra_->rank() == 0; }
  bool underMpirun() const { return scope_ != nullptr; }

  /// Does work() and returns nothing, or what kept one of the ranks from doing it: the
  /// same on all of them.
  template <class Work>
  std::optional<bem::Failure> attempt(const Work& work) const {
    try {
      work();
      confirm();
      return std::nullopt;
    } catch (const bem::FailedElsewhere& elsewhere) {
      return elsewhere.failure;
    } catch (...) {
      return agree(currentFailure());
    }
  }

 private:
  static bem::Failure currentFailure();
  void confirm() const;
  bem::Failure agree(const bem::Failure& mine) const;

  std::unique_ptr<Tpetra::ScopeGuard> scope_;  // ends MPI last
  std::unique_ptr<const bem::DenseAlgebra> algebra_;
  const bem::Consent* consent_ = nullptr;
};

/// Prints the one message of a run that fails.
void tell(const bem::Failure& failure);

/// The largest over all ranks, number by number.
bem::Vector largestOverRanks(const bem::DenseAlgebra& algebra, const bem::Vector& mine);

}  // namespace epafi::drivers
