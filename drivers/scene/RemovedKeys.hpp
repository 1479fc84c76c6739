#pragma once

#include <Teuchos_ParameterList.hpp>

#include <string>

namespace epafi::drivers {

/// Takes keys of earlier programs out of a scene where they hold the default that they had, as
/// each used.xml of that time does: it says nothing then.
/// \throws bem::InputError for another value, with what takes the key's place.
void dropRemovedKeys(Teuchos::ParameterList& scene);

/// \throws bem::InputError if a path A->B->Key is one of them, with what takes its place.
void refuseRemovedKey(const std::string& path);

}  // namespace epafi::drivers
