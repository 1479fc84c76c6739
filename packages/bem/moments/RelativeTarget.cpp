#include "bem/moments/RelativeTarget.hpp"

#include <algorithm>

namespace epafi::bem {

RelativeTarget seenFrom(const Mesh& mesh, int e, const BoundaryPoint& x) {
  const Piece& piece = mesh[e].piece;
  RelativeTarget target =
      mesh[e].curve.seen(mesh.difference(x, {piece.edge, piece.start, 0}),
                         mesh.difference(x, {piece.edge, piece.end, 0}));
  if (x.edge == piece.edge) {
    target.zMinus1.imag(0.0);
    target.zPlus1.imag(0.0);
  }
  return target;
}

void appendEnds(const Mesh& mesh, int element, int source,
                std::vector<Feature>& features) {
  const Piece& piece = mesh[source].piece;
  for (const Position& end : {piece.start, piece.end}) {
    const RelativeTarget seen = seenFrom(mesh, element, {piece.edge, end, 0});
    features.push_back({seen.z().real(), std::abs(seen.b())});
  }
}

namespace {

/// A segment relative to a segment: z is linear along it.
class SegmentSeen {
 public:
  SegmentSeen(const Mesh& mesh, int source, int element)
      : start_(seenFrom(mesh, source, mesh.at(element, -1))),
        end_(seenFrom(mesh, source, mesh.at(element, 1))) {
    const Element& x = mesh[element];
    const Curve::Frame& y = mesh[source].curve.frame();
    const Vec2 direction = x.curve.frame().tangent;
    const bool isOnEdge = x.piece.edge == mesh[source].piece.edge;
    step_ = x.half / mesh[source].half *
            Complex(dot(direction, y.tangent), isOnEdge ? 0.0 : dot(direction, y.normal));
  }

  /// At distances [half lengths] from its ends, counted from the nearer one.
  TargetLanes at(const Pack& fromStart, const Pack& toEnd) const {
    const Pack zero{};
    const auto atStart = fromStart < toEnd;
    const Pack along = atStart ? fromStart : -toEnd;
    const auto from = [&](const Complex& start, const Complex& end) -> ComplexPack {
      return {(atStart ? zero + start.real() : zero + end.real()) + step_.real() * along,
              (atStart ? zero + start.imag() : zero + end.imag()) + step_.imag() * along};
    };
    return {from(start_.zMinus1, end_.zMinus1), from(start_.zPlus1, end_.zPlus1)};
  }

 private:
  RelativeTarget start_;
  RelativeTarget end_;
  Complex step_;
};

}  // namespace

std::vector<TargetLanes> seenFrom(const Mesh& mesh, int source, int element,
                                  const std::vector<EndPoint>& points) {
  std::vector<TargetLanes> all;
  all.reserve((points.size() + lanes - 1) / lanes);
  const auto point = [&](std::size_t i) -> const EndPoint& {
    return points[std::min(i, points.size() - 1)];
  };
  if (mesh.lineOf(source) >= 0 && mesh.lineOf(element) >= 0) {
    const SegmentSeen segment(mesh, source, element);
    for (std::size_t first = 0; first < points.size(); first += lanes) {
      AlignedLane starts;
      AlignedLane ends;
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        starts.lane[lane] = point(first + lane).fromStart;
        ends.lane[lane] = point(first + lane).toEnd;
      }
      all.push_back(segment.at(load(starts.lane), load(ends.lane)));
    }
  } else {
    RelativeTarget targets[lanes];
    for (std::size_t first = 0; first < points.size(); first += lanes) {
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const EndPoint& x = point(first + lane);
        targets[lane] = seenFrom(mesh, source, mesh.at(element, x.fromStart, x.toEnd));
      }
      all.emplace_back(targets);
    }
  }
  for (TargetLanes& of : all)
    of.isOnEdge = mesh[element].piece.edge == mesh[source].piece.edge;
  return all;
}

}  // namespace epafi::bem
