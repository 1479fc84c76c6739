#pragma once

#include <string>
#include <vector>

namespace epafi::drivers {

/// The pieces of "a, f(b, c), {d, e}": commas within parentheses and braces do not count,
/// unless these are not in pairs: then every comma does.
std::vector<std::string> pieces(const std::string& text);

/// Are braces and parentheses in pairs?
bool isBalanced(const std::string& text);

/// An array of texts "{A={4, 4}, B=1}" in which Teuchos, who splits at every comma and ends
/// at the first brace, finds the entries: signs within an entry are hidden.
std::string hidden(const std::string& array);
/// An entry with its own signs again.
std::string shown(const std::string& entry);

}  // namespace epafi::drivers
