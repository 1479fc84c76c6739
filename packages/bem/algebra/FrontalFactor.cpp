#include "bem/algebra/FrontalFactor.hpp"

#include "bem/algebra/Products.hpp"
#include "bem/base/Error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace epafi::bem {

namespace {

using Part = FrontalFactor::Part;

/// Parts in an order that keeps the front small: next is always the one after which it is smallest.
std::vector<std::size_t> ordered(Index size, const std::vector<Part>& parts) {
  std::vector<int> left(at(size));  // parts that an unknown waits for
  for (const Part& part : parts)
    for (const Index i : part.unknowns)
      ++left[at(i)];
  std::vector<char> isInFront(left.size());
  std::vector<std::size_t> order;
  std::vector<char> isDone(parts.size());
  while (order.size() < parts.size()) {
    std::size_t best = parts.size();
    Index least = std::numeric_limits<Index>::max();
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (isDone[k] != 0)
        continue;
      Index growth = 0;
      for (const Index i : parts[k].unknowns)
        growth += (isInFront[at(i)] == 0 ? 1 : 0) - (left[at(i)] == 1 ? 1 : 0);
      if (growth < least) {
        least = growth;
        best = k;
      }
    }
    isDone[best] = 1;
    order.push_back(best);
    for (const Index i : parts[best].unknowns)
      isInFront[at(i)] = --left[at(i)] > 0 ? 1 : 0;
  }
  return order;
}

}  // namespace

/// The unknowns that are not eliminated yet: equations (rows) and unknowns (columns), complete ones
/// first.
class FrontalFactor::Front {
 public:
  Front(Index size, const std::vector<Part>& parts) : left_(at(size)) {
    for (const Part& part : parts)
      for (const Index i : part.unknowns)
        ++left_[at(i)];
  }

  void add(const Part& part) {
    std::vector<Index> more;
    for (const Index i : part.unknowns)
      if (std::find(columns_.begin(), columns_.end(), i) == columns_.end())
        more.push_back(i);
    rows_.insert(rows_.end(), more.begin(), more.end());
    columns_.insert(columns_.end(), more.begin(), more.end());
    Matrix larger(size(), size());
    put(entries_, larger);
    entries_ = std::move(larger);
    const std::vector<Index> rows = placesOf(part.unknowns, rows_);
    const std::vector<Index> columns = placesOf(part.unknowns, columns_);
    for (std::size_t j = 0; j < columns.size(); ++j)
      for (std::size_t i = 0; i < rows.size(); ++i)
        entries_(rows[i], columns[j]) +=
            part.entries(static_cast<Index>(i), static_cast<Index>(j));
    for (const Index i : part.unknowns)
      --left_[at(i)];
  }

  /// Eliminates what is complete.
  Stage eliminate() {
    completeFirst();
    Index done = 0;
    while (done < complete_ && takePivot(done))
      ++done;
    Stage stage{rows_, columns_, columnsBetween(entries_, 0, done).copy(),
                rowsBetween(columnsBetween(entries_, done, size()), 0, done).copy()};
    // the panel has been updated with each pivot, what follows it has not
    for (Index j = complete_ - done; j < stage.upper.columns(); ++j)
      for (Index k = 0; k < done; ++k)
        for (Index i = k + 1; i < done; ++i)
          stage.upper(i, j) -= stage.lower(i, k) * stage.upper(k, j);
    addProduct(
        -1, rowsBetween(stage.lower, done, size()),
        columnsBetween(stage.upper, complete_ - done, stage.upper.columns()),
        MatrixView(entries_).columnsBetween(complete_, size()).rowsBetween(done, size()));
    entries_ = columnsBetween(rowsBetween(entries_, done, size()), done, size()).copy();
    rows_.erase(rows_.begin(), rows_.begin() + done);
    columns_.erase(columns_.begin(), columns_.begin() + done);
    return stage;
  }

  Index size() const { return static_cast<Index>(columns_.size()); }

 private:
  static void put(const Matrix& from, Matrix& to) {
    for (Index j = 0; j < from.columns(); ++j)
      std::copy_n(from.column(j), from.rows(), to.column(j));
  }
  std::vector<Index> placesOf(const std::vector<Index>& unknowns,
                              const std::vector<Index>& among) {
    places_.resize(left_.size());
    for (std::size_t k = 0; k < among.size(); ++k)
      places_[at(among[k])] = static_cast<Index>(k);
    std::vector<Index> result;
    for (const Index i : unknowns)
      result.push_back(places_[at(i)]);
    return result;
  }

  void completeFirst() {
    const auto isComplete = [&](Index i) { return left_[at(i)] == 0; };
    const auto order = [&](const std::vector<Index>& of) {
      std::vector<Index> places(of.size());
      for (std::size_t k = 0; k < places.size(); ++k)
        places[k] = static_cast<Index>(k);
      std::stable_partition(places.begin(), places.end(),
                            [&](Index k) { return isComplete(of[at(k)]); });
      return places;
    };
    const std::vector<Index> rows = order(rows_);
    const std::vector<Index> columns = order(columns_);
    Matrix sorted = Matrix::unset(size(), size());
    std::vector<Index> sortedRows, sortedColumns;
    for (Index j = 0; j < size(); ++j) {
      sortedRows.push_back(rows_[at(rows[at(j)])]);
      sortedColumns.push_back(columns_[at(columns[at(j)])]);
      for (Index i = 0; i < size(); ++i)
        sorted(i, j) = entries_(rows[at(i)], columns[at(j)]);
    }
    entries_ = std::move(sorted);
    rows_ = std::move(sortedRows);
    columns_ = std::move(sortedColumns);
    complete_ = std::count_if(columns_.begin(), columns_.end(), isComplete);
  }

  /// Puts a pivot at place k and updates the columns of the panel behind it; false: there is none.
  bool takePivot(Index k) {
    constexpr double share = 0.1;
    constexpr double smallest = std::numeric_limits<double>::epsilon();
    for (Index j = k; j < complete_; ++j) {
      const double* column = entries_.column(j);
      const auto less = [](double a, double b) { return std::abs(a) < std::abs(b); };
      const double* best = std::max_element(column + k, column + complete_, less);
      const double all = std::abs(*std::max_element(column + k, column + size(), less));
      if (!(std::abs(*best) >= share * all) || !(std::abs(*best) > smallest))
        continue;
      swapColumns(k, j);
      swapRows(k, best - column);
      update(k);
      return true;
    }
    return false;
  }
  void swapColumns(Index a, Index b) {
    std::swap(columns_[at(a)], columns_[at(b)]);
    if (a != b)
      std::swap_ranges(entries_.column(a), entries_.column(a) + size(),
                       entries_.column(b));
  }
  void swapRows(Index a, Index b) {
    std::swap(rows_[at(a)], rows_[at(b)]);
    for (Index j = 0; a != b && j < size(); ++j)
      std::swap(entries_(a, j), entries_(b, j));
  }
  void update(Index k) {
    double* pivots = entries_.column(k);
    for (Index i = k + 1; i < size(); ++i)
      pivots[i] /= pivots[k];
    for (Index j = k + 1; j < complete_; ++j) {
      double* column = entries_.column(j);
      const double factor = column[k];
      for (Index i = k + 1; factor != 0 && i < size(); ++i)
        column[i] -= pivots[i] * factor;
    }
  }

  std::vector<int> left_;  ///< parts that an unknown waits for
  std::vector<Index> rows_;
  std::vector<Index> columns_;
  Matrix entries_;
  Index complete_ = 0;
  std::vector<Index> places_;
};

FrontalFactor::FrontalFactor(Index size, const std::vector<Part>& parts)
    : largest_(size - 1) {
  Front front(size, parts);
  for (const std::size_t k : ordered(size, parts)) {
    front.add(parts[k]);
    stages_.push_back(front.eliminate());
  }
  Index left = size;  // an unknown of no part is one that no equation has
  for (const Stage& stage : stages_)
    left -= stage.lower.columns();
  if (left > 0)
    throw NumericalError(message(left, " unknowns of ", size, " are left"));
}

void FrontalFactor::solve(double* x) const {
  std::vector<Vector> solved;
  for (const Stage& stage : stages_) {
    const Index done = stage.lower.columns();
    Vector y;
    for (const Index row : stage.rows)
      y.push_back(x[row]);
    for (Index k = 0; k < done; ++k)
      for (std::size_t i = at(k) + 1; i < y.size(); ++i)
        y[i] -= stage.lower(static_cast<Index>(i), k) * y[at(k)];
    for (std::size_t i = at(done); i < y.size(); ++i)
      x[stage.rows[i]] = y[i];
    y.resize(at(done));
    solved.push_back(std::move(y));
  }
  // an equation's place may be that of an unknown that is solved for earlier
  Vector result(stages_.empty() ? 0 : at(largest_ + 1));
  for (std::size_t s = stages_.size(); s-- > 0;) {
    const Stage& stage = stages_[s];
    Vector& y = solved[s];
    const Index done = stage.lower.columns();
    for (Index j = 0; j < stage.upper.columns(); ++j) {
      const double known = result[at(stage.columns[at(done + j)])];
      for (Index k = 0; k < done; ++k)
        y[at(k)] -= stage.upper(k, j) * known;
    }
    for (Index k = done; k-- > 0;) {
      y[at(k)] /= stage.lower(k, k);
      for (Index i = 0; i < k; ++i)
        y[at(i)] -= stage.lower(i, k) * y[at(k)];
    }
    for (Index k = 0; k < done; ++k)
      result[at(stage.columns[at(k)])] = y[at(k)];
  }
  for (const Stage& stage : stages_)
    for (Index k = 0; k < stage.lower.columns(); ++k)
      x[stage.columns[at(k)]] = result[at(stage.columns[at(k)])];
}

}  // namespace epafi::bem
