#include "contact/problem/Flexibility.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace epafi::contact {

namespace {

class Dense final : public Flexibility::Operator {
 public:
  explicit Dense(Matrix entries) : entries_(std::move(entries)) {
    assert(entries_.rows() == entries_.columns());
  }

  Index size() const override { return entries_.rows(); }

  Product product(const Vector& x) const override {
    Product sum{Vector(x.size(), 0.0), Vector(x.size(), 0.0)};
    double* value = sum.value.data();
    double* magnitude = sum.magnitude.data();
    overColumns(x, [&](const double* column, double factor) {
#pragma omp simd
      for (std::size_t i = 0; i < x.size(); ++i) {
        const double term = column[i] * factor;
        value[i] += term;
        magnitude[i] += std::abs(term);
      }
    });
    return sum;
  }

  Vector times(const Vector& x) const override {
    Vector sum(x.size(), 0.0);
    double* value = sum.data();
    overColumns(x, [&](const double* column, double factor) {
#pragma omp simd
      for (std::size_t i = 0; i < x.size(); ++i)
        value[i] += column[i] * factor;
    });
    return sum;
  }

  const Matrix* entries() const override { return &entries_; }
  Matrix formed() const override { return entries_.copy(); }

 private:
  template <class Add>
  void overColumns(const Vector& x, const Add& add) const {
    assert(static_cast<Index>(x.size()) == size());
    for (std::size_t j = 0; j < x.size(); ++j)
      if (x[j] != 0)
        add(entries_.column(static_cast<Index>(j)), x[j]);
  }

  Matrix entries_;
};

}  // namespace

Flexibility::Flexibility(Matrix entries)
    : Flexibility(std::make_shared<const Dense>(std::move(entries))) {}

Flexibility::Flexibility(std::shared_ptr<const Operator> form)
    : operator_(std::move(form)), entries_(operator_->entries()) {}

const Vector& Flexibility::responses(Index normals) const {
  const std::lock_guard lock(found_->mutex);
  Vector& responses = found_->responses[normals];
  if (!responses.empty())
    return responses;
  Vector found;  // a product may break down
  for (const bool normal : {true, false}) {
    Vector kind(at(size()), normal ? 0.0 : 1.0);
    std::fill_n(kind.begin(), normals, normal ? 1.0 : 0.0);
    const Vector all = product(kind).magnitude;
    found.insert(found.end(), normal ? all.begin() : all.begin() + normals,
                 normal ? all.begin() + normals : all.end());
  }
  return responses = std::move(found);
}

}  // namespace epafi::contact
