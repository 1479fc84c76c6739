#pragma once

#include "bem/mesh/Mesh.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"
#include "contact/solve/Report.hpp"

#include <string>

namespace epafi::drivers {

/// "; contact points that still change state: (0.31, 0) on foundation, ...": where a
/// solve that did not converge is undecided, at most five; empty if it is nowhere.
std::string restlessPlaces(const contact::Report& report,
                           const contact::MultiplierSpace& multiplier,
                           const bem::Mesh& mesh);

}  // namespace epafi::drivers
