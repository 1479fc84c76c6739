#include "bem/compressed/Products.hpp"

namespace epafi::bem {

void addProduct(double s, const Matrix& a, const Matrix& b, Matrix& c,
                const char* transposed) {
  const int m = static_cast<int>(c.rows());
  const int n = static_cast<int>(c.columns());
  const int k = static_cast<int>(b.rows());
  if (m == 0 || n == 0 || k == 0)
    return;
  const int lda = static_cast<int>(a.stride());
  const int ldb = static_cast<int>(b.stride());
  const int ldc = static_cast<int>(c.stride());
  const double one = 1;
  if (n == 1) {
    const int rows = static_cast<int>(a.rows());
    const int columns = static_cast<int>(a.columns());
    const int next = 1;
    dgemv_(transposed, &rows, &columns, &s, a.data(), &lda, b.data(), &next, &one,
           c.data(), &next);
    return;
  }
  byColumns(n, [&](Index first, Index count) {
    const int columns = static_cast<int>(count);
    dgemm_(transposed, "N", &m, &columns, &k, &s, a.data(), &lda, b.column(first), &ldb,
           &one, c.column(first), &ldc);
  });
}

}  // namespace epafi::bem
