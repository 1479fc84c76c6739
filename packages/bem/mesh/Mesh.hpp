#pragma once

#include "bem/geometry/Outline.hpp"

#include <memory>
#include <vector>

namespace epafi::bem {

/// What a mesh is made of: a piece of an edge and the degree on it.
struct Piece {
  int edge = 0;
  Position start;
  Position end;
  int degree = 1;
};

/// The place t of [-1, 1] on a piece, as accurate from both ends of its edge as its own.
Position positionAt(const Piece& piece, double t);

/// A boundary element: a part of an edge's curve, y(t), -1 <= t <= 1.
struct Element {
  Piece piece;
  int startNode = 0;
  int endNode = 0;
  int previous = 0;  ///< element that ends at startNode
  int next = 0;
  Curve curve;
  double half = 0;    ///< half its length, |dy/dt|
  int degree = 1;     ///< p: displacements of degree p
  int densities = 1;  ///< functions of a density, P_0 ... : p of them, or more

  /// The frame of a straight element, see Curve::segment.
  const Curve::Frame& segment() const { return curve.segment(); }
};

/// A point of the boundary: `offset` along its edge from a nearby place, mostly a node.
/// Differences of two of them keep their digits near a common vertex and a common node.
struct BoundaryPoint {
  int edge = 0;
  Position position;
  double offset = 0;
};

/// The boundary cut into elements, each with its own degree.  Immutable.
class Mesh {
 public:
  /// Pieces in the order of the outline's edges, each edge covered without gaps.
  /// \throws InputError if they do not cover it or come in another order, or for a degree
  /// below 1 or above 25.
  Mesh(std::shared_ptr<const Outline> outline, const std::vector<Piece>& pieces);

  /// The same elements with so many functions of a density on each, at least its degree.
  /// \throws InputError for fewer, or more than 25.
  Mesh withDensities(const std::vector<int>& densities) const;

  /// The same elements with as high a degree as there are densities: for what treats
  /// densities and slopes of displacements alike.
  Mesh withDegreesOfDensities() const;

  const Outline& outline() const { return *outline_; }
  std::shared_ptr<const Outline> sharedOutline() const { return outline_; }

  int size() const { return static_cast<int>(elements_.size()); }
  const std::vector<Element>& elements() const { return elements_; }
  const Element& operator[](int e) const { return elements_[e]; }

  const std::string& boundary(int e) const {
    return outline_->edge((*this)[e].piece.edge).boundary;
  }
  /// Elements of a named boundary, in the outline's direction.
  std::vector<int> elementsOf(const std::string& boundary) const;

  BoundaryPoint at(int e, double t) const { return at(e, 1 + t, 1 - t); }
  /// The point with 1 + t = fromStart, 1 - t = toEnd, anchored at the nearer end of e.
  BoundaryPoint at(int e, double fromStart, double toEnd) const;
  Vec2 scaledPoint(int e, double t) const;
  /// In the user's coordinates.
  Vec2 physicalPoint(int e, double t) const;

  /// x - y, without the loss of digits that subtracting coordinates brings.
  Vec2 difference(const BoundaryPoint& x, const BoundaryPoint& y) const;
  /// From this distance on (in outline diameters) subtracting coordinates costs no digits
  /// that matter: 2e-15 of the difference.
  static constexpr double plainDistance = 0.1;
  /// The middle of e less that of f; exactly the opposite of what it is from f to e.
  Vec2 offset(int e, int f) const;

 private:
  std::shared_ptr<const Outline> outline_;
  std::vector<Element> elements_;
};

/// Cuts edge k of the outline into elementsPerEdge[k] equal elements of one degree.
Mesh makeMesh(std::shared_ptr<const Outline> outline,
              const std::vector<int>& elementsPerEdge, int degree);

}  // namespace epafi::bem
