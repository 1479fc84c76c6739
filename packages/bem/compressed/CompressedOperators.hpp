#pragma once

#include "bem/algebra/LowRank.hpp"
#include "bem/base/Material.hpp"
#include "bem/compressed/ClusterTree.hpp"
#include "bem/compressed/Interpolation.hpp"
#include "bem/compressed/Skeletons.hpp"
#include "bem/compressed/Subtrees.hpp"
#include "bem/operators/LocalFunctions.hpp"

#include <memory>
#include <vector>

namespace epafi::bem {

/// The coupled system of the boundary operators,
///
///   Z = [ W        (K+1/2)ᵀ ]
///       [ K+1/2    -V       ],
///
/// of one or several bodies, with what a LocalCoupling adds, by recursive skeletonisation: what a cluster of elements
/// does to everything else goes through some of its unknowns, its skeleton,
///
///   Z_far,cluster ≈ Z_far,skeleton T,
///
/// and the skeletons of two children are the unknowns of their parent.  Memory and time
/// grow with the number of elements times the rank, which grows with its logarithm.  Of
/// several bodies a cluster has what face each other; each one's part has a skeleton of its
/// own.  Displacements of bodies with arcs hold the rotation exactly, see Rotation.
///
/// On several processes each has some subtrees, and everybody what is above them; vectors are
/// whole everywhere, and what is made of them is collective.
///                                                       [doc/theory/compression.md]
class CompressedOperators {
 public:
  struct Body {
    const Space& space;
    const Lame& lame;
  };
  explicit CompressedOperators(const std::vector<Body>& bodies,
                               const Compression& options = {},
                               const LocalCoupling& local = {},
                               const Processes& processes = oneProcess());
  CompressedOperators(const Space& space, const Lame& lame,
                      const Compression& options = {}, const LocalCoupling& local = {},
                      const Processes& processes = oneProcess())
      : CompressedOperators(std::vector<Body>{{space, lame}}, options, local, processes) {
  }

  /// The numbers of a body's unknowns: displacements, then densities.
  struct Range {
    Index first;
    Index densities;
    Index last;
    double young;  ///< its modulus, in what stresses are counted
  };
  const Range& range(std::size_t body) const { return ranges_[body]; }
  std::size_t bodies() const { return ranges_.size(); }
  /// Where further unknowns begin.
  Index further() const { return ranges_.back().last; }
  /// All unknowns.
  Index size() const { return static_cast<Index>(leaves_.size()); }

  /// Z X
  Matrix times(const Matrix& x) const;

  /// Of the first body; clusters of all have its numbers, parents and children.
  const ClusterTree& tree() const { return trees_.front(); }
  const Subtrees& subtrees() const { return *subtrees_; }
  /// Of other processes' clusters the lists of unknowns alone.
  const ClusterPart& part(int cluster) const { return parts_[cluster]; }
  /// How many unknowns a cluster's skeleton has.
  Index skeletonOf(int cluster) const {
    return static_cast<Index>(part(cluster).skeleton.size());
  }
  /// Replaces the rows of X in other processes' leaves of `paths` by theirs.  Collective.
  void exchangeRows(const std::vector<char>& paths, double check, Matrix& x) const {
    subtrees_->exchangeRows(tree(), parts_, paths, check, x);
  }
  /// The leaf of an unknown.
  int leafOf(Index unknown) const { return leaves_[unknown]; }

  /// Three displacements of the outer loop that no rigid motion leaves at rest, where there
  /// are holes: a factor springs them, since a cluster that is a whole loop may float.
  const std::vector<Index>& floating() const { return floating_; }

  /// What exact rotations add to what the tree holds: of each body with arcs r_I goes through its
  /// Rotation's q; Z r_I of further unknowns is less what they do to the rest of the rotation.
  const LowRank& rotations() const { return rotations_; }

  std::size_t bytes() const;

 private:
  void addRotations(const std::vector<Body>& bodies, const LocalCoupling& local);

  std::vector<Range> ranges_;
  std::vector<int> leaves_;  ///< of the unknowns
  std::vector<ClusterTree> trees_;
  std::unique_ptr<const Subtrees> subtrees_;
  std::vector<ClusterPart> parts_;
  std::vector<Index> floating_;
  LowRank rotations_;
};

}  // namespace epafi::bem
