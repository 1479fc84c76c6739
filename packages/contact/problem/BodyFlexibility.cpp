#include "contact/problem/BodyFlexibility.hpp"

#include "bem/algebra/FrontalFactor.hpp"
#include "contact/problem/Surface.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace epafi::contact {

/// A system in x of the rows, scaled so that D has a unit diagonal, and in β, as a sum over bodies.
class BodyFlexibility::Reduced final : public Factor {
 public:
  Reduced(const BodyFlexibility& whole, System system)
      : whole_(whole),
        system_(std::move(system)),
        unknowns_(at(whole.size()), {-1, 0}),
        scales_(whole.diagonal_) {
    addTo(scales_);
    for (double& scale : scales_)
      scale = scale > 0 ? 1 / std::sqrt(scale) : 1;
    for (std::size_t p = 0; p < system_.rows.size(); ++p)
      unknowns_[at(system_.rows[p])] = {static_cast<Index>(p), 1};
    for (const auto& [follower, leader, factor] : system_.followers)
      unknowns_[at(follower)] = {unknowns_[at(leader)].number, factor};
    factorise();
  }

  Matrix solve(Matrix b) const override {
    Vector x(at(count() + motions()));
    for (Index c = 0; c < b.columns(); ++c) {
      double* to = b.column(c);
      reduce(to, x);
      factor_->solve(x.data());
      for (Index p = 0; p < count(); ++p) {
        const Index i = system_.rows[at(p)];
        to[i] = scales_[at(i)] * x[at(p)];
      }
      for (const auto& [follower, leader, factor] : system_.followers)
        to[follower] += factor * to[leader];
      std::copy_n(x.data() + count(), motions(), to + whole_.size());
    }
    return b;
  }

 private:
  Index count() const { return static_cast<Index>(system_.rows.size()); }
  Index motions() const { return system_.motions.columns(); }

  void factorise() try {
    factor_ =
        std::make_unique<const bem::FrontalFactor>(count() + motions(), makeParts());
  } catch (const bem::NumericalError& error) {
    throw SingularJacobian(
        bem::message("singular Newton matrix: nothing balances rigid motions, or ",
                     system_.followers.empty()
                         ? "two multiplier coefficients act on the same displacement"
                         : "at this friction coefficient the solution may not be unique",
                     " (", error.what(), ")"));
  }
  bool isRow(Index i) const {
    return unknowns_[at(i)].number >= 0 && system_.rows[at(unknowns_[at(i)].number)] == i;
  }
  void addTo(Vector& diagonal) const {
    for (const auto& [row, column, value] : system_.added)
      if (row == column)
        diagonal[at(row)] += value;
  }

  /// Entries by unknowns.
  class Sum {
   public:
    Index placeOf(Index unknown) {
      const auto [place, isNew] =
          places.emplace(unknown, static_cast<Index>(unknowns.size()));
      if (isNew)
        unknowns.push_back(unknown);
      return place->second;
    }
    void add(Index row, Index column, double value) {
      const Index p = placeOf(row);
      further.push_back({p, placeOf(column), value});
    }
    /// With the entries of D so far.
    bem::FrontalFactor::Part part() && {
      Matrix all(static_cast<Index>(unknowns.size()),
                 static_cast<Index>(unknowns.size()));
      for (Index j = 0; j < entries.columns(); ++j)
        std::copy_n(entries.column(j), entries.rows(), all.column(j));
      for (const bem::Entry& entry : further)
        all(entry.row, entry.column) += entry.value;
      return {std::move(unknowns), std::move(all)};
    }

    std::unordered_map<Index, Index> places;
    std::vector<Index> unknowns;
    Matrix entries;
    std::vector<bem::Entry> further;
  };

  /// What a body adds: D in rows and the columns of leaders with what follows them.
  Sum ofBody(const BodyFlexibility::Part& body) const {
    Sum sum;
    std::vector<Index> places(body.columns.size());
    for (std::size_t k = 0; k < places.size(); ++k)
      places[k] = unknowns_[at(body.columns[k])].number >= 0
                      ? sum.placeOf(unknowns_[at(body.columns[k])].number)
                      : -1;
    const auto n = static_cast<Index>(sum.unknowns.size());
    sum.entries = Matrix(n, n);
    for (std::size_t q = 0; q < places.size(); ++q) {
      if (places[q] < 0)
        continue;
      const Unknown& column = unknowns_[at(body.columns[q])];
      const double factor = column.factor * scaleOf(column.number);
      for (std::size_t p = 0; p < places.size(); ++p)
        if (const Index i = body.columns[p]; isRow(i))
          sum.entries(places[p], places[q]) +=
              factor * scales_[at(i)] *
              body.entries(static_cast<Index>(p), static_cast<Index>(q));
    }
    return sum;
  }

  std::vector<bem::FrontalFactor::Part> makeParts() const {
    std::vector<Sum> sums;
    for (const BodyFlexibility::Part& body : whole_.parts_)
      sums.push_back(ofBody(body));
    for (const auto& [row, column, value] : system_.added)
      if (isRow(row) && isRow(column))
        sums[whole_.owners_[at(row)]].add(unknowns_[at(row)].number,
                                          unknowns_[at(column)].number,
                                          scales_[at(row)] * scales_[at(column)] * value);
    for (Index k = 0; k < motions(); ++k)
      for (Index i = 0; i < whole_.size(); ++i)
        if (const double g = system_.motions(i, k);
            g != 0 && unknowns_[at(i)].number >= 0) {
          Sum& sum = sums[whole_.owners_[at(i)]];
          const Unknown& unknown = unknowns_[at(i)];
          if (isRow(i))
            sum.add(unknown.number, count() + k, -scales_[at(i)] * g);
          sum.add(count() + k, unknown.number,
                  unknown.factor * scaleOf(unknown.number) * g);
        }
    Sum springs;
    for (Index k = 0; k < system_.stiffness.rows(); ++k)
      for (Index l = 0; l < system_.stiffness.columns(); ++l)
        if (system_.stiffness(k, l) != 0)
          springs.add(count() + k, count() + l, system_.stiffness(k, l));
    std::vector<bem::FrontalFactor::Part> parts;
    for (Sum& sum : sums)
      parts.push_back(std::move(sum).part());
    parts.push_back(std::move(springs).part());
    return parts;
  }

  double scaleOf(Index unknown) const { return scales_[at(system_.rows[at(unknown)])]; }

  /// Right-hand sides minus the terms of known coefficients.
  void reduce(const double* from, Vector& to) const {
    Vector known(from, from + whole_.size());
    for (const Index i : system_.rows)
      known[at(i)] = 0;
    Vector image = whole_.times(known);
    addTimes(1, system_.added, known, image);
    for (Index p = 0; p < count(); ++p) {
      const Index i = system_.rows[at(p)];
      to[at(p)] = scales_[at(i)] * (from[i] - image[at(i)]);
    }
    for (Index k = 0; k < motions(); ++k) {
      double sum = from[whole_.size() + k];
      for (Index i = 0; i < whole_.size(); ++i)
        sum -= system_.motions(i, k) * known[at(i)];
      to[at(count() + k)] = sum;
    }
  }

  struct Unknown {
    Index number;   ///< of a row, or of the leader's; -1: none
    double factor;  ///< of that
  };

  const BodyFlexibility& whole_;
  System system_;
  std::vector<Unknown> unknowns_;  ///< by coefficient
  Vector scales_;
  std::unique_ptr<const bem::FrontalFactor> factor_;
};

BodyFlexibility::BodyFlexibility(Index size, std::vector<Part> parts)
    : size_(size), parts_(std::move(parts)), diagonal_(at(size)), owners_(at(size)) {
  for (std::size_t b = parts_.size(); b-- > 0;)
    for (std::size_t k = 0; k < parts_[b].columns.size(); ++k) {
      const Index i = parts_[b].columns[k];
      diagonal_[at(i)] += parts_[b].entries(static_cast<Index>(k), static_cast<Index>(k));
      owners_[at(i)] = b;
    }
}

bool BodyFlexibility::isSparse(Index size,
                               const std::vector<std::vector<Index>>& columns) {
  constexpr double least = 4;  // fewer entries by this factor
  double entries = 0;
  for (const std::vector<Index>& part : columns)
    entries += static_cast<double>(part.size() * part.size());
  return least * entries < static_cast<double>(size) * static_cast<double>(size);
}

Flexibility::Operator::Product BodyFlexibility::product(const Vector& x) const {
  Product sum{Vector(x.size()), Vector(x.size())};
  for (const Part& part : parts_)
    for (std::size_t q = 0; q < part.columns.size(); ++q) {
      const double factor = x[at(part.columns[q])];
      const double* column = part.entries.column(static_cast<Index>(q));
      for (std::size_t p = 0; factor != 0 && p < part.columns.size(); ++p) {
        const double term = column[p] * factor;
        sum.value[at(part.columns[p])] += term;
        sum.magnitude[at(part.columns[p])] += std::abs(term);
      }
    }
  return sum;
}

Vector BodyFlexibility::times(const Vector& x) const { return product(x).value; }

Matrix BodyFlexibility::formed() const {
  Matrix result(size_, size_);
  for (const Part& part : parts_)
    for (std::size_t q = 0; q < part.columns.size(); ++q)
      for (std::size_t p = 0; p < part.columns.size(); ++p)
        result(part.columns[p], part.columns[q]) +=
            part.entries(static_cast<Index>(p), static_cast<Index>(q));
  return result;
}

std::unique_ptr<Flexibility::Operator::Factor> BodyFlexibility::factor(
    System system) const {
  return std::make_unique<Reduced>(*this, std::move(system));
}

}  // namespace epafi::contact
