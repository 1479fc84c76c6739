#pragma once

#include <string>

namespace epafi::drivers {

/// Parsers, and what they make, go down by recursion, on a stack that ends; and the time
/// that YAML takes grows with the square of its depth.
/// \throws bem::InputError if lists stand in lists too deep; without the file.
void checkNestingOfXml(const std::string& text);
void checkNestingOfYaml(const std::string& text);

}  // namespace epafi::drivers
