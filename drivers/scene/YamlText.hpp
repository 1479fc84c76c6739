#pragma once

#include "drivers/scene/SceneFile.hpp"

#include <string>

namespace epafi::drivers {

/// The list in a YAML text, which may use anchors, `<<` and multi-line lists.
///
/// A value in quotes is a string.  Other values get the narrowest type that fits: int,
/// double, bool, string; an array has the type that fits all entries; an array of arrays
/// is a table.  A key without a value is an empty list.
/// \throws bem::InputError with line and column for invalid YAML, for a document that is
///   not a tree of lists under one title, and for a nesting deeper than about 250.
RawScene readYaml(const std::string& text);

}  // namespace epafi::drivers
