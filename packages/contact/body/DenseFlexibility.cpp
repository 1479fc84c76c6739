// What bodies with dense S make of D.
#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/body/DenseBody.hpp"

#include <utility>

namespace epafi::contact {

namespace {

constexpr Index none = -1;

/// D - v wᵀ - w vᵀ
void subtractProducts(const Vector& v, const Vector& w, Matrix& d) {
  for (Index j = 0; j < d.columns(); ++j)
    for (Index i = 0; i < d.rows(); ++i)
      d(i, j) -= v[at(i)] * w[at(j)] + w[at(i)] * v[at(j)];
}

Vector entriesAt(const std::vector<Index>& which, const Vector& of) {
  Vector result;
  for (const Index i : which)
    result.push_back(of[at(i)]);
  return result;
}

}  // namespace

std::vector<Index> DenseBody::actingCoefficients() const {
  const TraceCoupling& trace = coupling_.trace;
  std::vector<char> acts(trace.rests.size(), 0);
  for (const auto* entries : {&trace.entries, &coupling_.weights, &coupling_.mass})
    for (const bem::Entry& entry : *entries)
      acts[at(entry.column)] = 1;
  std::vector<Index> result;
  for (std::size_t i = 0; i < acts.size(); ++i)
    if (acts[i] != 0)
      result.push_back(static_cast<Index>(i));
  return result;
}

Matrix DenseBody::transposedCoupling(Index acting,
                                     const std::vector<Index>& places) const {
  Matrix result(space_.displacements(), acting);
  coupling_.trace.addTo(result, places);
  for (const bem::Entry& entry : coupling_.weights) {
    const double* traction = columns_->column(entry.row);
    double* column = result.column(places[at(entry.column)]);
    for (Index j = 0; j < result.rows(); ++j)
      column[j] -= entry.value * traction[j];
  }
  return result;
}

// M - Gᵀ X G, G by columns
void DenseBody::addMultiplierMass(const std::vector<Index>& places, Matrix& d) const {
  for (const bem::Entry& entry : coupling_.mass)
    d(places[at(entry.row)], places[at(entry.column)]) += entry.value;
  if (response_ == nullptr)
    return;
  const Matrix& x = response_->density;
  std::vector<Index> columns(places.size(), none);  // of G
  Index count = 0;
  for (const bem::Entry& entry : coupling_.weights)
    if (Index& column = columns[at(entry.column)]; column == none)
      column = count++;
  Matrix half(x.rows(), count);
  for (const bem::Entry& entry : coupling_.weights) {
    double* column = half.column(columns[at(entry.column)]);
    for (Index i = 0; i < x.rows(); ++i)
      column[i] += entry.value * x(i, entry.row);
  }
  for (std::size_t k = 0; k < columns.size(); ++k)
    for (const bem::Entry& entry : coupling_.weights)
      if (columns[k] != none)
        d(places[at(entry.column)], places[k]) -=
            entry.value * half(entry.row, columns[k]);
}

DenseBody::Compliance DenseBody::compliance(const std::vector<Vector>& motions,
                                            const std::vector<Vector>& reactions) const {
  Compliance own{actingCoefficients(), {}};
  const auto acting = static_cast<Index>(own.coefficients.size());
  std::vector<Index> places(coupling_.trace.rests.size(), none);
  for (Index k = 0; k < acting; ++k)
    places[at(own.coefficients[at(k)])] = k;
  const Matrix forwarded = forward(transposedCoupling(acting, places));
  own.block = Matrix(acting, acting);  // not before, beside what forward() needs
  addMultiplierMass(places, own.block);
  for (std::size_t k = 0; k < motions.size(); ++k) {
    Vector w = bem::times(0.5, motions[k]);
    if (k < reactions.size())
      bem::axpy(1, reactions[k], w);
    subtractProducts(entriesAt(own.coefficients, motions[k]),
                     entriesAt(own.coefficients, w), own.block);
  }
  own.block = addGram(std::move(own.block), forwarded);
  return own;
}

Flexibility denseFlexibility(const std::vector<std::shared_ptr<const DenseBody>>& bodies,
                             Index size, const std::vector<std::vector<Vector>>& motions,
                             const std::vector<std::vector<Vector>>& reactions) {
  Matrix d;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    auto [which, block] = bodies[b]->compliance(motions[b], reactions[b]);
    if (b == 0 && block.rows() == size) {
      d = std::move(block);
      continue;
    }
    if (b == 0)
      d = Matrix(size, size);
    for (Index j = 0; j < block.columns(); ++j)
      for (Index i = j; i < block.rows(); ++i)
        d(which[at(i)], which[at(j)]) += block(i, j);
  }
  for (Index j = 0; j < d.columns(); ++j)
    for (Index i = j + 1; i < d.rows(); ++i)
      d(j, i) = d(i, j);
  return d;
}

}  // namespace epafi::contact
