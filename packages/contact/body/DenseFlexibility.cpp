// What bodies with dense S make of D.
#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/body/DenseBody.hpp"

#include <map>
#include <utility>

namespace epafi::contact {

namespace {

/// D - v wᵀ - w vᵀ
void subtractProducts(const Vector& v, const Vector& w, Matrix& d) {
  for (Index j = 0; j < d.columns(); ++j)
    for (Index i = 0; i < d.rows(); ++i)
      d(i, j) -= v[at(i)] * w[at(j)] + w[at(i)] * v[at(j)];
}

}  // namespace

Matrix DenseBody::transposedCoupling() const {
  Matrix result(space_.displacements(), static_cast<Index>(coupling_.trace.rests.size()));
  coupling_.trace.addTo(result);
  for (const bem::Entry& entry : coupling_.weights) {
    const double* traction = columns_->column(entry.row);
    double* column = result.column(entry.column);
    for (Index j = 0; j < result.rows(); ++j)
      column[j] -= entry.value * traction[j];
  }
  return result;
}

// M - Gᵀ X G, G by the columns that are not zero
void DenseBody::addMultiplierMass(Matrix& d) const {
  for (const bem::Entry& entry : coupling_.mass)
    d(entry.row, entry.column) += entry.value;
  if (response_ == nullptr)
    return;
  const Matrix& x = response_->density;
  std::map<Index, Vector> half;
  for (const bem::Entry& entry : coupling_.weights) {
    Vector& column = half[entry.column];
    column.resize(at(x.rows()));
    for (Index i = 0; i < x.rows(); ++i)
      column[at(i)] += entry.value * x(i, entry.row);
  }
  for (const auto& [j, column] : half)
    for (const bem::Entry& entry : coupling_.weights)
      d(entry.column, j) -= entry.value * column[at(entry.row)];
}

Matrix DenseBody::addCompliance(Matrix d, const std::vector<Vector>& motions,
                                const std::vector<Vector>& reactions) const {
  const Matrix forwarded = forward(transposedCoupling());
  if (d.empty())  // not before, beside what forward() needs
    d = Matrix(forwarded.columns(), forwarded.columns());
  addMultiplierMass(d);
  for (std::size_t k = 0; k < motions.size(); ++k) {
    Vector w = bem::times(0.5, motions[k]);
    if (k < reactions.size())
      bem::axpy(1, reactions[k], w);
    subtractProducts(motions[k], w, d);
  }
  return addGram(std::move(d), forwarded);
}

Flexibility denseFlexibility(const std::vector<std::shared_ptr<const DenseBody>>& bodies,
                             const std::vector<std::vector<Vector>>& motions,
                             const std::vector<std::vector<Vector>>& reactions) {
  Matrix d;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    d = bodies[b]->addCompliance(std::move(d), motions[b], reactions[b]);
  for (Index j = 0; j < d.columns(); ++j)
    for (Index i = j + 1; i < d.rows(); ++i)
      d(j, i) = d(i, j);
  return d;
}

}  // namespace epafi::contact
