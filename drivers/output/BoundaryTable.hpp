#pragma once

#include "drivers/run/Level.hpp"
#include "drivers/scene/Scene.hpp"

#include <string>

namespace epafi::drivers {

/// boundary.csv: displacement and traction along the whole boundary, element by element,
/// both ends included, with the element's boundary, number and degree; the traction is
/// the density ψ of Steklov-Poincaré's operator.
std::string boundaryCsv(const Scene& scene, const SolvedLevel& level);

}  // namespace epafi::drivers
