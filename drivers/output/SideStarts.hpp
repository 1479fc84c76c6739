#pragma once

#include "bem/base/Matrix.hpp"
#include "bem/mesh/Mesh.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace epafi::drivers {

/// Arc length at the start of each element, dimensionless: from 0 at the start of its side, or of a
/// side without one at that of its first element.
/// \param side of each element; Side{}: of none, NaN
template <class Side>
bem::Vector startsAlong(const bem::Mesh& mesh, const std::vector<Side>& side) {
  bem::Vector starts(side.size(), std::numeric_limits<double>::quiet_NaN());
  const auto walk = [&](int first) {
    double start = 0;
    for (int e = first;
         side[bem::at(e)] == side[bem::at(first)] && std::isnan(starts[bem::at(e)]);
         e = mesh[e].next) {
      starts[bem::at(e)] = start;
      start += 2 * mesh[e].half;
    }
  };
  const auto walkFrom = [&](bool anywhere) {
    for (int e = 0; e < mesh.size(); ++e)
      if (side[bem::at(e)] != Side{} &&
          (anywhere || side[bem::at(mesh[e].previous)] != side[bem::at(e)]))
        walk(e);
  };
  walkFrom(false);
  walkFrom(true);
  return starts;
}

}  // namespace epafi::drivers
