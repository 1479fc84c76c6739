#include "Algebra.hpp"
#include "bem/algebra/LapackAlgebra.hpp"

const epafi::bem::DenseAlgebra& epafi::test::algebra() {
  static const bem::LapackAlgebra lapack;
  return lapack;
}
