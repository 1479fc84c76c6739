#pragma once

#include "drivers/output/BoundaryLines.hpp"
#include "drivers/scene/Scene.hpp"

#include <string>

namespace epafi::drivers {

/// boundary.csv: displacement and traction along the whole boundary of what deforms, element
/// by element, both ends included, with the element's boundary, number and degree; the
/// traction is the density ψ of Steklov-Poincaré's operator.
std::string boundaryCsv(const Scene& scene, const BoundaryLines& grid);

}  // namespace epafi::drivers
