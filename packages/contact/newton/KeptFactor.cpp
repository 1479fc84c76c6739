#include "contact/newton/KeptFactor.hpp"

#include "bem/algebra/SmallAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace epafi::contact {

namespace {

/// Rows that may differ, as a part of those that are solved for: beyond, a new factor costs
/// less.
constexpr double mostChanges = 0.15;
/// Below this reciprocal condition others shall judge.
constexpr double nearlySingular = 1e-13;

}  // namespace

/// The system that was factored.
class KeptFactor::Base {
 public:
  Base(Flexibility flexibility, const Matrix& motions, std::vector<Row> rows)
      : shared_(std::move(flexibility)),
        flexibility_(shared_.entries()),
        motions_(motions.copy()),
        rows_(std::move(rows)) {
    for (Index i = 0; i < size(); ++i)
      if (rows_[at(i)].isSolved)
        solved_.push_back(i);
    for (const Index i : solved_)
      scale_.push_back(flexibility_(i, i) > 0 ? 1 / std::sqrt(flexibility_(i, i)) : 1);
    factor_ = bem::LuFactor(matrix());
  }

  bool isSound() const { return factor_.reciprocalCondition() > nearlySingular; }
  bool isOf(const Flexibility& flexibility, const Matrix& motions) const {
    return &flexibility.entries() == &flexibility_ &&
           motions.columns() == motions_.columns() &&
           std::equal(motions.data(),
                      motions.data() + motions.stride() * motions.columns(),
                      motions_.data());
  }
  const Matrix& flexibility() const { return flexibility_; }
  const Matrix& motions() const { return motions_; }

  std::vector<Index> changed(const std::vector<Row>& rows) const {
    std::vector<Index> result;
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (!(rows[i] == rows_[i]))
        result.push_back(static_cast<Index>(i));
    return result;
  }
  bool isNear(const std::vector<Index>& changed) const {
    return static_cast<double>(changed.size()) <=
           mostChanges * static_cast<double>(solved_.size());
  }

  /// Columns: b on entry.
  Matrix solve(Matrix b) const {
    const Index m = solvedCount();
    Matrix x(m + motions_.columns(), b.columns());
    for (Index c = 0; c < b.columns(); ++c)
      reduce(b.column(c), x.column(c));
    factor_.solve(x);
    for (Index c = 0; c < b.columns(); ++c) {
      double* to = b.column(c);
      for (Index p = 0; p < m; ++p)
        to[solved_[at(p)]] = scale_[at(p)] * x(p, c);
      for (Index i = 0; i < size(); ++i)
        for (const Row::Share& share : rows_[at(i)].followed)
          to[i] += share.factor * to[share.leader];
      std::copy_n(x.column(c) + m, motions_.columns(), to + size());
    }
    return b;
  }

  /// Y for some rows.
  Matrix responses(const std::vector<Index>& rows) {
    std::vector<Index> unknown;
    for (const Index i : rows)
      if (responses_.count(i) == 0)
        unknown.push_back(i);
    Matrix units(size() + motions_.columns(), static_cast<Index>(unknown.size()));
    for (std::size_t c = 0; c < unknown.size(); ++c)
      units(unknown[c], static_cast<Index>(c)) = 1;
    units = solve(std::move(units));
    for (std::size_t c = 0; c < unknown.size(); ++c)
      responses_[unknown[c]] = bem::columnOf(units, static_cast<Index>(c));
    Matrix all(size() + motions_.columns(), static_cast<Index>(rows.size()));
    for (std::size_t c = 0; c < rows.size(); ++c) {
      const Vector& response = responses_[rows[c]];
      std::copy(response.begin(), response.end(), all.column(static_cast<Index>(c)));
    }
    return all;
  }

 private:
  /// A right side without what is known, scaled.
  void reduce(const double* from, double* to) const {
    const Index m = solvedCount();
    for (Index p = 0; p < m; ++p)
      to[p] = from[solved_[at(p)]];
    std::copy_n(from + size(), motions_.columns(), to + m);
    for (Index j = 0; j < size(); ++j) {
      if (rows_[at(j)].isSolved || from[j] == 0)
        continue;
      const double* column = flexibility_.column(j);
      for (Index p = 0; p < m; ++p)
        to[p] -= column[solved_[at(p)]] * from[j];
      for (Index k = 0; k < motions_.columns(); ++k)
        to[m + k] -= motions_(j, k) * from[j];
    }
    for (Index p = 0; p < m; ++p)
      to[p] *= scale_[at(p)];
  }

  Index size() const { return flexibility_.columns(); }
  Index solvedCount() const { return static_cast<Index>(solved_.size()); }

  /// What the coefficients that are solved for and the motions satisfy once the others follow.
  Matrix matrix() const {
    const Index m = solvedCount();
    const Index k = motions_.columns();
    Matrix a(m + k, m + k);
    std::vector<Index> position(at(size()), -1);
    for (Index q = 0; q < m; ++q) {
      position[at(solved_[at(q)])] = q;
      add(solved_[at(q)], 1, q, a);
      for (Index j = 0; j < k; ++j)
        a(q, m + j) = -scale_[at(q)] * motions_(solved_[at(q)], j);
    }
    for (Index i = 0; i < size(); ++i)
      for (const Row::Share& share : rows_[at(i)].followed)
        add(i, share.factor, position[at(share.leader)], a);
    return a;
  }

  /// A coefficient's column times a factor, to that of the one at a place.
  void add(Index i, double factor, Index q, Matrix& a) const {
    const Index m = solvedCount();
    const double* column = flexibility_.column(i);
    const double scaled = scale_[at(q)] * factor;
    for (Index p = 0; p < m; ++p)
      a(p, q) += scale_[at(p)] * scaled * column[solved_[at(p)]];
    for (Index j = 0; j < motions_.columns(); ++j)
      a(m + j, q) += scaled * motions_(i, j);
  }

  Flexibility shared_;  ///< keeps D alive
  const Matrix& flexibility_;
  Matrix motions_;
  std::vector<Row> rows_;
  std::vector<Index> solved_;
  Vector scale_;
  bem::LuFactor factor_;
  std::map<Index, Vector> responses_;
};

std::unique_ptr<const KeptFactor> KeptFactor::make(const Flexibility& flexibility,
                                                   const Matrix& motions,
                                                   const std::vector<Row>& rows,
                                                   FactorMemory& memory) {
  std::shared_ptr<Base>& base = memory.base_;
  if (base != nullptr && !base->isOf(flexibility, motions))
    base.reset();
  std::vector<Index> changed;
  if (base != nullptr)
    changed = base->changed(rows);
  if (base == nullptr || !base->isNear(changed)) {
    changed.clear();
    base = std::make_shared<Base>(flexibility, motions, rows);
    if (!base->isSound()) {
      base.reset();
      return nullptr;
    }
  }
  std::unique_ptr<KeptFactor> factor(new KeptFactor(base, rows, changed));
  if (factor->factor_.isRegular())
    return factor;
  base.reset();
  return nullptr;
}

KeptFactor::KeptFactor(const std::shared_ptr<Base>& base, const std::vector<Row>& rows,
                       const std::vector<Index>& changed)
    : base_(base), changed_(changed), responses_(base->responses(changed)) {
  const Matrix& flexibility = base->flexibility();
  const Index size = flexibility.columns();
  rows_ = Matrix(responses_.rows(), responses_.columns());
  for (std::size_t c = 0; c < changed.size(); ++c) {
    const Index i = changed[c];
    double* row = rows_.column(static_cast<Index>(c));
    const double diagonal = flexibility(i, i);
    rowScale_.push_back(rows[at(i)].isSolved && diagonal > 0 ? 1 / diagonal : 1);
    if (rows[at(i)].isSolved) {
      std::transform(flexibility.column(i), flexibility.column(i) + size, row,
                     [&](double entry) { return rowScale_[c] * entry; });
      for (Index k = 0; k < base->motions().columns(); ++k)
        row[size + k] = -rowScale_[c] * base->motions()(i, k);
    } else {
      row[i] = 1;
      for (const Row::Share& share : rows[at(i)].followed)
        row[share.leader] -= share.factor;
    }
  }
  factor_ = bem::LuFactor(bem::transposedTimes(rows_, responses_));
}

Vector KeptFactor::solve(const Vector& b) const {
  Matrix z = base_->solve(bem::asColumn(b));
  if (!changed_.empty()) {
    Matrix rest = bem::transposedTimes(rows_, z);
    for (std::size_t c = 0; c < changed_.size(); ++c) {
      double& value = rest(static_cast<Index>(c), 0);
      value = rowScale_[c] * b[at(changed_[c])] - value;
    }
    factor_.solve(rest);
    for (Index c = 0; c < responses_.columns(); ++c)
      for (Index i = 0; i < z.rows(); ++i)
        z(i, 0) += rest(c, 0) * responses_(i, c);
  }
  return bem::columnOf(z, 0);
}

}  // namespace epafi::contact
