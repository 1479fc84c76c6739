#include "contact/newton/KeptFactor.hpp"

#include "bem/algebra/SmallAlgebra.hpp"

#include <algorithm>
#include <map>

namespace epafi::contact {

namespace {

/// Largest fraction of differing rows; beyond, a new factor costs less.
constexpr double mostChanges = 0.15;

}  // namespace

/// The equation of one coefficient in a System.
struct KeptFactor::Row {
  bool isSolved = false;
  Index leader = 0;
  double factor = 0;  ///< 0: no leader
  bool operator==(const Row& o) const {
    return isSolved == o.isSolved && leader == o.leader && factor == o.factor;
  }
};

std::vector<KeptFactor::Row> KeptFactor::rowsOf(const System& system, Index size) {
  std::vector<Row> rows(at(size));
  for (const Index i : system.rows)
    rows[at(i)].isSolved = true;
  for (const auto& [follower, leader, factor] : system.followers)
    rows[at(follower)] = {false, leader, factor};
  return rows;
}

/// The system that was factored.
class KeptFactor::Base {
 public:
  Base(const Flexibility& flexibility, const System& system, std::vector<Row> rows)
      : flexibility_(flexibility),
        motions_(system.motions.copy()),
        stiffness_(system.stiffness.copy()),
        rows_(std::move(rows)),
        most_(mostChanges * static_cast<double>(system.rows.size())),
        added_(system.added),
        factor_(flexibility.factor({system.rows, system.followers, motions_.copy(),
                                    system.added, stiffness_.copy()})) {}

  bool isOf(const Flexibility& flexibility, const System& system) const {
    const auto same = [](const bem::Entry& a, const bem::Entry& b) {
      return a.row == b.row && a.column == b.column && a.value == b.value;
    };
    const auto alike = [](const Matrix& a, const Matrix& b) {
      bool same = a.rows() == b.rows() && a.columns() == b.columns();
      for (Index j = 0; same && j < a.columns(); ++j)
        same = std::equal(a.column(j), a.column(j) + a.rows(), b.column(j));
      return same;
    };
    return &flexibility.entries() == &flexibility_.entries() &&
           std::equal(system.added.begin(), system.added.end(), added_.begin(),
                      added_.end(), same) &&
           alike(system.motions, motions_) && alike(system.stiffness, stiffness_);
  }
  const Flexibility& flexibility() const { return flexibility_; }
  const Matrix& motions() const { return motions_; }
  const std::vector<bem::Entry>& added() const { return added_; }

  std::vector<Index> changed(const std::vector<Row>& rows) const {
    std::vector<Index> result;
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (!(rows[i] == rows_[i]))
        result.push_back(static_cast<Index>(i));
    return result;
  }
  bool isNear(const std::vector<Index>& changed) const {
    return static_cast<double>(changed.size()) <= most_;
  }

  Matrix solve(Matrix b) const { return factor_->solve(std::move(b)); }

  /// Y for some rows.
  Matrix responses(const std::vector<Index>& rows) {
    std::vector<Index> unknown;
    for (const Index i : rows)
      if (responses_.count(i) == 0)
        unknown.push_back(i);
    Matrix units(flexibility_.size() + motions_.columns(),
                 static_cast<Index>(unknown.size()));
    for (std::size_t c = 0; c < unknown.size(); ++c)
      units(unknown[c], static_cast<Index>(c)) = 1;
    units = solve(std::move(units));
    for (std::size_t c = 0; c < unknown.size(); ++c)
      responses_[unknown[c]] = columnOf(units, static_cast<Index>(c));
    Matrix all(units.rows(), static_cast<Index>(rows.size()));
    for (std::size_t c = 0; c < rows.size(); ++c) {
      const Vector& response = responses_[rows[c]];
      std::copy(response.begin(), response.end(), all.column(static_cast<Index>(c)));
    }
    return all;
  }

 private:
  Flexibility flexibility_;  ///< keeps D alive
  Matrix motions_;
  Matrix stiffness_;
  std::vector<Row> rows_;
  double most_;
  std::vector<bem::Entry> added_;
  std::unique_ptr<const Factor> factor_;
  std::map<Index, Vector> responses_;
};

std::unique_ptr<const Flexibility::Operator::Factor> KeptFactor::make(
    const Flexibility& flexibility, const System& system, FactorMemory& memory) {
  const std::vector<Row> rows = rowsOf(system, flexibility.size());
  std::shared_ptr<Base>& base = memory.base_;
  if (base != nullptr && base->isOf(flexibility, system))
    if (const std::vector<Index> changed = base->changed(rows); base->isNear(changed)) {
      std::unique_ptr<const KeptFactor> factor(new KeptFactor(base, rows, changed));
      if (factor->factor_.isRegular())
        return factor;
    }
  base.reset();
  base = std::make_shared<Base>(flexibility, system, rows);
  return std::unique_ptr<const Factor>(new KeptFactor(base, rows, {}));
}

KeptFactor::KeptFactor(const std::shared_ptr<Base>& base, const std::vector<Row>& rows,
                       const std::vector<Index>& changed)
    : base_(base), changed_(changed), responses_(base->responses(changed)) {
  const Matrix& entries = base->flexibility().entries();
  const Index size = entries.columns();
  rows_ = Matrix(responses_.rows(), responses_.columns());
  for (std::size_t c = 0; c < changed.size(); ++c) {
    const Index i = changed[c];
    const Row& now = rows[at(i)];
    double* row = rows_.column(static_cast<Index>(c));
    rowScale_.push_back(now.isSolved && entries(i, i) > 0 ? 1 / entries(i, i) : 1);
    if (now.isSolved) {
      std::transform(entries.column(i), entries.column(i) + size, row,
                     [&](double entry) { return rowScale_[c] * entry; });
      for (Index k = 0; k < base->motions().columns(); ++k)
        row[size + k] = -rowScale_[c] * base->motions()(i, k);
      for (const bem::Entry& entry : base->added())
        if (entry.row == i)
          row[entry.column] += rowScale_[c] * entry.value;
    } else {
      row[i] = 1;
      row[now.leader] -= now.factor;
    }
  }
  factor_ = bem::LuFactor(bem::transposedTimes(rows_, responses_));
}

Matrix KeptFactor::solve(Matrix b) const {
  Matrix rest(static_cast<Index>(changed_.size()), b.columns());
  for (Index c = 0; c < b.columns(); ++c)
    for (Index k = 0; k < rest.rows(); ++k)
      rest(k, c) = rowScale_[at(k)] * b(changed_[at(k)], c);
  b = base_->solve(std::move(b));
  const Matrix now = bem::transposedTimes(rows_, b);
  for (Index c = 0; c < b.columns(); ++c)
    for (Index k = 0; k < rest.rows(); ++k)
      rest(k, c) -= now(k, c);
  factor_.solve(rest);
  const Matrix change = multiply(responses_, rest);
  for (Index c = 0; c < b.columns(); ++c)
    for (Index i = 0; i < b.rows(); ++i)
      b(i, c) += change(i, c);
  return b;
}

}  // namespace epafi::contact
