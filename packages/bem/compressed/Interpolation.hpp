#pragma once

#include "bem/base/Matrix.hpp"

#include <algorithm>
#include <cassert>
#include <vector>

namespace epafi::bem {

/// Column interpolation of a matrix:  A ≈ A_S T,  T the identity on the columns of the skeleton
/// S and weights on the rest.
struct Interpolation {
  std::vector<Index> skeleton;  ///< S: column numbers; -1: a column that is left out
  std::vector<Index> rest;      ///< all other columns, ascending
  Matrix weights;               ///< skeleton x rest

  Index rows() const { return static_cast<Index>(skeleton.size()); }
  /// \pre no column is left out, as for the members below but times()
  Index columns() const {
    assert(std::find(skeleton.begin(), skeleton.end(), -1) == skeleton.end());
    return static_cast<Index>(skeleton.size() + rest.size());
  }

  /// T X
  Matrix times(const Matrix& x) const;
  /// Y += Tᵀ X
  void addTransposed(const Matrix& x, Matrix& y) const;
  /// T and Tᵀ as full matrices.
  Matrix full() const;
  Matrix transposed() const;

  /// T on some of the columns, ascending, and in the rows that do not vanish there.
  /// \param rows output: these rows
  Interpolation on(const std::vector<Index>& columns, std::vector<Index>& rows) const;
};

/// Column interpolation by pivoted QR.
/// \param threshold absolute bound for the distance of each column to the span of the skeleton
Interpolation interpolateColumns(Matrix a, double threshold);

/// Data of a cluster in a compressed system.
struct ClusterPart {
  std::vector<Index> active;  ///< a leaf's unknowns, or the skeletons of the children
  std::vector<Index> skeleton;
  Interpolation weights;  ///< T: skeleton x active; empty for the root
  /// Entries of a leaf, or S of a parent: first child's skeleton x second child's skeleton.
  Matrix block;

  /// Estimated work [ns] of the products of a sweep with this many columns, see Parallel.hpp.
  double sweepWork(Index columns) const;
};

}  // namespace epafi::bem
