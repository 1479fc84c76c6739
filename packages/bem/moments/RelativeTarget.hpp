#pragma once

#include "bem/mesh/Mesh.hpp"
#include "bem/quadrature/Graded.hpp"

#include <optional>

namespace epafi::bem {

/// A boundary point relative to element e, accurate near a common vertex; b = 0 exactly if it
/// is on the edge of e.
RelativeTarget seenFrom(const Mesh& mesh, int e, const BoundaryPoint& x);

/// Appends the end points of element `source` as features of a rule on `element`.
void appendEnds(const Mesh& mesh, int element, int source,
                std::vector<Feature>& features);

/// Points of `element` relative to element `source`.  Refers to its arguments.
class SeenPoints {
 public:
  SeenPoints(const Mesh& mesh, int element, int source,
             const std::vector<EndPoint>& points);

  const std::vector<EndPoint>& points() const { return points_; }
  /// Do both elements belong to one edge?
  bool areOnLine() const {
    return mesh_[element_].piece.edge == mesh_[source_].piece.edge;
  }
  /// Both ends of a straight element as targets, and the change of z along half its length.
  struct Sight {
    RelativeTarget start;
    RelativeTarget end;
    Complex step;
  };
  /// Set if both elements are straight.
  const std::optional<Sight>& sight() const { return sight_; }
  /// Point i; the last point for larger i.
  RelativeTarget operator[](std::size_t i) const;

 private:
  const Mesh& mesh_;
  int element_;
  int source_;
  const std::vector<EndPoint>& points_;
  std::optional<Sight> sight_;
};

}  // namespace epafi::bem
