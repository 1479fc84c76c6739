#pragma once

#include "bem/geometry/Curve.hpp"

#include <string>
#include <vector>

namespace epafi::bem {

/// A closed polygon as the user writes it: counter-clockwise, edge i from vertex i to
/// i+1.
struct Loop {
  std::vector<Vec2> vertices;
  std::vector<std::string> edges;  ///< the boundary's name for each edge
};

/// A piece of the outline, in the outline's own units (see Outline).
struct Edge {
  Curve curve;  ///< the body lies to its left
  int loop = 0;
  int previous = 0;  ///< the edge that ends where this one starts
  int next = 0;
  std::string boundary;
};

/// The boundary of a body: one outer polygon and any number of holes.
///
/// Coordinates are scaled and shifted so that the outer polygon has diameter 1 and lies
/// about the origin: the single layer potential is positive definite only on small
/// outlines (doc/notation.md), and a body far from the origin shall not lose digits.
/// physical() and scaled() lead out and in.
class Outline {
 public:
  /// Holes are written counter-clockwise too; inside, they run clockwise: body on the
  /// left.
  /// \throws InputError naming the vertex or edge if a polygon has fewer than three
  ///   vertices, a zero or non-finite edge, is clockwise, touches or crosses itself or
  ///   another one, or if a hole does not lie inside the outer polygon.
  explicit Outline(const Loop& outer, const std::vector<Loop>& holes = {});

  const std::vector<Edge>& edges() const { return edges_; }
  const Edge& edge(int e) const { return edges_[static_cast<std::size_t>(e)]; }
  int loops() const { return loops_; }

  /// Diameter of the outer polygon, in the user's unit of length.
  double diameter() const { return diameter_; }

  Vec2 physical(Vec2 scaled) const { return origin_ + diameter_ * scaled; }
  Vec2 scaled(Vec2 physical) const { return (1 / diameter_) * (physical - origin_); }

  /// Is a (physical) point inside the body, off its boundary?
  bool contains(Vec2 physical) const;

 private:
  std::vector<Edge> edges_;
  int loops_ = 0;
  double diameter_ = 1;
  Vec2 origin_;
};

}  // namespace epafi::bem
