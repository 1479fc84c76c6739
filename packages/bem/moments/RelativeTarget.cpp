#include "bem/moments/RelativeTarget.hpp"

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

SeenPoints::SeenPoints(const Mesh& mesh, int source, int element,
                       const std::vector<EndPoint>& points)
    : mesh_(mesh),
      source_(source),
      element_(element),
      points_(points),
      areStraight_(mesh.lineOf(source) >= 0 && mesh.lineOf(element) >= 0) {
  if (!areStraight_)
    return;
  start_ = seenFrom(mesh, source, mesh.at(element, -1));
  end_ = seenFrom(mesh, source, mesh.at(element, 1));
  const Vec2 direction = mesh[element].curve.frame().tangent;
  const Curve::Frame& y = mesh[source].curve.frame();
  step_ =
      mesh[element].half / mesh[source].half *
      Complex(dot(direction, y.tangent), areOnEdge() ? 0.0 : dot(direction, y.normal));
}

RelativeTarget SeenPoints::operator[](std::size_t i) const {
  return seenFrom(mesh_, source_,
                  mesh_.at(element_, points_[i].fromStart, points_[i].toEnd));
}

}  // namespace epafi::bem
