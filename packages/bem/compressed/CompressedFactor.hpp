#pragma once

#include "bem/compressed/CompressedOperators.hpp"
#include "bem/compressed/EliminatedCluster.hpp"

#include <memory>
#include <string>
#include <vector>

namespace epafi::bem {

/// Conditions on a solution of the compressed system besides its equations.
struct Restriction {
  /// By unknown: is it zero, with its equation dropped?
  std::vector<char> held;

  /// The unknown of the row, which is held, equals the value times the unknown of the column,
  /// in the same leaf.
  std::vector<Entry> followers;

  /// Entries added between unknowns of one leaf; a diagonal entry is a spring.
  std::vector<Entry> entries;
};

/// Solves the compressed system by elimination from the leaves to the root; pivots are chosen
/// within a cluster:
///
///   leaf    E = T D⁻¹ Tᵀ,   D its entries without held unknowns,
///   parent  E = T F⁻¹ diag(E₁, E₂) Tᵀ,   F = I + diag(E₁, E₂) [0 S; Sᵀ 0],
///
/// S: the entries between the skeletons of the children.  E, the response, maps a field from
/// outside a cluster to the unknowns of its skeleton.  Neither E nor S is inverted, since
/// both may be singular.                                     [doc/theory/compression.md]
///
/// Each process eliminates its subtrees, all eliminate the clusters above them; right-hand
/// sides and solutions are replicated.  Functions that compute are collective; an exception
/// is thrown on all processes.
///
/// Refers to the operators, which must outlive it.  A copy shares eliminated clusters until
/// one of the two is updated.
class CompressedFactor {
 public:
  /// \throws NumericalError if D or F is singular
  /// \throws std::logic_error for a follower or an entry between two leaves
  CompressedFactor(const CompressedOperators& operators, Restriction restriction);

  /// A factor for right-hand sides and unknowns in these leaves only.  Everything outside
  /// their lowest common ancestor is eliminated once; its response is added there.
  CompressedFactor restrictedTo(const std::vector<int>& leaves) const;

  /// Changes the restriction; eliminates only leaves where it differs and their ancestors.
  /// Returns the number of eliminated clusters.
  /// \throws std::logic_error if a leaf outside of the part of restrictedTo() changes (the
  /// factor stays as it is), or for a follower or an entry between two leaves
  /// \throws NumericalError as above; solve() then needs another update() first
  int update(Restriction restriction);

  /// X of Z X = B; held unknowns are zero or followers.
  /// \param refinements steps of iterative refinement with the residual of the density equations,
  /// which grows with the number of elements
  /// \throws std::logic_error for a factor made by restrictedTo()
  Matrix solve(const Matrix& b, int refinements = 1) const;

  /// solve() without refinement, for right-hand sides that are zero outside the leaves of
  /// `paths`.  Only the unknowns in these leaves are valid.
  Matrix solveAlong(const std::vector<char>& paths, const Matrix& b) const;
  /// By cluster: is it one of the leaves, an ancestor, or a cluster that every solution needs?
  std::vector<char> activePaths(std::vector<int> leaves) const;

  const Restriction& restriction() const { return restriction_; }

 private:
  /// `clusters` without those above top_.
  std::vector<char> withoutAbove(std::vector<char> clusters) const;
  void eliminate(const std::vector<char>& dirty);
  void exchangeResponses(const std::vector<char>& dirty, const std::string& failure);
  EliminatedCluster eliminated(int c, LeafRestriction restriction,
                               Response& response) const;
  /// By cluster: the part of the restriction in a leaf; empty if the leaf is not dirty or
  /// belongs to another process.
  std::vector<LeafRestriction> restricted(std::vector<char> dirty) const;
  /// Prepares the low-rank correction that removes the springs and adds exact rotations.
  void addBorder();
  /// Entries between the active unknowns of a cluster (P of a parent, D of a leaf), plus
  /// Tᵀ O T for the response O of everything outside.
  Matrix inside(int c, const Matrix* outside) const;
  /// O of a child, from P of its parent.
  Matrix outsideOf(int child, const Matrix& p) const;

  /// Solution without the low-rank correction, springs included.
  Matrix solveSprung(const Matrix& b, const std::vector<char>& paths) const;
  Matrix solveOnce(const Matrix& b, const std::vector<char>& paths) const;
  /// B - Z X in the equations of densities, else zero.  \pre no entries are added there
  Matrix leftOfDensities(const Matrix& b, const Matrix& x) const;

  const EliminatedCluster& node(int c) const { return *nodes_[c]; }
  const Response& response(int c) const { return *responses_[c]; }

  const CompressedOperators* operators_;
  Restriction restriction_;
  /// By cluster: is it possibly out of date after an update() that threw?
  std::vector<char> unfinished_;
  int top_ = 0;  ///< the root, or the lowest common ancestor of restrictedTo()
  std::shared_ptr<const Matrix>
      whole_;  ///< inside() of top_, if it is mine and not the root
  std::vector<std::shared_ptr<const EliminatedCluster>> nodes_;
  std::vector<std::shared_ptr<const Response>> responses_;
  /// Correction for springs on unknowns of CompressedOperators::springUnknowns that are not held, and
  /// for rotations; null without any.
  std::shared_ptr<const Woodbury> border_;
};

}  // namespace epafi::bem
