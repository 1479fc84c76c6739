// What bodies with dense S make of D.
#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/body/DenseBody.hpp"
#include "contact/problem/BodyFlexibility.hpp"

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

/// The upper triangle from the lower one.
void mirror(Matrix& d) {
  for (Index j = 0; j < d.columns(); ++j)
    for (Index i = j + 1; i < d.rows(); ++i)
      d(j, i) = d(i, j);
}

Vector entriesAt(const std::vector<Index>& places, const Vector& all) {
  Vector result;
  for (const Index i : places)
    result.push_back(all[at(i)]);
  return result;
}

}  // namespace

std::vector<Index> DenseBody::columns() const {
  const Vector& rests = coupling_.trace.rests;
  std::vector<char> acts(rests.size());
  for (const auto* entries :
       {&coupling_.trace.entries, &coupling_.weights, &coupling_.mass})
    for (const bem::Entry& entry : *entries)
      acts[at(entry.column)] = 1;
  std::vector<Index> result;
  for (std::size_t i = 0; i < acts.size(); ++i)
    if (acts[i] != 0 || rests[i] != 0)
      result.push_back(static_cast<Index>(i));
  return result;
}

Matrix DenseBody::transposedCoupling(const std::vector<Index>& places,
                                     Index count) const {
  Matrix result(space_.displacements(), count);
  TraceCoupling trace{{}, coupling_.trace.rotation, Vector(at(count))};
  for (const auto& [row, column, value] : coupling_.trace.entries)
    trace.entries.push_back({row, places[at(column)], value});
  for (std::size_t i = 0; i < places.size(); ++i)
    if (places[i] >= 0)
      trace.rests[at(places[i])] = coupling_.trace.rests[i];
  trace.addTo(result);
  for (const bem::Entry& entry : coupling_.weights) {
    const double* traction = columns_->column(entry.row);
    double* column = result.column(places[at(entry.column)]);
    for (Index j = 0; j < result.rows(); ++j)
      column[j] -= entry.value * traction[j];
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
  const std::vector<Index> columns = this->columns();
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

Flexibility denseFlexibility(const std::vector<std::shared_ptr<const DenseBody>>& bodies,
                             const std::vector<std::vector<Vector>>& motions,
                             const std::vector<std::vector<Vector>>& reactions) {
  std::vector<BodyFlexibility::Part> parts;
  for (const auto& body : bodies)
    parts.push_back({body->columns(), {}});
  const auto size = static_cast<Index>(bodies.front()->coupling().trace.rests.size());
  const bool isSparse = BodyFlexibility::isSparse(size, parts);
  Matrix whole(isSparse ? 0 : size, isSparse ? 0 : size);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    auto& [columns, entries] = parts[b];
    const auto count = static_cast<Index>(columns.size());
    entries = Matrix(count, count);
    const auto exchange = [&](const auto& action) {
      for (Index j = 0; j < count && !isSparse; ++j)
        for (Index i = j; i < count; ++i)
          action(entries(i, j), whole(columns[at(i)], columns[at(j)]));
    };
    exchange([](double& own, double so) { own = so; });
    entries = bodies[b]->addCompliance(std::move(entries), motions[b], reactions[b]);
    exchange([](double own, double& sum) { sum = own; });
    if (isSparse)
      mirror(entries);
    else
      entries = {};
  }
  mirror(whole);
  if (isSparse)
    return Flexibility(std::make_shared<const BodyFlexibility>(size, std::move(parts)));
  return whole;
}

}  // namespace epafi::contact
