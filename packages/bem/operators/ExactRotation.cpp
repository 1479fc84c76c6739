#include "bem/operators/ExactRotation.hpp"

#include "bem/algebra/DenseAlgebra.hpp"
#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"

#include <algorithm>

namespace epafi::bem {

Operators withExactRotation(Operators operators, const Space& space) {
  operators.rotation = space.rotation();
  if (operators.rotation == nullptr)
    return operators;
  const Vector& r = operators.rotation->motion();
  const Vector& q = operators.rotation->functional();
  // Pᵀ W P = W - q wᵀ - w qᵀ + (r·w) q qᵀ,  w = W r_I
  Matrix& hypersingular = operators.hypersingular;
  const Vector w = multiplySymmetric(hypersingular, r);
  const double square = dot(r, w);
  for (Index j = 0; j < hypersingular.columns(); ++j)
    for (Index i = j; i < hypersingular.rows(); ++i)
      hypersingular(i, j) -=
          q[at(i)] * (w[at(j)] - square * q[at(j)]) + w[at(i)] * q[at(j)];
  Matrix& doubleLayer = operators.doubleLayer;
  const Vector k = product(doubleLayer, r);
  for (Index j = 0; j < doubleLayer.columns(); ++j)
    for (Index i = 0; i < doubleLayer.rows(); ++i)
      doubleLayer(i, j) -= k[at(i)] * q[at(j)];
  return operators;
}

Matrix withoutRotation(Matrix columns, const Rotation& rotation) {
  const Vector& r = rotation.motion();
  const Vector& q = rotation.functional();
  for (Index c = 0; c < columns.columns(); ++c) {
    double work = 0;
    for (Index i = 0; i < columns.rows(); ++i)
      work += columns(i, c) * r[at(i)];
    for (Index i = 0; i < columns.rows(); ++i)
      columns(i, c) -= q[at(i)] * work;
  }
  return columns;
}

}  // namespace epafi::bem
