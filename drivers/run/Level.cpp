#include "drivers/run/Level.hpp"

#include <algorithm>

namespace epafi::drivers {

Size sizeOf(const bem::Space& space, const contact::MultiplierSpace& multiplier,
            const contact::Conditions& conditions) {
  const bem::Mesh& mesh = space.mesh();
  const auto& elements = mesh.elements();
  const auto [lowest, highest] = std::minmax_element(
      elements.begin(), elements.end(),
      [](const auto& a, const auto& b) { return a.degree < b.degree; });
  const auto [shortest, longest] =
      std::minmax_element(elements.begin(), elements.end(),
                          [](const auto& a, const auto& b) { return a.half < b.half; });
  const double diameter = mesh.outline().scaling().length;
  Size size;
  size.elements = mesh.size();
  size.displacements = contact::freeDisplacements(space, conditions);
  size.multipliers = multiplier.size();
  size.densities = space.densities();
  size.degreeMin = lowest->degree;
  size.degreeMax = highest->degree;
  size.sizeMin = 2 * shortest->half * diameter;
  size.sizeMax = 2 * longest->half * diameter;
  return size;
}

}  // namespace epafi::drivers
