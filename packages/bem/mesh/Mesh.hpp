#pragma once

#include "bem/base/Function.hpp"
#include "bem/geometry/Outline.hpp"

#include <memory>
#include <vector>

namespace epafi::bem {

/// A part of an edge and the polynomial degree on it, from which a mesh makes an element.
struct Piece {
  int edge = 0;
  Position start;
  Position end;
  int degree = 1;
};

/// The point t in [-1, 1] of a piece, accurate relative to both ends of the edge.
Position positionAt(const Piece& piece, double t);

/// A boundary element: a part of an edge's curve, y(t), -1 <= t <= 1.
struct Element {
  Piece piece;
  int startNode = 0;
  int endNode = 0;
  int previous = 0;  ///< element that ends at startNode
  int next = 0;
  Curve curve;
  double half = 0;  ///< half its length, |dy/dt|
  int degree = 1;   ///< p: displacements of degree p
  int densities =
      1;  ///< number of Legendre terms of a density: p, or more; 0: on the axis

  /// The frame of a straight element, see Curve::segment.
  const Curve::Frame& segment() const { return curve.segment(); }
};

/// A point of the boundary at arc length `offset` from a nearby position, usually a node.
/// Differences of two points are accurate near a common vertex and near a common node.
struct BoundaryPoint {
  int edge = 0;
  Position position;
  double offset = 0;
};

/// Division of the boundary into elements, each with its own degree.  Immutable.
///
/// Elements on an axis of revolution (Outline::isAxis) have degree 1 and no densities: they close
/// the outline, and nothing is integrated over them.
class Mesh {
 public:
  /// \param pieces in the order of the edges of the outline; they cover each edge
  /// \throws InputError if they leave a gap or have another order, or for a degree below 1 or
  /// above 25
  Mesh(std::shared_ptr<const Outline> outline, const std::vector<Piece>& pieces);

  /// The same elements with Element::densities = densities[e], but those on the axis.
  /// \throws InputError if densities[e] is less than the degree of e or more than 25
  Mesh withDensities(const std::vector<int>& densities) const;

  /// The same elements with degree = densities, for code that treats densities and
  /// derivatives of displacements alike.
  Mesh withDegreesOfDensities() const;

  const Outline& outline() const { return *outline_; }
  std::shared_ptr<const Outline> sharedOutline() const { return outline_; }

  int size() const { return static_cast<int>(elements_.size()); }
  const std::vector<Element>& elements() const { return elements_; }
  const Element& operator[](int e) const { return elements_[e]; }

  const std::string& boundary(int e) const {
    return outline_->edge((*this)[e].piece.edge).boundary;
  }
  /// Elements of a named boundary, in the direction of the outline.
  std::vector<int> elementsOf(const std::string& boundary) const;

  /// Elements of an edge of the outline, from its start to its end: first, ..., last.
  struct OnEdge {
    int first = -1;
    int last = -1;
  };
  const OnEdge& onEdge(int edge) const { return onEdges_[edge]; }

  /// Number of the straight edge of e; -1 if e is an arc.
  int lineOf(int e) const { return outline_->lineOf((*this)[e].piece.edge); }
  bool hasArcs() const;
  /// Are both elements on one straight edge?
  bool areOnLine(int e, int f) const { return lineOf(e) >= 0 && lineOf(e) == lineOf(f); }

  BoundaryPoint at(int e, double t) const { return at(e, 1 + t, 1 - t); }
  /// The point with 1 + t = fromStart, 1 - t = toEnd, anchored at the nearer end of e.
  BoundaryPoint at(int e, double fromStart, double toEnd) const;
  Vec2 scaledPoint(int e, double t) const;
  /// |dy/dt|, times 2π r where the body is a solid of revolution: integrals over the surface of the
  /// body are those of measure(e, t) dt.
  double measure(int e, double t) const {
    return outline_->isAxisymmetric() ? ofRevolution(e, t) : (*this)[e].half;
  }
  bool isAxis(int e) const { return outline_->isAxis((*this)[e].piece.edge); }
  /// In the user's coordinates, with the normal of e.
  SurfacePoint physicalPoint(int e, double t) const;

  /// x - y, without the cancellation of a difference of coordinates.
  Vec2 difference(const BoundaryPoint& x, const BoundaryPoint& y) const;
  /// From this distance on (in outline diameters) differences of coordinates are accurate to
  /// 2e-15, relative.
  static constexpr double plainDistance = 0.1;
  /// Midpoint of e minus midpoint of f; offset(f, e) = -offset(e, f) exactly.
  Vec2 offset(int e, int f) const;

 private:
  double ofRevolution(int e, double t) const;

  std::shared_ptr<const Outline> outline_;
  std::vector<Element> elements_;
  std::vector<OnEdge> onEdges_;
};

/// Divides edge k of the outline into elementsPerEdge[k] elements of equal length and degree.
Mesh makeMesh(std::shared_ptr<const Outline> outline,
              const std::vector<int>& elementsPerEdge, int degree);

}  // namespace epafi::bem
