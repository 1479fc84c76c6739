#pragma once

#include <string>

namespace Teuchos {
class XMLObject;
}

namespace epafi::drivers {

/// The tree of a YAML text as XML spells it; anchors, `<<` and lists over several lines included.
///
/// A value in quotes is a string.  Others get the narrowest type that they spell: int, double,
/// bool, string; an array that of all its entries, an array of arrays is a table.  A key without
/// a value is an empty list.
/// \throws bem::InputError with line and column for what is no YAML, no tree of lists under one
///   title, or nested too deep (some 250).
Teuchos::XMLObject xmlOfYaml(const std::string& text);

}  // namespace epafi::drivers
