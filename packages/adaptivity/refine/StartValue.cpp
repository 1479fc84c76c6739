#include "adaptivity/refine/StartValue.hpp"

#include "bem/base/Error.hpp"
#include "bem/quadrature/Gauss.hpp"

namespace epafi::adaptivity {

namespace {

using contact::Index;
using contact::MultiplierSpace;
using contact::Vector;
using ContactElement = MultiplierSpace::ContactElement;

/// A multiplier at places of an edge, asked for in increasing order.
class Walk {
 public:
  Walk(const bem::Mesh& mesh, const MultiplierSpace& space, const Vector& multiplier)
      : mesh_(mesh), space_(space), multiplier_(multiplier) {}

  MultiplierSpace::Value at(int edge, bem::Position position) {
    while (!holds(edge, position))
      ++next_;
    const ContactElement& element = space_.elements()[next_];
    const bem::Element& geometry = mesh_[element.element];
    const double half = geometry.half;
    const double before = distanceAlong(geometry.piece.start, position) / half;
    const double behind = distanceAlong(position, geometry.piece.end) / half;
    if (before < -tolerance)
      throwMismatch();
    return space_.at(multiplier_, element, before < behind ? before - 1 : 1 - behind);
  }

 private:
  // of half an element; rounding of places may be a part of tiny ones
  static constexpr double tolerance = 1e-3;

  bool holds(int edge, bem::Position position) const {
    if (next_ == space_.elements().size())
      throwMismatch();
    const bem::Piece& piece = mesh_[space_.elements()[next_].element].piece;
    return piece.edge == edge && distanceAlong(position, piece.end) >= 0;
  }

  [[noreturn]] static void throwMismatch() {
    throw bem::NumericalError("the multiplier's two meshes differ in where contact is");
  }

  const bem::Mesh& mesh_;
  const MultiplierSpace& space_;
  const Vector& multiplier_;
  std::size_t next_ = 0;
};

}  // namespace

Vector carryMultiplier(const bem::Mesh& fromMesh, const MultiplierSpace& from,
                       const Vector& multiplier, const bem::Mesh& toMesh,
                       const MultiplierSpace& to) {
  Walk walk(fromMesh, from, multiplier);
  // element by element; where two elements share a coefficient, it is their mean
  Vector sums(to.size());
  std::vector<int> counts(sums.size());
  const auto add = [&](const Vector& coefficients, const contact::Coefficients& own) {
    for (int i = 0; i <= own.degree; ++i)
      if (own.isOwn(i)) {
        sums[own.number(i)] += coefficients[i];
        ++counts[own.number(i)];
      }
  };
  for (const ContactElement& element : to.elements()) {
    const bem::Piece& piece = toMesh[element.element].piece;
    const Vector& places = bem::gaussLegendre(element.degree + 1).points;
    const bem::LuFactor interpolation = contact::interpolation(to.basis(), places);
    Vector normal;
    Vector tangential;
    for (const double t : places) {
      const auto value = walk.at(piece.edge, positionAt(piece, t));
      normal.push_back(value.normal);
      tangential.push_back(value.tangential);
    }
    interpolation.solve(normal);
    interpolation.solve(tangential);
    add(normal, element.normal);
    if (element.shears())
      add(tangential, element.tangential);
  }
  for (std::size_t k = 0; k < sums.size(); ++k)
    sums[k] /= counts[k];
  return sums;
}

contact::State carry(const bem::Mesh& from, const MultiplierSpace& multiplier,
                     const contact::State& state, const bem::Mesh& to,
                     const contact::Conditions& conditions) {
  if (state.multiplier.empty())
    return state;
  return {carryMultiplier(from, multiplier, state.multiplier, to,
                          MultiplierSpace(to, multiplier.basis(), conditions)),
          state.rigid};
}

}  // namespace epafi::adaptivity
