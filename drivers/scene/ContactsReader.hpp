#pragma once

#include "drivers/scene/Scene.hpp"

namespace epafi::drivers {

/// Reads the contacts of a scene whose bodies are read: what meets what, the
/// parts of the sides that do, and the nodes that their ends make on both.
/// \throws bem::InputError for a body or boundary that there is not, contact of a body with
///   itself or of two rigid ones, a boundary that has a condition already, sides that never
///   meet, bodies that overlap away from their contacts.
void readContacts(Scene& scene);

}  // namespace epafi::drivers
