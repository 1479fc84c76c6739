#include "adaptivity/refine/StartValue.hpp"

#include "bem/base/Error.hpp"
#include "bem/quadrature/Gauss.hpp"

namespace epafi::adaptivity {

namespace {

using contact::at;
using contact::MultiplierSpace;
using contact::Vector;
using ContactElement = MultiplierSpace::ContactElement;

/// The multiplier on a body at places of an edge, asked for in increasing order.
class Walk {
 public:
  Walk(const MultiplierSpace& space, std::size_t body, const Vector& multiplier)
      : space_(space), elements_(space.elements(body)), multiplier_(multiplier) {}

  MultiplierSpace::Value at(int edge, bem::Position position) {
    while (!holds(edge, position))
      ++next_;
    const ContactElement& element = elements_[next_];
    const bem::Element& geometry = element.geometry();
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
    if (next_ == elements_.size())
      throwMismatch();
    const bem::Piece& piece = elements_[next_].geometry().piece;
    return piece.edge == edge && distanceAlong(position, piece.end) >= 0;
  }

  [[noreturn]] static void throwMismatch() {
    throw bem::NumericalError("the multiplier's two meshes differ in where contact is");
  }

  const MultiplierSpace& space_;
  const std::vector<ContactElement>& elements_;
  const Vector& multiplier_;
  std::size_t next_ = 0;
};

}  // namespace

Vector carryMultiplier(const MultiplierSpace& from, const Vector& multiplier,
                       const MultiplierSpace& to) {
  // element by element; where two elements share a coefficient, it is their mean
  Vector sums(at(to.size()));
  std::vector<int> counts(sums.size());
  const auto add = [&](const Vector& coefficients, const contact::Coefficients& own) {
    for (int i = 0; i <= own.degree; ++i)
      if (own.isOwn(i)) {
        sums[at(own.number(i))] += coefficients[at(i)];
        ++counts[at(own.number(i))];
      }
  };
  for (std::size_t b = 0; b < to.bodies(); ++b) {
    Walk walk(from, b, multiplier);
    for (const ContactElement& element : to.elements(b)) {
      const bem::Piece& piece = element.geometry().piece;
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
  }
  for (std::size_t k = 0; k < sums.size(); ++k)
    sums[k] /= counts[k];
  return sums;
}

contact::State carry(const MultiplierSpace& from, const contact::State& state,
                     const MultiplierSpace& to) {
  if (state.multiplier.empty())
    return state;
  return {carryMultiplier(from, state.multiplier, to), state.rigid};
}

}  // namespace epafi::adaptivity
