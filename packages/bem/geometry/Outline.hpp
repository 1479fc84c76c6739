#pragma once

#include "bem/base/Material.hpp"
#include "bem/geometry/Curve.hpp"

#include <string>
#include <vector>

namespace epafi::bem {

/// A closed polygon as the user writes it: counter-clockwise, edge i from vertex i to
/// i+1, a segment or a circular arc.
struct Loop {
  std::vector<Vec2> vertices;
  std::vector<std::string> edges;  ///< the boundary's name for each edge
  /// tan(angle/4) for each edge, > 0: to the right of its chord; none: all straight.
  std::vector<double> bulges = {};
};

/// The closed lines of a body, all counter-clockwise as Outline wants them.
struct Loops {
  Loop outer;
  std::vector<Loop> holes;
};

/// A piece of the outline, in the outline's own units (see Outline).
struct Edge {
  Curve curve;  ///< the body lies to its left
  Vec2 start;   ///< where it starts, as the user wrote it
  int loop = 0;
  int previous = 0;  ///< the edge that ends where this one starts
  int next = 0;
  std::string boundary;
};

/// The system in which outlines are scaled and shifted.
struct Scaling {
  Vec2 origin;        ///< user's coordinates of the scaled origin
  double length = 1;  ///< the user's unit of what a scaled 1 means
};

/// Of a polygon by itself: its diameter (of arcs at 32 points), and the middle of its box.
Scaling scalingOf(const Loop& outer);

/// The boundary of a body: one outer polygon and any number of holes.
///
/// Coordinates are scaled and shifted so that the outer polygon has a diameter of 1, or
/// less where bodies share a scaling, and lies about the origin: the single layer potential
/// is positive definite only on small outlines (doc/theory/operators.md), and a body far
/// from the origin shall not lose digits.  physical() and scaled() lead out and in.
class Outline {
 public:
  /// Holes are written counter-clockwise too; inside, they run clockwise: body on the
  /// left.
  /// \throws InputError naming the vertex or edge if a polygon has fewer than three
  ///   vertices (two with arcs), a bulge beyond 10 or not one for each edge, a zero or non-finite edge, is clockwise, touches or crosses itself or
  ///   another one, or if a hole does not lie inside the outer polygon.
  explicit Outline(const Loop& outer, const std::vector<Loop>& holes = {})
      : Outline(outer, holes, scalingOf(outer)) {}
  /// In a given scaling. \throws InputError, too, if the polygon is larger than its length.
  Outline(const Loop& outer, const std::vector<Loop>& holes, const Scaling& scaling);

  const std::vector<Edge>& edges() const { return edges_; }
  const Edge& edge(int e) const { return edges_[e]; }
  int loops() const { return loops_; }

  /// Diameter of the outer polygon, in the user's unit of length.
  double diameter() const { return diameter_; }
  const Scaling& scaling() const { return scaling_; }
  /// Of everything that is computed in this scaling with this reference stress.
  Units units(double stress) const { return {scaling_.length, stress}; }

  Vec2 physical(Vec2 scaled) const { return scaling_.origin + scaling_.length * scaled; }
  Vec2 scaled(Vec2 physical) const {
    return (1 / scaling_.length) * (physical - scaling_.origin);
  }

  /// Is a (physical) point inside the body, off its boundary?
  bool contains(Vec2 physical) const;

 private:
  std::vector<Edge> edges_;
  int loops_ = 0;
  double diameter_ = 1;
  Scaling scaling_;
};

}  // namespace epafi::bem
