#pragma once

#include "drivers/scene/Expression.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <utility>
#include <vector>

namespace epafi::drivers {

/// Entries of a list, each with its path A->B->Key.
using Entries = std::vector<std::pair<std::string, Teuchos::ParameterEntry>>;

/// Puts numbers where the schema wants some and a scene has texts: the values of these
/// expressions in the scene's constants and tables.  Vertices, radii, moduli and numbers of
/// elements follow a constant that way.  Returns what stood there.
/// \throws bem::InputError for what is no such expression, and for a fraction where a whole
///   number is wanted.
Entries evaluateNumbers(Teuchos::ParameterList& scene, const std::string& file,
                        const Names& names);

/// Puts entries where they came from.
void putBack(const Entries& entries, Teuchos::ParameterList& scene);

}  // namespace epafi::drivers
