#pragma once

#include "bem/algebra/LuFactor.hpp"
#include "bem/compressed/Interpolation.hpp"

namespace epafi::bem {

/// Restriction of one leaf, by positions in its list of unknowns.
struct LeafRestriction {
  std::vector<Index> kept;       ///< not held
  std::vector<Entry> followers;  ///< columns: positions in `kept`
  std::vector<Entry> added;      ///< rows and columns: positions in `kept`
};

/// Name in error messages.
inline constexpr char compressedSystem[] = "the compressed system";

/// A cluster of a compressed system after its elimination, see CompressedFactor.
class EliminatedCluster {
 public:
  /// A leaf; d: the entries of all its unknowns.
  EliminatedCluster(const ClusterPart& part, LeafRestriction restriction,
                    const Matrix& d);
  /// A parent; first, second: the responses E₁, E₂ of its children.
  EliminatedCluster(const ClusterPart& part, const Matrix& first, const Matrix& second);
  /// The highest cluster, F = I + diag(E₁, E₂) P, p: all entries between the unknowns of the
  /// children's skeletons.
  EliminatedCluster(const Matrix& first, const Matrix& second, const Matrix& p);
  /// A cluster whose unknowns are all held: its response is zero.
  static EliminatedCluster silent() { return EliminatedCluster(true); }
  /// A cluster of another process.
  static EliminatedCluster elsewhere() { return EliminatedCluster(false); }
  bool isSilent() const { return isSilent_; }

  /// E.  \pre not the highest cluster
  Matrix response(const ClusterPart& part) const;

  /// X <- D⁻¹ X or F⁻¹ X
  void solve(Matrix& x) const;
  /// Subtracts from X the solution for the field z from outside.
  void subtractOutside(const Matrix& z, Matrix& x) const;

  /// T X, the sources of the far field of the cluster.
  Matrix outgoing(const ClusterPart& part, const Matrix& x) const;

  /// Of a leaf: rows of kept unknowns; and X of all unknowns, with held ones zero or followers.
  Matrix reduced(const Matrix& x) const;
  Matrix expanded(const Matrix& x) const;

 private:
  explicit EliminatedCluster(bool isSilent) : isSilent_(isSilent) {}

  LeafRestriction leaf_;
  bool isLeaf_ = false;
  bool isSilent_ = false;
  Index unknowns_ = 0;  ///< number of all unknowns of a leaf
  /// Of D; of a parent below the top of I - E₂ Sᵀ E₁ S, the Schur complement of F.
  LuFactor lu_;
  Matrix upper_;  ///< E₁ S, of a parent below the top
  Matrix lower_;  ///< E₂ Sᵀ
  Matrix in_;     ///< D⁻¹ Tᵀ, or F⁻¹ diag(E) Tᵀ
};

}  // namespace epafi::bem
