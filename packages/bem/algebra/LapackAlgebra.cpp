#include "bem/algebra/LapackAlgebra.hpp"

#include "bem/algebra/Blas.hpp"
#include "bem/base/Error.hpp"

namespace epafi::bem {

namespace {

int asInt(Index n) { return static_cast<int>(n); }

class LapackFactor final : public CholeskyFactor {
 public:
  explicit LapackFactor(Matrix factor) : factor_(std::move(factor)) {}

  Vector solve(const Vector& b) const override {
    Vector x = b;
    const int n = asInt(factor_.rows());
    const int ld = asInt(factor_.stride());
    const int one = 1;
    int info = 0;
    dpotrs_("L", &n, &one, factor_.data(), &ld, x.data(), &n, &info);
    return x;
  }

  Matrix forward(Matrix b) const override {
    const int n = asInt(factor_.rows());
    const int m = asInt(b.columns());
    const int ld = asInt(factor_.stride());
    const int ldb = asInt(b.stride());
    const double one = 1;
    if (n > 0 && m > 0)
      dtrsm_("L", "L", "N", "N", &n, &m, &one, factor_.data(), &ld, b.data(), &ldb);
    return b;
  }

  Vector backward(const Vector& b) const override {
    Vector x = b;
    const int n = asInt(factor_.rows());
    const int ld = asInt(factor_.stride());
    const int columns = 1;
    const double one = 1;
    if (n > 0)
      dtrsm_("L", "L", "T", "N", &n, &columns, &one, factor_.data(), &ld, x.data(), &n);
    return x;
  }

 private:
  Matrix factor_;
};

}  // namespace

std::unique_ptr<CholeskyFactor> LapackAlgebra::cholesky(Matrix lower,
                                                        const char* name) const {
  const int n = asInt(lower.rows());
  const int ld = asInt(lower.stride());
  int info = 0;
  if (n > 0)
    dpotrf_("L", &n, lower.data(), &ld, &info);
  if (info != 0)
    throw NumericalError(message(name,
                                 " is not positive definite: Cholesky's factorisation ",
                                 "breaks down in row ", info, " of ", n));
  return std::make_unique<LapackFactor>(std::move(lower));
}

Matrix LapackAlgebra::addGram(Matrix c, const Matrix& y) const {
  const int n = asInt(c.rows());
  const int k = asInt(y.rows());
  const int ldy = asInt(y.stride());
  const int ldc = asInt(c.stride());
  const double one = 1;
  if (n > 0 && k > 0)
    dsyrk_("L", "T", &n, &k, &one, y.data(), &ldy, &one, c.data(), &ldc);
  return c;
}

Matrix LapackAlgebra::addOuter(Matrix c, const Matrix& x, double scale) const {
  const int n = asInt(c.rows());
  const int k = asInt(x.columns());
  const int ldx = asInt(x.stride());
  const int ldc = asInt(c.stride());
  const double one = 1;
  if (n > 0 && k > 0)
    dsyrk_("L", "N", &n, &k, &scale, x.data(), &ldx, &one, c.data(), &ldc);
  return c;
}

Matrix LapackAlgebra::transposeTimes(const Matrix& x, const Matrix& y) const {
  return addTransposeTimes(Matrix(x.columns(), y.columns()), x, y);
}

Matrix LapackAlgebra::addTransposeTimes(Matrix c, const Matrix& x,
                                        const Matrix& y) const {
  const int m = asInt(x.columns());
  const int n = asInt(y.columns());
  const int k = asInt(x.rows());
  const int ldx = asInt(x.stride());
  const int ldy = asInt(y.stride());
  const int ldc = asInt(c.stride());
  const double one = 1;
  if (m > 0 && n > 0 && k > 0)
    dgemm_("T", "N", &m, &n, &k, &one, x.data(), &ldx, y.data(), &ldy, &one, c.data(),
           &ldc);
  return c;
}

Vector LapackAlgebra::multiply(const Matrix& a, Index n, const Vector& x) const {
  Vector y(static_cast<std::size_t>(n));
  const int rows = asInt(a.rows());
  const int columns = asInt(a.columns());
  const int ld = asInt(a.stride());
  const int step = 1;
  const double one = 1;
  const double zero = 0;
  if (rows > 0 && columns > 0)
    dgemv_("N", &rows, &columns, &one, a.data(), &ld, x.data(), &step, &zero, y.data(),
           &step);
  return y;
}

Vector LapackAlgebra::multiplySymmetric(const Matrix& lower, const Vector& x) const {
  Vector y(x.size());
  const int n = asInt(lower.rows());
  const int ld = asInt(lower.stride());
  const int step = 1;
  const double one = 1;
  const double zero = 0;
  if (n > 0)
    dsymv_("L", &n, &one, lower.data(), &ld, x.data(), &step, &zero, y.data(), &step);
  return y;
}

Matrix LapackAlgebra::replicate(Matrix rows, Index) const { return rows; }

}  // namespace epafi::bem
