#pragma once

#include "bem/base/Material.hpp"
#include "bem/geometry/CurveTree.hpp"

#include <string>
#include <vector>

namespace epafi::bem {

/// A closed polygon in the user's coordinates, counter-clockwise; edge i from vertex i to i+1
/// is a segment or a circular arc.
struct Loop {
  std::vector<Vec2> vertices;
  std::vector<std::string> edges;  ///< name of the boundary of each edge
  /// tan(angle/4) of each edge, > 0: to the right of its chord; empty: all straight.
  std::vector<double> bulges = {};

  Curve curve(std::size_t edge) const;  ///< in the user's coordinates
  /// > 0 if it runs counter-clockwise; no digits are lost far from the origin.
  double twiceArea() const;
};

/// The closed lines of a body, all counter-clockwise.
struct Loops {
  Loop outer;
  std::vector<Loop> holes;
};

/// An edge of the outline.
struct Edge {
  Curve curve;  ///< in scaled coordinates; the body lies to its left
  Vec2 start;   ///< start point in the user's coordinates
  int loop = 0;
  int previous = 0;  ///< the edge that ends where this one starts
  int next = 0;
  std::string boundary;
};

/// Transformation to scaled coordinates: scaled = (physical - origin) / length.
struct Scaling {
  Vec2 origin;        ///< in the user's coordinates
  double length = 1;  ///< in the user's unit
  /// Are bodies solids of revolution about x = 0, drawn for x >= 0?  Then origin.x = 0.
  bool isAxisymmetric = false;
  /// Boundary on a line about which the body is mirrored; empty: none.
  std::string mirror = {};
};

/// Length: the diameter of the polygon (arcs by 32 points); origin: centre of its bounding box,
/// of a solid of revolution on the axis.
Scaling scalingOf(const Loop& outer, bool isAxisymmetric = false);

/// The boundary of a body: one outer polygon and any number of holes.
///
/// In scaled coordinates the outer polygon has diameter 1, or less if bodies share a scaling,
/// and contains the origin, unless it is a section of a solid of revolution: the single layer potential is positive definite only on small
/// outlines (doc/theory/operators.md), and coordinates far from the origin would lose digits.
/// physical() and scaled() convert.
class Outline {
 public:
  /// Holes are given counter-clockwise and stored clockwise, with the body on their left.
  /// \throws InputError naming the vertex or edge if a polygon has fewer than three vertices
  ///   (two with arcs), a bulge beyond 10 or a wrong number of bulges, a zero or non-finite edge,
  ///   is clockwise, touches or crosses itself or another one, or if a hole is not inside the
  ///   outer polygon
  explicit Outline(const Loop& outer, const std::vector<Loop>& holes = {})
      : Outline(outer, holes, scalingOf(outer)) {}
  /// In a given scaling.  \throws InputError also if the diameter exceeds scaling.length
  Outline(const Loop& outer, const std::vector<Loop>& holes, const Scaling& scaling);

  const std::vector<Edge>& edges() const { return edges_; }
  const Edge& edge(int e) const { return edges_[e]; }
  /// Of the edges, in scaled coordinates.
  const CurveTree& curves() const { return curves_; }
  /// e if it is straight, else -1.
  int lineOf(int e) const { return edge(e).curve.isStraight() ? e : -1; }
  int loops() const { return loops_; }

  /// Diameter of the outer polygon, in the user's unit of length.
  double diameter() const { return diameter_; }
  const Scaling& scaling() const { return scaling_; }
  /// Units of results computed in this scaling with this reference stress.
  Units units(double stress) const {
    return {scaling_.length, stress, scaling_.isAxisymmetric};
  }
  bool isAxisymmetric() const { return scaling_.isAxisymmetric; }
  /// Is this edge a part of the axis of revolution?
  bool isAxis(int e) const {
    return isAxisymmetric() && edge(e).curve.from().x == 0 && edge(e).curve.to().x == 0;
  }
  /// Does the body go on behind this edge as its image?
  bool isMirror(int e) const {
    return isAxis(e) || (!scaling_.mirror.empty() && edge(e).boundary == scaling_.mirror);
  }

  Vec2 physical(Vec2 scaled) const { return scaling_.origin + scaling_.length * scaled; }
  Vec2 scaled(Vec2 physical) const {
    return (1 / scaling_.length) * (physical - scaling_.origin);
  }

  /// Is a (physical) point inside the body, off its boundary?
  bool contains(Vec2 physical) const;

 private:
  std::vector<Edge> edges_;
  CurveTree curves_;  ///< of the edges
  int loops_ = 0;
  double diameter_ = 1;
  Scaling scaling_;
};

}  // namespace epafi::bem
