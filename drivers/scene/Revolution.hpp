#pragma once

#include "bem/geometry/Outline.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace epafi::drivers {

struct Scene;

// Geometry->Type = Axisymmetric: bodies are solids of revolution about x = 0, drawn for x >= 0.

/// Reads the validated list Geometry at the root: are bodies solids of revolution?
/// \throws bem::InputError for Symmetry X
bool parseRevolution(const Teuchos::ParameterList& geometry);

/// The name of edges on the axis.
constexpr const char* axisBoundary = "axis";

/// The outlines of all bodies of a validated scene, in order: vertices near the axis are moved onto
/// it, edges on it are one, named axisBoundary.
/// \throws bem::InputError for points beyond the axis, a body that meets it at a point alone,
///   axisBoundary off it, and conditions or contacts there
std::vector<bem::Loops> alignedWithAxis(std::vector<bem::Loops> loops,
                                        const Teuchos::ParameterList& scene);

/// Refuses what solids of revolution do not have, or cannot do, in the whole scene.
/// \throws bem::InputError with the key and what is possible
void checkRevolution(const Scene& scene);

}  // namespace epafi::drivers
