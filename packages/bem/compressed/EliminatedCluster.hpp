#pragma once

#include "bem/algebra/LuFactor.hpp"
#include "bem/compressed/Interpolation.hpp"

#include <memory>
#include <optional>

namespace epafi::bem {

/// Restriction of one leaf, by positions in its list of active unknowns.
struct LeafRestriction {
  std::vector<Index> kept;       ///< not held
  std::vector<Entry> followers;  ///< columns: positions in `kept`
  std::vector<Entry> added;      ///< rows and columns: positions in `kept`
};

/// Name in error messages.
inline constexpr char compressedSystem[] = "the compressed system";

/// The response E of a cluster to a field from outside.  It is stored for the rows and columns
/// in which T does not vanish on the unknowns that are not held: a body that is held as a
/// whole takes no space beside the others.
struct Response {
  std::vector<Index> places;  ///< of the skeleton, ascending
  Matrix matrix;

  Matrix full(Index skeleton) const;
  /// From the full matrix, without rows and columns that are zero.
  static Response of(const Matrix& full);
};

/// A cluster of a compressed system after its elimination, see CompressedFactor.  It keeps the
/// factor of D or of the Schur complement of F, and its children's responses; what these and S
/// make of a right-hand side is computed anew for each.
class EliminatedCluster {
 public:
  using Child = std::shared_ptr<const Response>;

  /// A leaf; d: the entries of all its unknowns.
  /// \param response  output: E; unless it is the highest cluster
  EliminatedCluster(const ClusterPart& part, LeafRestriction restriction, const Matrix& d,
                    Response& response);
  /// A parent; first, second: the responses E₁, E₂ of its children.
  EliminatedCluster(const ClusterPart& part, Child first, Child second,
                    Response& response);
  /// The highest cluster, F = I + diag(E₁, E₂) P, p: all entries between the unknowns of the
  /// children's skeletons.
  EliminatedCluster(const ClusterPart& part, const Response& first,
                    const Response& second, const Matrix& p);
  /// A cluster whose unknowns are all held: its response is zero.
  static EliminatedCluster silent() { return EliminatedCluster(true); }
  /// A cluster of another process.
  static EliminatedCluster elsewhere() { return EliminatedCluster(false); }
  bool isSilent() const { return isSilent_; }

  /// X <- D⁻¹ X or F⁻¹ X
  void solve(const ClusterPart& part, Matrix& x) const;
  /// The same with a field from outside, Tᵀ z of all active unknowns: D⁻¹ (X - Tᵀ z) or
  /// F⁻¹ (X - diag(E₁, E₂) Tᵀ z).  The field becomes that of both children, unless it is the
  /// highest cluster of a part.
  void solve(const ClusterPart& part, Matrix& field, Matrix& x) const;

  /// T X, the sources of the far field of the cluster.
  Matrix outgoing(const ClusterPart& part, const Matrix& x) const;

  /// Rows of kept unknowns; and X of all active unknowns, with held ones zero or followers.
  Matrix reduced(const Matrix& x) const;
  Matrix expanded(const Matrix& x) const;

 private:
  explicit EliminatedCluster(bool isSilent) : isSilent_(isSilent) {}

  EliminatedCluster(const ClusterPart& part, const Response& first,
                    const Response& second);
  const Matrix& block(const ClusterPart& part) const {
    return block_ ? *block_ : part.block;
  }

  LeafRestriction own_;  ///< of a parent: those where its children respond
  bool isSilent_ = false;
  Index unknowns_ = 0;  ///< number of all active unknowns
  /// Of D; of a parent below the top of I - E₂ Sᵀ E₁ S, the Schur complement of F.
  LuFactor lu_;
  Child first_;  ///< of a parent below the top
  Child second_;
  std::optional<Matrix> block_;  ///< S where these respond, if that is not all of it
};

}  // namespace epafi::bem
