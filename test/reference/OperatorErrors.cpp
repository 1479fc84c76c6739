#include "reference/OperatorErrors.hpp"

#include <algorithm>

namespace epafi::reference {

namespace {

double entryError(const bem::Matrix& matrix, const QuadMatrix& exact, bem::Index i,
                  bem::Index j) {
  return static_cast<double>(abs(matrix(i, j) - exact(i, j)) / exact.scale(i, j));
}

double lowerError(const bem::Matrix& matrix, const QuadMatrix& exact) {
  double largest = 0;
  for (bem::Index j = 0; j < exact.columns(); ++j)
    for (bem::Index i = j; i < exact.rows(); ++i)
      largest = std::max(largest, entryError(matrix, exact, i, j));
  return largest;
}

double fullError(const bem::Matrix& matrix, const QuadMatrix& exact) {
  double largest = 0;
  for (bem::Index j = 0; j < exact.columns(); ++j)
    for (bem::Index i = 0; i < exact.rows(); ++i)
      largest = std::max(largest, entryError(matrix, exact, i, j));
  return largest;
}

}  // namespace

OperatorErrors operatorErrors(const bem::Operators& operators,
                              const QuadOperators& exact) {
  return {lowerError(operators.singleLayer, exact.singleLayer),
          fullError(operators.doubleLayer, exact.doubleLayer),
          lowerError(operators.hypersingular, exact.hypersingular)};
}

}  // namespace epafi::reference
