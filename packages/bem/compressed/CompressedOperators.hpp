#pragma once

#include "bem/algebra/LowRank.hpp"
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
/// of one or several bodies, plus the entries of a LocalCoupling, by recursive
/// skeletonisation: some unknowns of a cluster, its skeleton, represent its far field,
///
///   Z_far,cluster ≈ Z_far,skeleton T,
///
/// and the skeletons of two children are the unknowns of their parent.  Memory and time are
/// proportional to the number N of elements times the rank, which grows like log N.  A cluster
/// contains elements of several bodies that face each other, and one skeleton for each body.
/// Displacements of bodies with arcs represent rotations exactly, see Rotation.
///
/// Each process stores its subtrees, all store the clusters above them.  Vectors are
/// replicated; functions that compute them are collective.
///                                                       [doc/theory/compression.md]
class CompressedOperators {
 public:
  struct Body {
    const Space& space;
    std::shared_ptr<const Kernel> kernel;

    Body(const Space& of, std::shared_ptr<const Kernel> kernelOfIt)
        : space(of), kernel(std::move(kernelOfIt)) {}
    Body(const Space& of, const Lame& lame)
        : Body(of, elasticKernel(of.mesh().outline(), lame)) {}
  };
  explicit CompressedOperators(const std::vector<Body>& bodies,
                               const Compression& options = {},
                               const LocalCoupling& local = {},
                               const Processes& processes = oneProcess());
  CompressedOperators(const Space& space, const Lame& lame,
                      const Compression& options = {}, const LocalCoupling& local = {},
                      const Processes& processes = oneProcess())
      : CompressedOperators({Body(space, lame)}, options, local, processes) {}

  /// Global numbers of the unknowns of a body: displacements, then densities.
  struct Range {
    Index first;
    Index densities;
    Index last;
    double stiffness;  ///< Kernel::stiffness
  };
  const Range& range(std::size_t body) const { return ranges_[body]; }
  std::size_t bodies() const { return ranges_.size(); }
  /// Number of the first additional unknown of LocalCoupling.
  Index further() const { return ranges_.back().last; }
  /// The coupling that it was made with.
  const LocalCoupling& local() const { return local_; }
  /// Number of unknowns.
  Index size() const { return static_cast<Index>(leaves_.size()); }

  /// Z X
  Matrix times(const Matrix& x) const;

  /// Tree of the first body; the trees of all bodies have equal numbers, parents and children.
  const ClusterTree& tree() const { return trees_.front(); }
  const Subtrees& subtrees() const { return *subtrees_; }
  /// Clusters of other processes have lists of unknowns only.
  const ClusterPart& part(int cluster) const { return parts_[cluster]; }
  /// Number of unknowns in the skeleton of a cluster.
  Index skeletonOf(int cluster) const {
    return static_cast<Index>(part(cluster).skeleton.size());
  }
  /// Sets the rows of X in the leaves of `paths` to the values of their owners.  Collective.
  void exchangeRows(const std::vector<char>& paths, double check, Matrix& x) const {
    subtrees_->exchangeRows(tree(), parts_, paths, check, x);
  }
  /// The leaf of an unknown.
  int leafOf(Index unknown) const { return leaves_[unknown]; }

  /// With holes, the displacements Kernel::resting of the outer loop.
  /// CompressedFactor puts springs there, since a cluster that is a whole loop may float.
  const std::vector<Index>& springUnknowns() const { return springUnknowns_; }

  /// Low-rank correction of the compressed system for exact rotations: replaces Z r_I of each body
  /// with arcs, where q of Rotation gives the amplitude of r_I; with LocalCoupling::rotations.
  const LowRank& rotations() const { return rotations_; }

  std::size_t bytes() const;

 private:
  void takeTranslations(const std::vector<Body>& bodies);
  void addRotations(const std::vector<Body>& bodies);

  LocalCoupling local_;
  std::vector<Range> ranges_;
  std::vector<int> leaves_;  ///< by unknown
  std::vector<ClusterTree> trees_;
  std::unique_ptr<const Subtrees> subtrees_;
  std::vector<ClusterPart> parts_;
  std::vector<Index> springUnknowns_;
  LowRank rotations_;
};

}  // namespace epafi::bem
