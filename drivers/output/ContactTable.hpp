#pragma once

#include "contact/results/ContactFields.hpp"
#include "drivers/scene/Scene.hpp"

#include <functional>
#include <string>
#include <vector>

namespace epafi::drivers {

/// Additional columns of contact.csv, and their cells at a point.
struct MoreContactColumns {
  std::vector<std::string> names;
  std::function<std::vector<std::string>(std::size_t body,
                                         const contact::ContactFields::Element& element,
                                         double t, const contact::ContactPoint& point)>
      cells;
};

/// contact.csv: on each contact element the points t = -1 + (2k+1)/samples, k < samples.
std::string contactCsv(const Scene& scene, const std::vector<contact::Solved>& bodies,
                       const MoreContactColumns& more = {});

}  // namespace epafi::drivers
