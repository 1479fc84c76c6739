#pragma once

#include "drivers/run/Level.hpp"
#include "drivers/scene/Scene.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// contact.csv: `samples` points t = -1 + (2k+1)/samples on each contact element.
std::string contactCsv(const Scene& scene, const std::vector<contact::Solved>& bodies);

/// boundary.csv: displacement and traction along the whole boundary, element by element,
/// both ends included, with the element's boundary, number and degree; the traction is
/// the density ψ of Steklov-Poincaré's operator.
std::string boundaryCsv(const Scene& scene, const SolvedLevel& level);

/// bodies.csv: per level and body the resultants of loads, contact and what holds it, which
/// add up to nothing.
std::string bodiesHead();
std::string bodiesLines(const Scene& scene, const LevelRow& row);

}  // namespace epafi::drivers
