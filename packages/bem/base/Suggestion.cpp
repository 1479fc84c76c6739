#include "bem/base/Suggestion.hpp"

#include "bem/base/Error.hpp"

#include <algorithm>
#include <cctype>
#include <limits>

namespace epafi::bem {

double editDistance(const std::string& a, const std::string& b) {
  const auto differ = [](char p, char q) {
    const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    return p == q ? 0.0 : lower(p) == lower(q) ? 0.5 : 1.0;
  };
  const std::size_t m = a.size();
  const std::size_t n = b.size();
  std::vector<double> table((m + 1) * (n + 1));
  const auto d = [&table, n](std::size_t i, std::size_t j) -> double& {
    return table[i * (n + 1) + j];
  };
  for (std::size_t i = 0; i <= m; ++i)
    for (std::size_t j = 0; j <= n; ++j) {
      if (i == 0 || j == 0) {
        d(i, j) = static_cast<double>(i + j);
        continue;
      }
      d(i, j) = std::min({d(i - 1, j) + 1, d(i, j - 1) + 1,
                          d(i - 1, j - 1) + differ(a[i - 1], b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d(i, j) = std::min(d(i, j), d(i - 2, j - 2) + 1);
    }
  return d(m, n);
}

std::string nearest(const std::string& name, const std::vector<std::string>& candidates) {
  std::string best;
  double smallest = std::numeric_limits<double>::infinity();
  for (const std::string& candidate : candidates) {
    // What differs in length takes at least that many insertions.
    const std::size_t longer = std::max(name.size(), candidate.size());
    const std::size_t shorter = std::min(name.size(), candidate.size());
    if (static_cast<double>(longer - shorter) >= smallest)
      continue;
    const double distance = editDistance(name, candidate);
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
