#pragma once

#include "bem/base/Processes.hpp"
#include "bem/compressed/ClusterTree.hpp"
#include "bem/compressed/Interpolation.hpp"

#include <string>
#include <vector>

namespace epafi::bem {

/// What each process has of a tree: whole subtrees below some clusters, its roots; what is
/// above them everybody computes.  One process has all above and no subtrees.
///
/// Vectors are replicated.  Whatever is computed from them runs on all processes in the same
/// steps, with what comes from a subtree sent around; each message says what it is and carries
/// a check of the numbers that all should agree in.
class Subtrees {
 public:
  /// `weights`: of the clusters, by which the work is balanced.  The processes outlive it.
  Subtrees(const ClusterTree& tree, const std::vector<Index>& weights,
           const Processes& processes);

  bool isAlone() const { return processes_->count() == 1; }

  /// Does this process compute with a cluster?
  bool isMine(int c) const { return isEverybodys(c) || ownerOf(c) == processes_->rank(); }
  bool isEverybodys(int c) const { return ownerOf(c) < 0; }
  /// -1: everybody
  int ownerOf(int c) const { return owners_[c]; }
  /// Of the clusters that one process has those whose parents are everybody's.
  const std::vector<int>& roots() const { return roots_; }

  /// forNumbers(action) calls action(c, number) for numbers of clusters, on all processes in
  /// one order: each is replaced by that of the cluster's owner.  `failure`: why this process
  /// cannot go on; empty: it can.  Collective, as all below.
  /// \throws NumericalError with the failure of one of the processes, or where `kind` or
  /// `check` are not the same on all.
  template <class ForNumbers>
  void exchangeNumbers(double kind, double check, const ForNumbers& forNumbers,
                       const std::string& failure = "") const {
    if (isAlone() && failure.empty())
      return;
    Vector numbers;
    forNumbers([&](int c, double number) {
      numbers.push_back(ownerOf(c) == processes_->rank() ? number : 0);
    });
    numbers = summed(kind, check, failure, std::move(numbers));
    auto next = numbers.begin();
    forNumbers([&](int c, double& number) {
      if (!isEverybodys(c))
        number = *next;
      ++next;
    });
  }

  /// Others' matrices of the roots of `on`; rows(root) are so many.
  template <class Rows>
  void exchangeRoots(const std::vector<char>& on, double check, const Rows& rows,
                     Index columns, std::vector<Matrix>& matrices) const {
    const auto forRoots = [&](const auto& action) {
      for (const int root : roots_)
        if (on[root] != 0)
          action(root, matrices[root]);
    };
    forRoots([&](int root, Matrix& matrix) {
      if (!isMine(root))
        matrix = Matrix(rows(root), columns);
    });
    exchangeNumbers(3, check, [&](const auto& action) {
      forRoots([&](int root, Matrix& matrix) {
        for (Index j = 0; j < columns; ++j)
          for (Index i = 0; i < matrix.rows(); ++i)
            action(root, matrix(i, j));
      });
    });
  }

  /// Replaces the rows of X in other processes' leaves of `paths` by theirs.
  void exchangeRows(const ClusterTree& tree, const std::vector<ClusterPart>& parts,
                    const std::vector<char>& paths, double check, Matrix& x) const;

  /// Throws the NumericalError that one of the processes has met; nothing where all messages
  /// are empty.
  void agree(const std::string& failure) const {
    exchangeNumbers(
        2, 0, [](const auto&) {}, failure);
  }

 private:
  Vector summed(double kind, double check, const std::string& failure,
                Vector numbers) const;
  [[noreturn]] void throwFirst(const std::string& failure) const;

  const Processes* processes_;
  std::vector<int> owners_;  ///< of the clusters
  std::vector<int> roots_;
};

/// A number that hardly any other numbers have.
double checkOf(const Matrix& x);

}  // namespace epafi::bem
