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

}  // namespace epafi::bem
