#pragma once

#include "bem/base/Material.hpp"
#include "contact/problem/Summary.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// contact.csv: `samples` points t = -1 + (2k+1)/samples on each contact element.
std::string contactCsv(const contact::Solved& solved, int samples);

/// boundary.csv: displacement and traction along the whole boundary, element by element,
/// both ends included, with the element's boundary, number and degree; the traction is
/// the density ψ of Steklov-Poincaré's operator.
std::string boundaryCsv(const contact::Solved& solved, const bem::Vector& density);

/// interior.csv: displacement and stress at points inside the body, in the user's
/// coordinates.  von Mises' stress includes the stress across the plane.
std::string interiorCsv(const contact::Solved& solved, const bem::Vector& density,
                        const bem::Material& material,
                        const std::vector<bem::Vec2>& points);

}  // namespace epafi::drivers
