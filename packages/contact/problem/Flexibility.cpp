#include "contact/problem/Flexibility.hpp"

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
    overColumns(x, [&](std::size_t i, double term) {
      sum.value[i] += term;
      sum.magnitude[i] += std::abs(term);
    });
    return sum;
  }

  Vector times(const Vector& x) const override {
    Vector sum(x.size(), 0.0);
    overColumns(x, [&](std::size_t i, double term) { sum[i] += term; });
    return sum;
  }

  const Matrix& entries() const override { return entries_; }

 private:
  template <class Add>
  void overColumns(const Vector& x, const Add& add) const {
    assert(static_cast<Index>(x.size()) == size());
    for (std::size_t j = 0; j < x.size(); ++j) {
      const double* column = entries_.column(static_cast<Index>(j));
      for (std::size_t i = 0; i < x.size() && x[j] != 0; ++i)
        add(i, column[i] * x[j]);
    }
  }

  Matrix entries_;
};

}  // namespace

Flexibility::Flexibility(Matrix entries)
    : Flexibility(std::make_shared<const Dense>(std::move(entries))) {}

Flexibility::Flexibility(std::shared_ptr<const Operator> form)
    : operator_(std::move(form)),
      entries_(operator_->isFormed() ? &operator_->entries() : nullptr) {}

}  // namespace epafi::contact
