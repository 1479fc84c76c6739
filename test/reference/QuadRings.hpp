#pragma once

#include "bem/base/Material.hpp"
#include "bem/mesh/Mesh.hpp"
#include "reference/QuadMoments.hpp"

#include <vector>

namespace epafi::reference {

/// A matrix in 33 digits.
class QuadBlock {
 public:
  QuadBlock(int rows, int columns)
      : columns_(columns), values_(static_cast<std::size_t>(rows * columns)) {}
  Quad& operator()(int i, int j) {
    return values_[static_cast<std::size_t>(i * columns_ + j)];
  }
  const Quad& operator()(int i, int j) const {
    return values_[static_cast<std::size_t>(i * columns_ + j)];
  }
  double frobenius() const;

 private:
  int columns_;
  std::vector<Quad> values_;
};

/// Blocks of V, K and W of two elements of a solid of revolution, of whole revolutions: rows of the
/// first, columns of the second; function i's component c has the number 2 i + c.
struct QuadRings {
  QuadBlock singleLayer;  ///< Legendre polynomials
  QuadBlock doubleLayer;  ///< Legendre polynomials by bubbles, φ_k with k > 1; else zero
  QuadBlock hypersingular;  ///< bubbles
};

/// By a double exponential rule in both directions, from the node or the diagonal where the
/// elements meet, with complete elliptic integrals by arithmetic-geometric means: slow, simple, and
/// nothing in common with the polynomials and the graded rules under test.
QuadRings quadRings(const bem::Mesh& mesh, int e, int f, const bem::Lame& lame,
                    double tolerance);

}  // namespace epafi::reference
