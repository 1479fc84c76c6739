#include "bem/compressed/Subtrees.hpp"

#include "bem/base/Error.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>

namespace epafi::bem {

// The highest level that has four clusters for each process; each goes to the process that
// has least so far.  Neighbours are on different processes then, and so is what changes
// together.
Subtrees::Subtrees(const ClusterTree& tree, const std::vector<Index>& weights,
                   const Processes& processes)
    : processes_(&processes), owners_(tree.size(), -1) {
  if (isAlone() || tree.levels() == 1)
    return;
  constexpr std::size_t each = 4;
  const auto count = static_cast<std::size_t>(processes.count());
  int level = 1;
  while (level < tree.levels() - 1 && tree.cut(level).size() < each * count)
    ++level;
  roots_ = tree.cut(level);
  std::vector<Index> loads(count);
  for (const int root : roots_) {
    const auto least = std::min_element(loads.begin(), loads.end());
    *least += weights[root];
    owners_[root] = static_cast<int>(least - loads.begin());
  }
  for (int c = 1; c < tree.size(); ++c)  // children come behind their parents
    owners_[c] = std::max(ownerOf(c), ownerOf(tree[c].parent));
}

// Sums with zeros, so that all have the same bits.  What each process is about comes behind.
Vector Subtrees::summed(double kind, double check, const std::string& failure,
                        Vector numbers) const {
  const std::size_t count = numbers.size();
  const double own[3] = {kind, check, failure.empty() ? 0.0 : 1.0};
  numbers.resize(count + std::size(own) * static_cast<std::size_t>(processes_->count()));
  std::copy(std::begin(own), std::end(own),
            numbers.end() - static_cast<std::ptrdiff_t>(std::size(own)) *
                                (processes_->count() - processes_->rank()));
  numbers = processes_->sum(std::move(numbers));
  bool fails = false;
  for (std::size_t r = count; r < numbers.size(); r += std::size(own)) {
    if (numbers[r] != kind || numbers[r + 1] != check)
      throw NumericalError(
          "the processes do not compute the same; they need processors of one kind");
    fails = fails || numbers[r + 2] != 0;
  }
  if (fails)
    throwFirst(failure);
  numbers.resize(count);
  return numbers;
}

// That of the lowest rank which has one.
void Subtrees::throwFirst(const std::string& failure) const {
  Vector sizes(processes_->count());
  sizes[processes_->rank()] = static_cast<double>(failure.size());
  sizes = processes_->sum(std::move(sizes));
  const auto first =
      std::find_if(sizes.begin(), sizes.end(), [](double size) { return size > 0; });
  Vector text(static_cast<std::size_t>(*first));
  if (first - sizes.begin() == processes_->rank())
    std::copy(failure.begin(), failure.end(), text.begin());
  text = processes_->sum(std::move(text));
  std::string message;
  for (const double c : text)
    message += static_cast<char>(c);
  throw NumericalError(message);
}

void Subtrees::exchangeRows(const ClusterTree& tree,
                            const std::vector<ClusterPart>& parts,
                            const std::vector<char>& paths, double check,
                            Matrix& x) const {
  exchangeNumbers(1, check, [&](const auto& action) {
    for (int c = 0; c < tree.size(); ++c)
      if (tree[c].isLeaf() && paths[c] != 0)
        for (const Index i : parts[c].active)
          for (Index j = 0; j < x.columns(); ++j)
            action(c, x(i, j));
  });
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
