#include "bem/compressed/Subtrees.hpp"

#include "bem/algebra/LapackAlgebra.hpp"
#include "bem/base/Error.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace epafi::bem {

void Parcel::put(const std::vector<Index>& list) {
  put(static_cast<double>(list.size()));
  numbers_.insert(numbers_.end(), list.begin(), list.end());
}

void Parcel::put(const std::string& text) {
  put(std::vector<Index>(text.begin(), text.end()));
}

void Parcel::put(const Matrix& matrix) {
  put(static_cast<double>(matrix.rows()));
  put(static_cast<double>(matrix.columns()));
  for (Index j = 0; j < matrix.columns(); ++j)
    numbers_.insert(numbers_.end(), matrix.column(j), matrix.column(j) + matrix.rows());
}

std::vector<Index> Parcel::list() {
  std::vector<Index> result(static_cast<std::size_t>(number()));
  for (Index& i : result)
    i = static_cast<Index>(number());
  return result;
}

std::string Parcel::text() {
  const std::vector<Index> list = this->list();
  std::string result;
  for (const Index i : list)
    result += static_cast<char>(i);
  return result;
}

Matrix Parcel::matrix() {
  const auto rows = static_cast<Index>(number());
  const auto columns = static_cast<Index>(number());
  Matrix result(rows, columns);
  for (Index j = 0; j < columns; ++j, next_ += at(rows))
    std::copy_n(numbers_.data() + next_, rows, result.column(j));
  return result;
}

// The highest level that has four clusters for each process; each goes to the process that
// has least so far.  Neighbours are on different processes then, and so is what changes
// together.
Subtrees::Subtrees(const ClusterTree& tree, const std::vector<Index>& weights,
                   const DenseAlgebra& algebra)
    : algebra_(&algebra), owners_(static_cast<std::size_t>(tree.size()), -1) {
  if (isAlone() || tree.levels() == 1)
    return;
  constexpr std::size_t each = 4;
  const auto processes = static_cast<std::size_t>(algebra.processes());
  int level = 1;
  while (level < tree.levels() - 1 && tree.cut(level).size() < each * processes)
    ++level;
  roots_ = tree.cut(level);
  std::vector<Index> loads(processes);
  for (const int root : roots_) {
    const auto least = std::min_element(loads.begin(), loads.end());
    *least += weights[static_cast<std::size_t>(root)];
    owners_[static_cast<std::size_t>(root)] = static_cast<int>(least - loads.begin());
  }
  for (int c = 1; c < tree.size(); ++c)  // children come behind their parents
    owners_[static_cast<std::size_t>(c)] = std::max(ownerOf(c), ownerOf(tree[c].parent));
}

// Sums with zeros, so that all have the same bits.  What each process is about comes behind.
Vector Subtrees::summed(double kind, double check, Vector numbers) const {
  const std::size_t count = numbers.size();
  const auto processes = static_cast<std::size_t>(algebra_->processes());
  numbers.resize(count + 2 * processes);
  const std::size_t own = count + 2 * static_cast<std::size_t>(algebra_->rank());
  numbers[own] = kind;
  numbers[own + 1] = check;
  numbers = algebra_->sum(std::move(numbers));
  for (std::size_t r = count; r < numbers.size(); r += 2)
    if (numbers[r] != kind || numbers[r + 1] != check)
      throw NumericalError(
          "the processes do not compute the same; they need processors of one kind");
  numbers.resize(count);
  return numbers;
}

std::vector<Parcel> Subtrees::exchange(double kind, double check, Parcel parcel) const {
  const Vector mine = parcel.take();
  const auto rank = static_cast<std::size_t>(algebra_->rank());
  Vector sizes(static_cast<std::size_t>(algebra_->processes()));
  sizes[rank] = static_cast<double>(mine.size());
  sizes = summed(kind, check, std::move(sizes));
  std::vector<std::size_t> starts(1, 0);
  for (const double size : sizes)
    starts.push_back(starts.back() + static_cast<std::size_t>(size));
  Vector all(starts.back());
  std::copy(mine.begin(), mine.end(), all.data() + starts[rank]);
  all = summed(kind, check, std::move(all));
  std::vector<Parcel> result;
  for (std::size_t r = 0; r < sizes.size(); ++r)
    result.emplace_back(Vector(all.data() + starts[r], all.data() + starts[r + 1]));
  return result;
}

void Subtrees::exchangeRows(const ClusterTree& tree,
                            const std::vector<ClusterPart>& parts,
                            const std::vector<char>& paths, double check,
                            Matrix& x) const {
  exchangeNumbers(1, check, [&](const auto& action) {
    for (int c = 0; c < tree.size(); ++c)
      if (tree[c].isLeaf() && paths[static_cast<std::size_t>(c)] != 0)
        for (const Index i : parts[static_cast<std::size_t>(c)].active)
          for (Index j = 0; j < x.columns(); ++j)
            action(c, x(i, j));
  });
}

void Subtrees::agree(const std::string& failure) const {
  if (isAlone()) {
    if (!failure.empty())
      throw NumericalError(failure);
    return;
  }
  const Vector failing = summed(2, 0, {failure.empty() ? 0.0 : 1.0});
  if (failing.front() == 0)
    return;
  Parcel mine;
  mine.put(failure);
  for (Parcel& theirs : exchange(2, 0, std::move(mine))) {
    const std::string text = theirs.text();
    if (!text.empty())
      throw NumericalError(text);
  }
}

const DenseAlgebra& oneProcess() {
  static const LapackAlgebra algebra;
  return algebra;
}

double checkOf(const Matrix& x) {
  std::uint64_t sum = 1469598103934665603u;
  for (Index j = 0; j < x.columns(); ++j)
    for (Index i = 0; i < x.rows(); ++i) {
      std::uint64_t bits = 0;
      const double number = x(i, j) + 0.0;  // zeros have one sign
      std::memcpy(&bits, &number, sizeof bits);
      sum = (sum ^ bits) * 1099511628211u;
    }
  return static_cast<double>(sum >> 12);
}

}  // namespace epafi::bem
