#pragma once

#include "Largest.hpp"
#include "bem/tpetra/TpetraAlgebra.hpp"

#include <Tpetra_Core.hpp>

#include <algorithm>
#include <cmath>

namespace epafi::test {

inline bem::TpetraAlgebra allRanks() {
  return bem::TpetraAlgebra(Tpetra::getDefaultComm());
}

/// This rank's rows of a matrix that all ranks have.
inline bem::Matrix mine(const bem::DenseAlgebra& algebra, const bem::Matrix& whole) {
  const bem::Rows rows = algebra.myRows(whole.rows());
  bem::Matrix part(rows.size(), whole.columns());
  for (bem::Index j = 0; j < whole.columns(); ++j)
    std::copy_n(whole.column(j) + rows.begin, rows.size(), part.column(j));
  return part;
}

/// Largest difference between this rank's rows and those of the whole, relative to the
/// whole's largest entry.
inline double difference(const bem::DenseAlgebra& algebra, const bem::Matrix& rows,
                         const bem::Matrix& whole) {
  const bem::Index begin = algebra.myRows(whole.rows()).begin;
  double worst = 0;
  for (bem::Index j = 0; j < whole.columns(); ++j)
    for (bem::Index i = 0; i < rows.rows(); ++i)
      worst = std::max(worst, std::abs(rows(i, j) - whole(begin + i, j)));
  return worst / std::max(largest(whole), 1e-300);
}

/// The same for the lower triangle of a symmetric matrix.
inline double differenceBelow(const bem::DenseAlgebra& algebra, const bem::Matrix& rows,
                              const bem::Matrix& whole) {
  const bem::Index begin = algebra.myRows(whole.rows()).begin;
  double worst = 0;
  double size = 1e-300;
  for (bem::Index j = 0; j < whole.columns(); ++j) {
    for (bem::Index i = j; i < whole.rows(); ++i)
      size = std::max(size, std::abs(whole(i, j)));
    for (bem::Index i = std::max<bem::Index>(0, j - begin); i < rows.rows(); ++i)
      worst = std::max(worst, std::abs(rows(i, j) - whole(begin + i, j)));
  }
  return worst / size;
}

inline double difference(const bem::Vector& a, const bem::Vector& b) {
  double worst = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst / std::max(largest(b), 1e-300);
}

}  // namespace epafi::test
