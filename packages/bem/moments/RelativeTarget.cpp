#include "bem/moments/RelativeTarget.hpp"

#include "bem/simd/Dispatch.hpp"

#include <algorithm>

namespace epafi::bem {

namespace {

/// Points of a segment relative to another one: z is linear, counted from the nearer end.
struct AlongSegment {
  const std::vector<EndPoint>& points;
  RelativeTarget start;
  RelativeTarget end;
  Complex step;  ///< change of z along half of the segment
  TargetLanes* to;

  template <Division>
  EPAFI_INLINE void run() const {
    const std::size_t last = points.size() - 1;
    for (std::size_t first = 0; first <= last; first += lanes) {
      AlignedLane starts{};
      AlignedLane ends{};
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const EndPoint& point = points[std::min(first + lane, last)];
        starts.lane[lane] = point.fromStart;
        ends.lane[lane] = point.toEnd;
      }
      to[first / lanes] = at(load(starts.lane), load(ends.lane));
    }
  }

 private:
  EPAFI_INLINE TargetLanes at(const Pack& fromStart, const Pack& toEnd) const {
    const Pack zero{};
    const auto atStart = fromStart < toEnd;
    const Pack along = atStart ? fromStart : -toEnd;
    const ComplexPack moved{step.real() * along, step.imag() * along};
    const auto from = [&](const Complex& ofStart, const Complex& ofEnd) -> ComplexPack {
      return {atStart ? zero + ofStart.real() : zero + ofEnd.real(),
              atStart ? zero + ofStart.imag() : zero + ofEnd.imag()};
    };
    return targetAt(moved + from(start.zMinus1, end.zMinus1),
                    moved + from(start.zPlus1, end.zPlus1));
  }
};

struct BesideSegment {
  const Curve& segment;
  const AlignedLane& x;
  const AlignedLane& y;
  TargetLanes& to;

  template <Division>
  EPAFI_INLINE void run() const {
    const Complex scale = std::conj(asComplex(segment.frame().tangent)) / segment.half();
    const auto from = [&](Vec2 end) -> ComplexPack {
      // conj(w conj(τ)) has b > 0 on the side of the normal
      return conj(scale * ComplexPack{load(x.lane) - end.x, load(y.lane) - end.y});
    };
    to = targetAt(from(segment.to()), from(segment.from()));
  }
};

}  // namespace

RelativeTarget seenFrom(const Mesh& mesh, int e, const BoundaryPoint& x) {
  const Piece& piece = mesh[e].piece;
  const RelativeTarget target =
      mesh[e].curve.seen(mesh.difference(x, {piece.edge, piece.start, 0}),
                         mesh.difference(x, {piece.edge, piece.end, 0}));
  return x.edge == piece.edge ? targetAt(target.zMinus1.real(), target.zPlus1.real())
                              : target;
}

std::vector<TargetLanes> seenFrom(const Mesh& mesh, int source, int element,
                                  const std::vector<EndPoint>& points) {
  std::vector<TargetLanes> eights((points.size() + lanes - 1) / lanes);
  if (mesh.lineOf(source) >= 0 && mesh.lineOf(element) >= 0) {
    const Vec2 direction = mesh[element].curve.frame().tangent;
    const Curve::Frame& y = mesh[source].curve.frame();
    const bool areOnEdge = mesh[element].piece.edge == mesh[source].piece.edge;
    const Complex step =
        mesh[element].half / mesh[source].half *
        Complex(dot(direction, y.tangent), areOnEdge ? 0.0 : dot(direction, y.normal));
    dispatch(AlongSegment{points, seenFrom(mesh, source, mesh.at(element, -1)),
                          seenFrom(mesh, source, mesh.at(element, 1)), step,
                          eights.data()});
    return eights;
  }
  for (std::size_t k = 0; k < eights.size(); ++k) {
    RelativeTarget targets[lanes];
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const EndPoint& point = points[std::min(k * lanes + lane, points.size() - 1)];
      targets[lane] =
          seenFrom(mesh, source, mesh.at(element, point.fromStart, point.toEnd));
    }
    eights[k] = packed(targets);
  }
  return eights;
}

TargetLanes seenFrom(const Curve& segment, const AlignedLane& x, const AlignedLane& y) {
  TargetLanes result;
  dispatch(BesideSegment{segment, x, y, result});
  return result;
}

TargetLanes packed(const RelativeTarget (&targets)[lanes]) {
  TargetLanes result;
  for (int lane = 0; lane < lanes; ++lane) {
    const auto put = [lane](const Complex& from, ComplexPack& to) {
      to.re[lane] = from.real();
      to.im[lane] = from.imag();
    };
    put(targets[lane].z, result.z);
    put(targets[lane].zMinus1, result.zMinus1);
    put(targets[lane].zPlus1, result.zPlus1);
  }
  return result;
}

bool areOnLine(const TargetLanes& targets) {
  for (int lane = 0; lane < lanes; ++lane)
    if (targets.z.im[lane] != 0)
      return false;
  return true;
}

void appendEnds(const Mesh& mesh, int element, int source,
                std::vector<Feature>& features) {
  const Piece& piece = mesh[source].piece;
  for (const Position& end : {piece.start, piece.end}) {
    const RelativeTarget seen = seenFrom(mesh, element, {piece.edge, end, 0});
    features.push_back({seen.z.real(), std::abs(seen.b())});
  }
}

}  // namespace epafi::bem
