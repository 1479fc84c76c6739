#pragma once

#include <string>
#include <vector>

namespace epafi::bem {

/// Levenshtein distance: least number of insertions, deletions and replacements.
int editDistance(const std::string& a, const std::string& b);

/// The candidate with the smallest editDistance, which is 0 for one that ends with the name, as
/// body:side with side; empty if there is none.
std::string nearest(const std::string& name, const std::vector<std::string>& candidates);

/// "'A', 'B' or 'C'"
std::string quotedList(const std::vector<std::string>& names);

/// "; did you mean 'X'? known here: 'X' or 'Y'", for the end of a message about an unknown
/// name; "; nothing may stand here" without candidates.
std::string suggestion(const std::string& name,
                       const std::vector<std::string>& candidates);

}  // namespace epafi::bem
