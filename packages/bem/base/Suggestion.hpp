#pragma once

#include <string>
#include <vector>

namespace epafi::bem {

/// Levenshtein distance: least number of insertions, deletions and replacements.
int editDistance(const std::string& a, const std::string& b);

/// The candidate with the smallest editDistance, capitals aside, which is 0 for one that ends with the
/// name, as body:side with side; empty if there is none.
std::string nearest(const std::string& name, const std::vector<std::string>& candidates);

/// "; did you mean 'X'?" with the one that other programs call so, or the nearest one if at most half of
/// the name's letters are wrong; else empty.
std::string meant(const std::string& name, const std::vector<std::string>& candidates);

/// "'A', 'B' or 'C'"
std::string quotedList(const std::vector<std::string>& names);

/// meant() and "; known here: 'X' or 'Y'", for the end of a message about an unknown
/// name; "; nothing may stand here" without candidates.
std::string suggestion(const std::string& name,
                       const std::vector<std::string>& candidates);

}  // namespace epafi::bem
