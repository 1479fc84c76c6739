#include "adaptivity/mark/Doerfler.hpp"

#include <algorithm>

namespace epafi::adaptivity {

std::vector<int> doerfler(const bem::Vector& squares, double fraction) {
  constexpr double tie = 1e-5;
  bem::Vector sorted = squares;
  std::sort(sorted.begin(), sorted.end(), std::greater<>());
  // summed from the small ones: the total is then reached exactly when fraction is 1
  bem::Vector tails(sorted.size() + 1, 0.0);
  for (std::size_t k = sorted.size(); k-- > 0;)
    tails[k] = tails[k + 1] + sorted[k];
  const double total = tails[0];
  if (!(total > 0))
    return {};
  const double rest = (1 - fraction) * total;
  std::size_t count = 1;
  while (count < sorted.size() && tails[count] > rest)
    ++count;
  const double smallest = (1 - tie) * sorted[count - 1];
  std::vector<int> marked;
  for (std::size_t e = 0; e < squares.size(); ++e)
    if (squares[e] > 0 && squares[e] >= smallest)
      marked.push_back(static_cast<int>(e));
  return marked;
}

std::vector<std::vector<int>> doerfler(const std::vector<bem::Vector>& squares,
                                       double fraction) {
  bem::Vector all;
  for (const bem::Vector& body : squares)
    all.insert(all.end(), body.begin(), body.end());
  std::vector<std::vector<int>> marked(squares.size());
  std::size_t b = 0;
  int first = 0;
  for (const int e : doerfler(all, fraction)) {
    while (e - first >= static_cast<int>(squares[b].size()))
      first += static_cast<int>(squares[b++].size());
    marked[b].push_back(e - first);
  }
  return marked;
}

}  // namespace epafi::adaptivity
