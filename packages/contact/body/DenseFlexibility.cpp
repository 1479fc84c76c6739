// What a body with dense S makes of D.
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

Matrix DenseBody::transposedCoupling(const std::vector<Index>& places,
                                     Index count) const {
  Matrix result(space_.displacements(), count);
  TraceCoupling trace{{}, coupling_.trace.rotation, Vector(at(count))};
  for (const auto& [row, column, value] : coupling_.trace.entries)
    if (places[at(column)] >= 0)
      trace.entries.push_back({row, places[at(column)], value});
  for (std::size_t i = 0; i < places.size(); ++i)
    if (places[i] >= 0)
      trace.rests[at(places[i])] = coupling_.trace.rests[i];
  trace.addTo(result);
  for (const bem::Entry& entry : coupling_.weights) {
    const double* traction = columns_->column(entry.row);
    const Index place = places[at(entry.column)];
    for (Index j = 0; place >= 0 && j < result.rows(); ++j)
      result(j, place) -= entry.value * traction[j];
  }
  return result;
}

// M - Gᵀ X G, G by the columns that are not zero
void DenseBody::addMultiplierMass(const std::vector<Index>& places, Matrix& d) const {
  for (const bem::Entry& entry : coupling_.mass)
    d(places[at(entry.row)], places[at(entry.column)]) += entry.value;
  if (response_ == nullptr)
    return;
  const Matrix& x = response_->density;
  std::map<Index, Vector> half;
  for (const bem::Entry& entry : coupling_.weights) {
    Vector& column = half[places[at(entry.column)]];
    column.resize(at(x.rows()));
    for (Index i = 0; i < x.rows(); ++i)
      column[at(i)] += entry.value * x(i, entry.row);
  }
  for (const auto& [j, column] : half)
    for (const bem::Entry& entry : coupling_.weights)
      d(places[at(entry.column)], j) -= entry.value * column[at(entry.row)];
}

Matrix DenseBody::addCompliance(Matrix d, const std::vector<Vector>& motions,
                                const std::vector<Vector>& reactions) const {
  const std::vector<Index> columns = coupling_.columns();
  std::vector<Index> places(coupling_.trace.rests.size(), -1);
  for (std::size_t k = 0; k < columns.size(); ++k)
    places[at(columns[k])] = static_cast<Index>(k);
  const auto count = static_cast<Index>(columns.size());
  const Matrix forwarded = forward(transposedCoupling(places, count));
  addMultiplierMass(places, d);
  for (std::size_t k = 0; k < motions.size(); ++k) {
    Vector w = bem::times(0.5, motions[k]);
    if (k < reactions.size())
      bem::axpy(1, reactions[k], w);
    subtractProducts(entriesAt(columns, motions[k]), entriesAt(columns, w), d);
  }
  return addGram(std::move(d), forwarded);
}

}  // namespace epafi::contact
