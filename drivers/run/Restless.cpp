#include "drivers/run/Restless.hpp"

#include "bem/base/Error.hpp"

#include <algorithm>
#include <set>

namespace epafi::drivers {

std::string restlessPlaces(const contact::Report& report,
                           const contact::MultiplierSpace& multiplier,
                           const bem::Mesh& mesh) {
  constexpr std::size_t shown = 5;
  const std::set<contact::Index> restless(report.restless.begin(), report.restless.end());
  std::vector<std::string> places;
  for (const auto& element : multiplier.elements()) {
    const bem::Vector at = multiplier.basis().places(element.degree);
    for (int i = 0; i <= element.degree; ++i) {
      const bool here =
          restless.count(element.normalOf(i)) > 0 ||
          (element.tangential >= 0 && restless.count(element.tangentialOf(i)) > 0);
      if (!here)
        continue;
      const bem::Vec2 place =
          mesh.physicalPoint(element.element, at[static_cast<std::size_t>(i)]);
      places.push_back(
          bem::message("(", place.x, ", ", place.y, ") on ", *element.boundary));
    }
  }
  std::string text;
  for (std::size_t k = 0; k < std::min(places.size(), shown); ++k)
    text += (k == 0 ? "; contact points that still change state: " : ", ") + places[k];
  if (places.size() > shown)
    text += bem::message(" and ", places.size() - shown, " more");
  return text;
}

}  // namespace epafi::drivers
