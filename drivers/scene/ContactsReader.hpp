#pragma once

#include "drivers/scene/Scene.hpp"

namespace epafi::drivers {

/// Reads the contacts of a scene whose bodies are read: the two sides, the parts of the
/// first side that have an opposite side, and required nodes at the ends of these parts.
/// \throws bem::InputError for unknown bodies or boundaries, contact of a body with
///   itself or of two rigid ones, a boundary that already has a condition, sides that
///   never face each other, and bodies that overlap away from their contacts.
void readContacts(Scene& scene);

}  // namespace epafi::drivers
