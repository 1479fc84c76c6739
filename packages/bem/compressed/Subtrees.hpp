#pragma once

#include "bem/base/Processes.hpp"
#include "bem/compressed/ClusterTree.hpp"
#include "bem/compressed/Interpolation.hpp"

#include <string>
#include <vector>

namespace epafi::bem {

/// Distribution of a cluster tree: each process owns whole subtrees below its roots; all
/// processes compute the clusters above the roots.  A single process has no subtrees.
///
/// Vectors are replicated.  All processes perform the same steps and exchange the results of
/// subtrees; each message carries its kind and a check number of the data that must be equal
/// on all processes.
class Subtrees {
 public:
  /// Balances the work by `weights`, one for each cluster.  Refers to the processes.
  Subtrees(const ClusterTree& tree, const std::vector<Index>& weights,
           const Processes& processes);

  bool isAlone() const { return processes_->count() == 1; }

  /// Does this process compute cluster c?
  bool isMine(int c) const { return isEverybodys(c) || ownerOf(c) == processes_->rank(); }
  bool isEverybodys(int c) const { return ownerOf(c) < 0; }
  /// Rank of the owner; -1: all processes compute the cluster
  int ownerOf(int c) const { return owners_[c]; }
  /// The topmost clusters of all subtrees.
  const std::vector<int>& roots() const { return roots_; }

  /// Replaces numbers of clusters by those of their owners.  forNumbers(action) calls
  /// action(c, number), in the same order on all processes.  Collective, as all below.
  /// \param failure error message of this process, empty if there is none
  /// \throws NumericalError with the failure of one of the processes, or if `kind` or `check`
  /// differ between processes
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

  /// Receives the matrices, rows(root) x columns, of the other processes' roots in `on`.
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

  /// Sets the rows of X in the leaves of `paths` to the values of their owners.
  void exchangeRows(const ClusterTree& tree, const std::vector<ClusterPart>& parts,
                    const std::vector<char>& paths, double check, Matrix& x) const;

  /// Throws a NumericalError on all processes if `failure` is not empty on one of them.
  void agree(const std::string& failure) const {
    exchangeNumbers(
        2, 0, [](const auto&) {}, failure);
  }

 private:
  Vector summed(double kind, double check, const std::string& failure,
                Vector numbers) const;
  [[noreturn]] void throwFirst(const std::string& failure) const;

  const Processes* processes_;
  std::vector<int> owners_;  ///< by cluster
  std::vector<int> roots_;
};

/// Check number of a matrix: different matrices almost never have the same.
double checkOf(const Matrix& x);

}  // namespace epafi::bem
