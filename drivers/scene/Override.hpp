#pragma once

#include <string>

namespace Teuchos {
class ParameterList;
}

namespace epafi::drivers {

/// Applies one "A->B->Key=value" of --set: the first '=' separates, with or without
/// blanks, and the schema declares the type of the value.
///
/// "{Key=value, Key=value}" replaces a whole list, lists in it likewise; an empty value
/// removes a key or a list.
/// \throws bem::InputError for an undeclared path, a removed key, a value of another
///   type, or if there is nothing to remove.
void applyOverride(Teuchos::ParameterList& list, const std::string& assignment);

/// Removes keys of earlier versions that have their former default, as in every used.xml
/// of these versions: they have no effect.
/// \throws bem::InputError for another value, with the replacement of the key.
void dropRemovedKeys(Teuchos::ParameterList& scene);

}  // namespace epafi::drivers
