#pragma once

#include "bem/mesh/Mesh.hpp"
#include "bem/quadrature/Graded.hpp"
#include "bem/simd/ComplexPack.hpp"

namespace epafi::bem {

/// A boundary point relative to element e, accurate near a common vertex; b = 0 exactly if it
/// is on the edge of e.
RelativeTarget seenFrom(const Mesh& mesh, int e, const BoundaryPoint& x);

/// Appends the end points of element `source` as features of a rule on `element`.
void appendEnds(const Mesh& mesh, int element, int source,
                std::vector<Feature>& features);

/// Eight targets z = a + ib as in RelativeTarget.
struct alignas(64) TargetLanes {
  Pack z;
  Pack minus;  ///< a - 1
  Pack plus;   ///< a + 1
  Pack b;
  bool isOnEdge = false;  ///< all are on the edge of the source: b = 0 exactly

  EPAFI_INLINE explicit TargetLanes(const RelativeTarget (&targets)[lanes])
      : isOnEdge(true) {
    for (int lane = 0; lane < lanes; ++lane) {
      isOnEdge = isOnEdge && targets[lane].b() == 0;
      z[lane] = targets[lane].z().real();
      minus[lane] = targets[lane].zMinus1.real();
      plus[lane] = targets[lane].zPlus1.real();
      b[lane] = targets[lane].b();
    }
  }

  /// Points (x, y) relative to a segment.
  EPAFI_INLINE TargetLanes(const Curve& segment, const Pack& x, const Pack& y) {
    const Vec2 along = (1 / segment.half()) * segment.frame().tangent;
    const Vec2 across = (1 / segment.half()) * segment.frame().normal;
    const Pack fromStartX = x - segment.from().x;
    const Pack fromStartY = y - segment.from().y;
    const Pack fromEndX = x - segment.to().x;
    const Pack fromEndY = y - segment.to().y;
    takeNearer({fromEndX * along.x + fromEndY * along.y,
                fromEndX * across.x + fromEndY * across.y},
               {fromStartX * along.x + fromStartY * along.y,
                fromStartX * across.x + fromStartY * across.y});
  }

  /// z - 1 and z + 1, of which the smaller is accurate.
  EPAFI_INLINE TargetLanes(const ComplexPack& zMinus1, const ComplexPack& zPlus1) {
    takeNearer(zMinus1, zPlus1);
  }

  EPAFI_INLINE ComplexPack complex() const { return {z, b}; }

 private:
  /// Computes z and the offset to the farther end from the offset to the nearer end.
  EPAFI_INLINE void takeNearer(const ComplexPack& zMinus1, const ComplexPack& zPlus1) {
    Pack squareOfMinus;
    Pack squareOfPlus;
    squareOf(zMinus1, squareOfMinus);
    squareOf(zPlus1, squareOfPlus);
    const auto atOne = squareOfMinus < squareOfPlus;
    z = atOne ? 1.0 + zMinus1.re : zPlus1.re - 1.0;
    minus = atOne ? zMinus1.re : zPlus1.re - 2.0;
    plus = atOne ? zMinus1.re + 2.0 : zPlus1.re;
    b = atOne ? zMinus1.im : zPlus1.im;
  }
};

/// Points of `element` relative to element `source`, eight at a time; the last one is repeated.
/// Refers to the mesh and the points.
class SeenPoints {
 public:
  SeenPoints(const Mesh& mesh, int source, int element,
             const std::vector<EndPoint>& points);

  /// Number of eights.
  std::size_t size() const { return (points_.size() + lanes - 1) / lanes; }
  /// Are all on the edge of the source: b = 0 exactly?
  bool areOnEdge() const {
    return mesh_[element_].piece.edge == mesh_[source_].piece.edge;
  }
  /// Points 8k, 8k + 1, ...
  EPAFI_INLINE TargetLanes at(std::size_t k) const {
    const std::size_t first = k * lanes;
    const std::size_t last = points_.size() - 1;
    if (areStraight_) {
      AlignedLane starts;
      AlignedLane ends;
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const EndPoint& point = points_[first + lane < last ? first + lane : last];
        starts.lane[lane] = point.fromStart;
        ends.lane[lane] = point.toEnd;
      }
      return alongSegment(load(starts.lane), load(ends.lane));
    }
    RelativeTarget targets[lanes];
    for (std::size_t lane = 0; lane < lanes; ++lane)
      targets[lane] = (*this)[first + lane < last ? first + lane : last];
    return TargetLanes(targets);
  }

 private:
  RelativeTarget operator[](std::size_t i) const;
  /// On a segment z is linear.  At distances [half lengths] from its ends, counted from the
  /// nearer one.
  EPAFI_INLINE TargetLanes alongSegment(const Pack& fromStart, const Pack& toEnd) const {
    const Pack zero{};
    const auto atStart = fromStart < toEnd;
    const Pack along = atStart ? fromStart : -toEnd;
    const ComplexPack step{step_.real() * along, step_.imag() * along};
    TargetLanes targets(
        step + ComplexPack{atStart ? zero + start_.zMinus1.real()
                                   : zero + end_.zMinus1.real(),
                           atStart ? zero + start_.b() : zero + end_.b()},
        step + ComplexPack{
                   atStart ? zero + start_.zPlus1.real() : zero + end_.zPlus1.real(),
                   atStart ? zero + start_.zPlus1.imag() : zero + end_.zPlus1.imag()});
    targets.isOnEdge = areOnEdge();
    return targets;
  }

  const Mesh& mesh_;
  int source_;
  int element_;
  const std::vector<EndPoint>& points_;
  bool areStraight_;      ///< both elements
  RelativeTarget start_;  ///< the ends of a segment, and the change of z along half of it
  RelativeTarget end_;
  Complex step_;
};

}  // namespace epafi::bem
