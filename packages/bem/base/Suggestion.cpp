#include "bem/base/Suggestion.hpp"

#include "bem/base/Error.hpp"

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <limits>
#include <numeric>

namespace epafi::bem {

int editDistance(const std::string& a, const std::string& b) {
  std::vector<int> row(b.size() + 1);  // of what is read of a, to each beginning of b
  std::iota(row.begin(), row.end(), 0);
  for (const char c : a) {
    int before = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const int replaced = before + (c == b[j] ? 0 : 1);
      before = row[j + 1];
      row[j + 1] = std::min({before + 1, row[j] + 1, replaced});
    }
  }
  return row.back();
}

std::string nearest(const std::string& name, const std::vector<std::string>& candidates) {
  std::string best;
  int smallest = std::numeric_limits<int>::max();
  for (const std::string& candidate : candidates) {
    const bool isEnd = boost::algorithm::ends_with(candidate, name);  // a side of a body
    const int distance = isEnd ? 0 : editDistance(name, candidate);
    if (distance < smallest) {
      smallest = distance;
      best = candidate;
    }
  }
  return best;
}

std::string quotedList(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0                  ? ""
             : i + 1 == names.size() ? " or "
                                     : ", ") +
            ("'" + names[i] + "'");
  return text;
}

std::string suggestion(const std::string& name,
                       const std::vector<std::string>& candidates) {
  if (candidates.empty())
    return "; nothing may stand here";
  return message("; did you mean '", nearest(name, candidates),
                 "'? known here: ", quotedList(candidates));
}

}  // namespace epafi::bem
