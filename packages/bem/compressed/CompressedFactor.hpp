#pragma once

#include "bem/compressed/CompressedOperators.hpp"

#include <memory>
#include <vector>

namespace epafi::bem {

/// What is asked of a solution of the compressed system besides its equations.
struct Restriction {
  /// By unknown: is it zero, and its equation not asked for?
  std::vector<char> held;

  /// A held unknown that is a multiple of another one of its leaf instead of zero.
  struct Follower {
    Index unknown;
    Index leader;
    double factor;
    bool operator==(const Follower& o) const {
      return unknown == o.unknown && leader == o.leader && factor == o.factor;
    }
  };
  std::vector<Follower> followers;

  /// Added to diagonal entries: springs.
  struct Spring {
    Index unknown;
    double stiffness;
    bool operator==(const Spring& o) const {
      return unknown == o.unknown && stiffness == o.stiffness;
    }
  };
  std::vector<Spring> springs;
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
/// Refers to the operators, which must outlive it.
class CompressedFactor {
 public:
  /// \throws NumericalError where a leaf or F is singular.
  CompressedFactor(const CompressedOperators& operators, Restriction restriction);

  /// The same with another restriction: only leaves where it differs and what is above
  /// them are eliminated anew.  Returns how many clusters that were.
  int update(Restriction restriction);

  /// X of Z X = B on what is not held; held unknowns are zero, or follow.  With
  /// `refinements` corrections by the product; the elimination alone loses digits as
  /// elements get many.
  Matrix solve(const Matrix& b, int refinements = 2) const;

  const CompressedOperators& operators() const { return *operators_; }
  const Restriction& restriction() const { return restriction_; }
  std::size_t bytes() const;

 private:
  struct Node {
    std::vector<Index> kept;  ///< of a leaf: places among its unknowns
    Matrix lu;
    std::vector<int> pivots;
    Matrix in;        ///< D⁻¹ Tᵀ, or F⁻¹ diag(E) Tᵀ
    Matrix response;  ///< E
    /// Followers of a leaf, by places.
    struct Follower {
      Index follower;
      Index leader;  ///< among the kept
      double factor;
    };
    std::vector<Follower> followers;
    Matrix out;  ///< of a leaf: T of its solution, followers included
  };

  void eliminate(const std::vector<char>& dirty);
  void eliminateLeaf(int c);
  void eliminateParent(int c);
  void factor(int c, Matrix matrix);
  Matrix solveOnce(const Matrix& b) const;
  void solveWith(const Node& node, Matrix& x) const;
  /// B less Z X on what is asked for, zero elsewhere.
  Matrix residual(const Matrix& b, const Matrix& x) const;

  const CompressedOperators* operators_;
  Restriction restriction_;
  std::vector<Node> nodes_;
};

}  // namespace epafi::bem
