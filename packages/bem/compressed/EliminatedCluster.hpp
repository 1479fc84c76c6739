#pragma once

#include "bem/algebra/LuFactor.hpp"
#include "bem/compressed/Interpolation.hpp"

namespace epafi::bem {

/// What is asked of a leaf's unknowns, by their places in it.
struct LeafRestriction {
  std::vector<Index> kept;       ///< not held
  std::vector<Entry> followers;  ///< of those at places among the kept, the columns
  std::vector<Entry> added;      ///< among the kept
};

/// In messages.
inline constexpr char compressedSystem[] = "the compressed system";

/// A cluster of a compressed system after its elimination, see CompressedFactor.
class EliminatedCluster {
 public:
  /// A leaf with the entries D of all its unknowns.
  EliminatedCluster(const ClusterPart& part, LeafRestriction restriction,
                    const Matrix& d);
  /// A parent with its children's responses.
  EliminatedCluster(const ClusterPart& part, const Matrix& first, const Matrix& second);
  /// The same where nothing is above, and P is what each skeleton's unknown does to each:
  /// F = I + diag(E₁, E₂) P.
  EliminatedCluster(const Matrix& first, const Matrix& second, const Matrix& p);
  /// All of it is held: a response, zero, and nothing else.
  static EliminatedCluster silent() { return EliminatedCluster(true); }
  /// Another process has it.
  static EliminatedCluster elsewhere() { return EliminatedCluster(false); }
  bool isSilent() const { return isSilent_; }

  /// E, of all but the highest.
  Matrix response(const ClusterPart& part) const;

  /// X <- D⁻¹ X or F⁻¹ X
  void solve(Matrix& x) const;
  /// X less what a field from outside, z, makes.
  void subtractOutside(const Matrix& z, Matrix& x) const;

  /// T X, what leaves the cluster.
  Matrix outgoing(const ClusterPart& part, const Matrix& x) const;

  /// Of a leaf: rows of what is kept, and X of all unknowns, zero where they are held.
  Matrix reduced(const Matrix& x) const;
  Matrix expanded(const Matrix& x) const;

 private:
  explicit EliminatedCluster(bool isSilent) : isSilent_(isSilent) {}

  LeafRestriction leaf_;
  bool isLeaf_ = false;
  bool isSilent_ = false;
  Index unknowns_ = 0;  ///< of a leaf, all of them
  /// Of D; of a parent, where the identity blocks of F come first, of I - E₂ Sᵀ E₁ S.
  LuFactor lu_;
  Matrix upper_;  ///< E₁ S, of a parent with another above it
  Matrix lower_;  ///< E₂ Sᵀ
  Matrix in_;     ///< D⁻¹ Tᵀ, or F⁻¹ diag(E) Tᵀ
};

}  // namespace epafi::bem
