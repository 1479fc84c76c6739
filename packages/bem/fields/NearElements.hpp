#pragma once

#include "bem/kernel/Elasticity.hpp"
#include "bem/quadrature/Graded.hpp"
#include "bem/simd/InstructionSet.hpp"
#include "bem/simd/Pack.hpp"
#include "bem/space/LocalField.hpp"

#include <vector>

namespace epafi::bem {

/// What elements do at points of another one in some states, in closed form.  Refers to its
/// arguments.
class NearElements {
 public:
  NearElements(const Mesh& mesh, int element, const std::vector<EndPoint>& points,
               std::size_t states);

  /// Adds an element, its field in each state: a segment's at points of a segment eight points at
  /// a time.
  void add(int source, const LocalField* fields,
           InstructionSet set = largestInstructionSet());

  FieldSums at(std::size_t point, std::size_t state) const;

  /// Of eight points: real and imaginary parts of the three sums of both fields.
  struct Lanes {
    AlignedLane sum[2][6];
  };

 private:
  const Mesh& mesh_;
  int element_;
  const std::vector<EndPoint>& points_;
  std::size_t states_;
  std::vector<Lanes> ofSegments_;  ///< of the first eight points all states, and so on
  std::vector<FieldSums> ofArcs_;  ///< or at points of an arc: of each point all states
};

}  // namespace epafi::bem
