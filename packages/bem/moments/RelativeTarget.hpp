#pragma once

#include "bem/mesh/Mesh.hpp"
#include "bem/quadrature/Graded.hpp"

#include <optional>

namespace epafi::bem {

/// A boundary point seen from element e, accurate near a common vertex; exactly b = 0
/// when it lies on the element's own edge.
RelativeTarget seenFrom(const Mesh& mesh, int e, const BoundaryPoint& x);

/// Appends the ends of element `source` as features on `element`.
void appendEnds(const Mesh& mesh, int element, int source,
                std::vector<Feature>& features);

/// Points of an element seen from another one.  Refers to its arguments.
class SeenPoints {
 public:
  SeenPoints(const Mesh& mesh, int element, int source,
             const std::vector<EndPoint>& points);

  const std::vector<EndPoint>& points() const { return points_; }
  /// Of both elements' edge.
  bool areOnLine() const {
    return mesh_[element_].piece.edge == mesh_[source_].piece.edge;
  }
  /// All of them on a line: the element's ends and what half a length of it adds.
  struct Sight {
    RelativeTarget start;
    RelativeTarget end;
    Complex step;
  };
  /// If both are straight.
  const std::optional<Sight>& sight() const { return sight_; }
  /// The last one for those behind it.
  RelativeTarget operator[](std::size_t i) const;

 private:
  const Mesh& mesh_;
  int element_;
  int source_;
  const std::vector<EndPoint>& points_;
  std::optional<Sight> sight_;
};

}  // namespace epafi::bem
