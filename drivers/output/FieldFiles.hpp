#pragma once

#include "drivers/output/FieldGrid.hpp"
#include "drivers/scene/Scene.hpp"

#include <functional>
#include <string>
#include <vector>

namespace epafi::drivers {

/// Columns behind those of contact.csv, and their cells at a point.
struct MoreContactColumns {
  std::vector<std::string> names;
  std::function<std::vector<std::string>(std::size_t body,
                                         const contact::ContactFields::Element& element,
                                         double t, const contact::ContactPoint& point)>
      cells;
};

/// contact.csv: `samples` points t = -1 + (2k+1)/samples on each contact element.
std::string contactCsv(const Scene& scene, const std::vector<contact::Solved>& bodies,
                       const MoreContactColumns& more = {});

/// boundary.csv: displacement and traction along the whole boundary of what deforms, element
/// by element, both ends included, with the element's boundary, number and degree; the
/// traction is the density ψ of Steklov-Poincaré's operator.
std::string boundaryCsv(const Scene& scene, const FieldGrid& grid);

/// bodies.csv: per level, step of a path (else 0) and body the resultants of loads, contact
/// and what holds it, which add up to nothing, and its motion: of a body that deforms the
/// mean over its boundary, of another one that of its reference point.
std::string bodiesHead();
std::string bodiesLines(const Scene& scene, int level, int step,
                        const std::vector<contact::Summary>& bodies,
                        const std::vector<RigidRow>& rigid);

}  // namespace epafi::drivers
