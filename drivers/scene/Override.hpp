#pragma once

#include <string>

namespace Teuchos {
class ParameterList;
}

namespace epafi::drivers {

/// Applies one "A->B->Key=value" of --set: the first '=' splits, the type that the schema
/// declares for the path decides how the value is read.
///
/// A list is replaced as a whole by "{Key=value, Key=value}", lists within lists likewise; a
/// key or a list without anything behind its '=' is removed.
/// \throws bem::InputError for an undeclared path, a removed key, a value of another type, or if there is
///   nothing to remove.
void applyOverride(Teuchos::ParameterList& list, const std::string& assignment);

/// Takes keys of earlier programs out of a scene where they hold the default that they had, as
/// each used.xml of that time does: it says nothing then.
/// \throws bem::InputError for another value, with what takes the key's place.
void dropRemovedKeys(Teuchos::ParameterList& scene);

}  // namespace epafi::drivers
