#pragma once

#include "bem/base/Matrix.hpp"

#include <vector>

namespace epafi::bem {

/// All columns of a matrix by some of them:  A ≈ A_S T,  T the identity on the skeleton S and
/// weights on the rest.
struct Interpolation {
  std::vector<Index> skeleton;  ///< S: places among the columns
  std::vector<Index> rest;      ///< all others, in ascending order
  Matrix weights;               ///< skeleton x rest

  Index rows() const { return static_cast<Index>(skeleton.size()); }
  Index columns() const { return static_cast<Index>(skeleton.size() + rest.size()); }

  /// T X
  Matrix times(const Matrix& x) const;
  /// Y += Tᵀ X
  void addTransposed(const Matrix& x, Matrix& y) const;
  /// T and Tᵀ themselves.
  Matrix full() const;
  Matrix transposed() const;
};

/// By pivoted QR: what is left of each column outside the span of the skeleton is smaller
/// than the threshold, an absolute one.
Interpolation interpolateColumns(Matrix a, double threshold);

/// What a compressed system keeps of a cluster.
struct ClusterPart {
  std::vector<Index> active;  ///< a leaf's unknowns, or the skeletons of the children
  std::vector<Index> skeleton;
  Interpolation weights;  ///< T, of the active by the skeleton; of all but the root
  /// A leaf's entries, or those of one child's skeleton with the other's.
  Matrix block;

  /// Of the products that a sweep makes with so many columns at once [ns], see Parallel.hpp.
  double sweepWork(Index columns) const;
};

}  // namespace epafi::bem
