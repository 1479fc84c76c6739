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

SeenPoints::SeenPoints(const Mesh& mesh, int element, int source,
                       const std::vector<EndPoint>& points)
    : mesh_(mesh), element_(element), source_(source), points_(points) {
  const Element& x = mesh[element];
  const Element& y = mesh[source];
  if (!x.curve.isStraight() || !y.curve.isStraight())
    return;
  const Vec2 direction = x.curve.frame().tangent;
  const Curve::Frame& frame = y.curve.frame();
  sight_ = {seenFrom(mesh, source, mesh.at(element, -1)),
            seenFrom(mesh, source, mesh.at(element, 1)),
            x.half / y.half *
                Complex(dot(direction, frame.tangent),
                        areOnLine() ? 0.0 : dot(direction, frame.normal))};
}

RelativeTarget SeenPoints::operator[](std::size_t i) const {
  const EndPoint& point = points_[std::min(i, points_.size() - 1)];
  return seenFrom(mesh_, source_, mesh_.at(element_, point.fromStart, point.toEnd));
}

}  // namespace epafi::bem
