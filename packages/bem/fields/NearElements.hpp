#pragma once

#include "bem/fields/PointSources.hpp"
#include "bem/mesh/Mesh.hpp"
#include "bem/quadrature/Graded.hpp"
#include "bem/space/LocalField.hpp"

#include <vector>

namespace epafi::bem {

/// What elements do at points of another one in some states, in closed form.  Refers to its
/// arguments.
class NearElements {
 public:
  NearElements(const Mesh& mesh, int element, const std::vector<EndPoint>& points,
               std::size_t states);

  /// Adds an element, its field in each state.
  void add(int source, const LocalField* fields,
           InstructionSet set = largestInstructionSet());

  FieldSums at(std::size_t point, std::size_t state) const {
    return sums_[point / lanes * states_ + state].at(point % lanes);
  }

 private:
  const Mesh& mesh_;
  int element_;
  const std::vector<EndPoint>& points_;
  std::size_t states_;
  std::vector<PointSources::Sums>
      sums_;  ///< of the first eight points all states, and so on
};

}  // namespace epafi::bem
