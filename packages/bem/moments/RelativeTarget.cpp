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

Sight sightOf(const Mesh& mesh, int outer, int inner) {
  const Element& x = mesh[outer];
  const Element& y = mesh[inner];
  const double ratio = x.half / y.half;
  const bool onLine = x.piece.edge == y.piece.edge;
  const Vec2 direction = x.curve.frame().tangent;
  const Curve::Frame& frame = y.curve.frame();
  return {seenFrom(mesh, inner, mesh.at(outer, -1)),
          seenFrom(mesh, inner, mesh.at(outer, 1)),
          onLine && !y.curve.isStraight()  // by arc length
              ? ratio
              : ratio * Complex(dot(direction, frame.tangent),
                                onLine ? 0.0 : dot(direction, frame.normal))};
}

}  // namespace epafi::bem
