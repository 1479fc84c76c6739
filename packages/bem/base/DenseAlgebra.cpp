#include "bem/base/DenseAlgebra.hpp"

namespace epafi::bem {

Matrix DenseAlgebra::addTransposeTimes(Matrix c, const Matrix& x, const Matrix& y) const {
  const Matrix product = transposeTimes(x, y);
  for (Index j = 0; j < c.columns(); ++j)
    for (Index i = 0; i < c.rows(); ++i)
      c(i, j) += product(i, j);
  return c;
}

}  // namespace epafi::bem
