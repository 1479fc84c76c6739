#pragma once

#include <string>

namespace epafi::drivers {

/// Parsers, and what they make, go down by recursion, on a stack that ends.
/// \throws bem::InputError if lists stand in lists too deep; without the file.
void checkNestingOfXml(const std::string& text);

}  // namespace epafi::drivers
