#include "bem/algebra/LowRank.hpp"

#include "bem/algebra/Products.hpp"

namespace epafi::bem {

LowRank::LowRank(Matrix columns, const Matrix& kappa)
    : u(std::move(columns)), inverse(u.columns(), u.columns()) {
  const Index rank = kappa.rows();
  for (Index k = 0; k < rank; ++k) {
    inverse(k, rank + k) = inverse(rank + k, k) = -1;
    for (Index l = 0; l < rank; ++l)
      inverse(rank + l, rank + k) = -kappa(l, k);
  }
}

void LowRank::addTo(Matrix& y, const Matrix& x) const {
  const Index rank = u.columns() / 2;
  const Matrix seen = transposedProduct(u, x);
  Matrix sizes(u.columns(), x.columns());
  for (Index j = 0; j < x.columns(); ++j)
    for (Index k = 0; k < rank; ++k) {
      sizes(k, j) = -seen(rank + k, j);
      sizes(rank + k, j) = -seen(k, j);
      for (Index l = 0; l < rank; ++l)
        sizes(k, j) -= inverse(rank + k, rank + l) * seen(l, j);
    }
  addProduct(1, u, sizes, y);
}

Woodbury::Woodbury(Matrix u, Matrix inverse, Matrix answers, const char* name)
    : u_(std::move(u)), answers_(std::move(answers)) {
  addTransposedProduct(1, u_, answers_, inverse);
  rest_ = LuFactor::ofScaledRows(std::move(inverse), name);
}

void Woodbury::correct(Matrix& x) const {
  Matrix sizes = transposedProduct(u_, x);
  rest_.solve(sizes);
  addProduct(-1, answers_, sizes, x);
}

}  // namespace epafi::bem
