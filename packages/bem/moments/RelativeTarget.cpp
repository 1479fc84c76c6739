#include "bem/moments/RelativeTarget.hpp"

namespace epafi::bem {

namespace {

RelativeTarget fromOffsets(const Element& element, Vec2 toStart, Vec2 toEnd) {
  const auto local = [&](Vec2 offset) {
    return Complex(dot(offset, element.tangent), dot(offset, element.normal)) /
           element.half;
  };
  const Complex plus = local(toStart);
  const Complex minus = local(toEnd);
  return std::norm(minus) < std::norm(plus) ? RelativeTarget{minus, minus + 2.0}
                                            : RelativeTarget{plus - 2.0, plus};
}

}  // namespace

RelativeTarget seenFrom(const Mesh& mesh, int e, const BoundaryPoint& x) {
  const Element& element = mesh[e];
  const int edge = element.piece.edge;
  RelativeTarget target =
      fromOffsets(element, mesh.difference(x, {edge, element.piece.start, 0}),
                  mesh.difference(x, {edge, element.piece.end, 0}));
  if (x.edge == edge) {
    target.zMinus1.imag(0.0);
    target.zPlus1.imag(0.0);
  }
  return target;
}

RelativeTarget seenFrom(const Element& element, Vec2 x) {
  const Vec2 half = element.half * element.tangent;
  return fromOffsets(element, x - (element.middle - half), x - (element.middle + half));
}

}  // namespace epafi::bem
