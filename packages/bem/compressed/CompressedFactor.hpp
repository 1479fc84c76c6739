#pragma once

#include "bem/compressed/CompressedOperators.hpp"
#include "bem/compressed/EliminatedCluster.hpp"

#include <memory>
#include <string>
#include <vector>

namespace epafi::bem {

/// What is asked of a solution of the compressed system besides its equations.
struct Restriction {
  /// By unknown: is it zero, and its equation not asked for?
  std::vector<char> held;

  /// A held unknown, the row, is this multiple of another one of its leaf instead of zero.
  std::vector<Entry> followers;

  /// Added between unknowns of one leaf; on the diagonal a spring.
  std::vector<Entry> entries;
};

/// Solves the compressed system by elimination in its tree, without pivots beyond a
/// cluster:
///
///   leaf    E = T D⁻¹ Tᵀ,   D its entries without what is held,
///   parent  E = T F⁻¹ diag(E₁, E₂) Tᵀ,   F = I + diag(E₁, E₂) [0 S; Sᵀ 0],
///
/// S the entries between the children's skeletons.  E says how much of a field from
/// outside a cluster gives back; nothing is inverted that may be singular by itself.
/// [doc/theory/compression.md]
///
/// On several processes each eliminates its subtrees, and everybody what is above them; right
/// sides and solutions are whole everywhere.  What computes is collective, and throws
/// everywhere if it does anywhere.
///
/// Refers to the operators, which must outlive it.  A copy shares what is eliminated, until
/// one of the two is updated.
class CompressedFactor {
 public:
  /// `changing`: leaves in which updates may differ, where memory is to be saved.
  /// \throws NumericalError where a leaf or F is singular.
  /// \throws std::logic_error for a follower or an entry between two leaves.
  CompressedFactor(const CompressedOperators& operators, Restriction restriction,
                   const std::vector<int>& changing);
  CompressedFactor(const CompressedOperators& operators, Restriction restriction);

  /// The same for right sides and unknowns of these leaves alone, of which those may change
  /// that might before: everything outside their lowest common cluster is eliminated once, in
  /// what it answers to that cluster.
  /// \throws std::logic_error where none of them may change: of such clusters too little is
  /// kept.
  CompressedFactor within(const std::vector<int>& leaves) const;

  /// The same with another restriction: only leaves where it differs and what is above
  /// them are eliminated anew.  Returns how many clusters that were.
  /// \throws std::logic_error where a leaf may not change, and nothing has happened, or for what
  /// connects two leaves.
  /// \throws NumericalError as above; then there is no solution before another update.
  int update(Restriction restriction);

  /// X of Z X = B on what is not held; held unknowns are zero, or follow.  With
  /// `refinements` corrections by the product of what is left of the densities' equations;
  /// the elimination alone leaves more there as elements get many.
  /// \throws std::logic_error of within().
  Matrix solve(const Matrix& b, int refinements = 1) const;

  /// The same, unrefined, of a right side that is zero in other leaves than those of
  /// `paths`, and only of the unknowns there; others mean nothing.
  Matrix solveAlong(const std::vector<char>& paths, const Matrix& b) const;
  /// By cluster: these leaves, what is above them, and what each solution needs.
  std::vector<char> paths(std::vector<int> leaves) const;

  const Restriction& restriction() const { return restriction_; }

 private:
  /// By cluster: the same, but nothing that is above the top.
  std::vector<char> withoutAbove(std::vector<char> clusters) const;
  void eliminate(const std::vector<char>& dirty);
  void exchangeResponses(const std::vector<char>& dirty, const std::string& failure);
  EliminatedCluster eliminated(int c, LeafRestriction restriction) const;
  /// By cluster, empty where nothing is to be done here: what of the restriction belongs to
  /// leaves.
  std::vector<LeafRestriction> restricted(std::vector<char> dirty) const;
  /// Takes springs back and adds exact rotations.
  void addBorder();
  /// What the unknowns of a cluster do to each other, P of a parent and D of a leaf, where
  /// the outside answers O to what leaves it: with Tᵀ O T.
  Matrix inside(int c, const Matrix* outside) const;
  /// O of a child, from P of its parent.
  Matrix outsideOf(int child, const Matrix& p) const;

  /// Of what the tree holds alone, springs included.
  Matrix solveSprung(const Matrix& b, const std::vector<char>& paths) const;
  Matrix solveOnce(const Matrix& b, const std::vector<char>& paths) const;
  /// B less Z X in the densities' equations, zero elsewhere.  \pre no entries are added there.
  Matrix leftOfDensities(const Matrix& b, const Matrix& x) const;

  const EliminatedCluster& node(int c) const { return *nodes_[c]; }
  const Matrix& response(int c) const { return *responses_[c]; }

  const CompressedOperators* operators_;
  Restriction restriction_;
  std::vector<char> changing_;  ///< by cluster
  /// By cluster: an update that threw may have left it as it was before.
  std::vector<char> unfinished_;
  int top_ = 0;  ///< the highest cluster that solutions go through
  std::shared_ptr<const Matrix>
      whole_;  ///< inside() of it, where it is mine and not the root
  std::vector<std::shared_ptr<const EliminatedCluster>> nodes_;
  std::vector<std::shared_ptr<const Matrix>> responses_;  ///< E, where still needed
  /// Of springs on CompressedOperators::floating that is not held, and of rotations; null without
  /// any.
  std::shared_ptr<const Woodbury> border_;
};

}  // namespace epafi::bem
