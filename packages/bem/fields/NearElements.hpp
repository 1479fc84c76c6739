#pragma once

#include "bem/kernel/Elasticity.hpp"
#include "bem/quadrature/Graded.hpp"
#include "bem/simd/InstructionSet.hpp"
#include "bem/simd/Pack.hpp"
#include "bem/space/LocalField.hpp"

#include <vector>

namespace epafi::bem {

/// What elements do at points of another one, in closed form.  Refers to its arguments.
class NearElements {
 public:
  NearElements(const Mesh& mesh, int element, const std::vector<EndPoint>& points);

  /// Adds an element: a segment's field at points of a segment eight points at a time.
  void add(int source, const LocalField& field,
           InstructionSet set = largestInstructionSet());

  FieldSums at(std::size_t point) const;

  /// Of eight points: real and imaginary parts of the three sums of both fields.
  struct Lanes {
    AlignedLane sum[2][6];
  };

 private:
  const Mesh& mesh_;
  int element_;
  const std::vector<EndPoint>& points_;
  std::vector<Lanes> ofSegments_;
  std::vector<FieldSums> ofArcs_;  ///< or at points of an arc
};

}  // namespace epafi::bem
