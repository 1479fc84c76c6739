#include "bem/compressed/Subtrees.hpp"

#include "bem/algebra/LapackAlgebra.hpp"
#include "bem/base/Error.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace epafi::bem {

namespace {

/// What each process has, by rank: sums with zeros, so that all have the same bits.
std::vector<Vector> gathered(const DenseAlgebra& algebra, const Vector& mine) {
  const auto count = static_cast<std::size_t>(algebra.processes());
  const auto rank = static_cast<std::size_t>(algebra.rank());
  Vector sizes(count);
  sizes[rank] = static_cast<double>(mine.size());
  sizes = algebra.sum(std::move(sizes));
  std::vector<std::size_t> starts(1, 0);
  for (const double size : sizes)
    starts.push_back(starts.back() + static_cast<std::size_t>(size));
  Vector all(starts.back());
  std::copy(mine.begin(), mine.end(), all.data() + starts[rank]);
  all = algebra.sum(std::move(all));
  std::vector<Vector> result;
  for (std::size_t r = 0; r < count; ++r)
    result.emplace_back(all.data() + starts[r], all.data() + starts[r + 1]);
  return result;
}

}  // namespace

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

std::vector<Parcel> Subtrees::exchange(double kind, double check, Parcel mine) const {
  Vector numbers = mine.take();
  numbers.insert(numbers.end(), {kind, check});
  std::vector<Parcel> result;
  for (Vector& theirs : gathered(*algebra_, numbers)) {
    const double itsCheck = theirs.back();
    theirs.pop_back();
    if (theirs.back() != kind || itsCheck != check)
      throw NumericalError(
          "the processes do not compute the same; they need processors of one kind");
    theirs.pop_back();
    result.emplace_back(std::move(theirs));
  }
  return result;
}

void Subtrees::exchangeRoots(const std::vector<char>& on, double check,
                             std::vector<Matrix>& matrices) const {
  Parcel mine;
  for (const int root : roots_)
    if (on[static_cast<std::size_t>(root)] != 0 && isMine(root))
      mine.put(matrices[static_cast<std::size_t>(root)]);
  std::vector<Parcel> all = exchange(3, check, std::move(mine));
  for (const int root : roots_)
    if (on[static_cast<std::size_t>(root)] != 0)
      matrices[static_cast<std::size_t>(root)] = all[at(ownerOf(root))].matrix();
}

void Subtrees::exchangeRows(const ClusterTree& tree,
                            const std::vector<ClusterPart>& parts,
                            const std::vector<char>& paths, double check,
                            Matrix& x) const {
  if (isAlone())
    return;
  const auto forRows = [&](int owner, const auto& action) {
    for (int c = 0; c < tree.size(); ++c)
      if (tree[c].isLeaf() && paths[static_cast<std::size_t>(c)] != 0 &&
          ownerOf(c) == owner)
        for (const Index i : parts[static_cast<std::size_t>(c)].active)
          for (Index j = 0; j < x.columns(); ++j)
            action(x(i, j));
  };
  Parcel mine;
  forRows(algebra_->rank(), [&](double& number) { mine.put(number); });
  std::vector<Parcel> all = exchange(1, check, std::move(mine));
  for (int r = 0; r < algebra_->processes(); ++r)
    forRows(r,
            [&](double& number) { number = all[static_cast<std::size_t>(r)].number(); });
}

void Subtrees::agree(const std::string& failure) const {
  if (isAlone()) {
    if (!failure.empty())
      throw NumericalError(failure);
    return;
  }
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
