#include "adaptivity/refine/Refine.hpp"

#include "bem/algebra/Blas.hpp"
#include "bem/base/Error.hpp"
#include "bem/quadrature/Gauss.hpp"

#include <algorithm>
#include <cassert>

namespace epafi::adaptivity {

namespace {

using contact::Index;
using contact::MultiplierBasis;
using contact::MultiplierSpace;
using contact::Vector;

/// Where a new element lies in the old mesh: its t in [-1, 1] is middle + scale t there.
struct Origin {
  int element = 0;
  double middle = 0;
  double scale = 1;
};

struct Pieces {
  std::vector<bem::Piece> pieces;
  std::vector<Origin> origins;
};

/// The place t of an element, as accurate from both ends of its edge as the element's
/// own.
bem::Position positionAt(const bem::Piece& piece, double t) {
  const double f = 0.5 * (1 + t);
  const bem::Position& a = piece.start;
  const bem::Position& b = piece.end;
  return {a.fromStart + f * (b.fromStart - a.fromStart),
          b.toEnd + (1 - f) * (a.toEnd - b.toEnd)};
}

void cutAt(const bem::Piece& piece, int element, const std::vector<double>& places,
           const std::vector<int>& degrees, Pieces& result) {
  assert(degrees.size() == places.size() + 1);
  bem::Position start = piece.start;
  double from = -1;
  for (std::size_t k = 0; k < degrees.size(); ++k) {
    const bool last = k == places.size();
    const double to = last ? 1 : places[k];
    const bem::Position end = last ? piece.end : positionAt(piece, to);
    result.pieces.push_back({piece.edge, start, end, degrees[k]});
    result.origins.push_back({element, 0.5 * (from + to), 0.5 * (to - from)});
    start = end;
    from = to;
  }
}

Pieces cut(const bem::Mesh& mesh, const Marks& marks) {
  assert(static_cast<int>(marks.size()) == mesh.size());
  Pieces result;
  for (int e = 0; e < mesh.size(); ++e) {
    const bem::Piece piece = mesh[e].piece;
    const Mark& mark = marks[static_cast<std::size_t>(e)];
    const int p = piece.degree;
    switch (mark.kind()) {
      case Mark::None:
        cutAt(piece, e, {}, {p}, result);
        break;
      case Mark::RaiseDegree:
        cutAt(piece, e, {}, {p + 1}, result);
        break;
      case Mark::Bisect:
        cutAt(piece, e, {0}, {p, p}, result);
        break;
      case Mark::Cut:
        cutAt(piece, e, mark.places(), mark.degrees(), result);
        break;
    }
  }
  return result;
}

/// Coefficients of polynomials of one degree from their values at the Gauss points.
class Collocation {
 public:
  Collocation(const MultiplierBasis& basis, int degree)
      : points_(bem::gaussLegendre(degree + 1).points), matrix_(size(), size()) {
    for (Index i = 0; i < size(); ++i) {
      const Vector row = basis.values(degree, points_[static_cast<std::size_t>(i)]);
      for (Index k = 0; k < size(); ++k)
        matrix_(i, k) = row[static_cast<std::size_t>(k)];
    }
  }

  const Vector& points() const { return points_; }

  Vector coefficients(Vector values) const {
    bem::Matrix factor = matrix_.copy();
    const int n = static_cast<int>(size());
    const int stride = static_cast<int>(factor.stride());
    const int one = 1;
    std::vector<int> pivots(points_.size());
    int info = 0;
    dgesv_(&n, &one, factor.data(), &stride, pivots.data(), values.data(), &n, &info);
    if (info != 0)
      throw bem::NumericalError("the multiplier's basis is linearly dependent");
    return values;
  }

 private:
  Index size() const { return static_cast<Index>(points_.size()); }

  Vector points_;
  bem::Matrix matrix_;
};

/// Coefficients element by element; where two elements share one, it is their mean.
class Collection {
 public:
  explicit Collection(Index size)
      : sums_(static_cast<std::size_t>(size)), counts_(static_cast<std::size_t>(size)) {}

  template <class Number>
  void add(const Vector& coefficients, contact::EndCoefficients ends,
           const Number& number) {
    const int degree = static_cast<int>(coefficients.size()) - 1;
    for (int i = 0; i <= degree; ++i) {
      if (!MultiplierSpace::ContactElement::isOwn(ends, degree, i))
        continue;
      const auto k = static_cast<std::size_t>(number(i));
      sums_[k] += coefficients[static_cast<std::size_t>(i)];
      ++counts_[k];
    }
  }

  Vector means() const {
    Vector means = sums_;
    for (std::size_t k = 0; k < means.size(); ++k)
      means[k] /= counts_[k];
    return means;
  }

 private:
  Vector sums_;
  std::vector<int> counts_;
};

/// The old multiplier as a function on the new elements, in the new coefficients.
Vector carry(const MultiplierSpace& from, const Vector& old, const MultiplierSpace& to,
             const std::vector<Origin>& origins) {
  Collection result(to.size());
  for (const MultiplierSpace::ContactElement& element : to.elements()) {
    const Origin& origin = origins[static_cast<std::size_t>(element.element)];
    const auto source = std::find_if(
        from.elements().begin(), from.elements().end(),
        [&](const auto& candidate) { return candidate.element == origin.element; });
    assert(source != from.elements().end());
    const Collocation collocation(to.basis(), element.degree);
    Vector normal;
    Vector tangential;
    for (const double t : collocation.points()) {
      const auto value = from.at(old, *source, origin.middle + origin.scale * t);
      normal.push_back(value.normal);
      tangential.push_back(value.tangential);
    }
    result.add(collocation.coefficients(normal), element.normalEnds,
               [&](int i) { return element.normalOf(i); });
    if (element.tangential >= 0)
      result.add(collocation.coefficients(tangential), element.tangentialEnds,
                 [&](int i) { return element.tangentialOf(i); });
  }
  return result.means();
}

}  // namespace

Mark Mark::cut(std::vector<double> places, std::vector<int> degrees) {
  Mark mark(Cut);
  mark.places_ = std::move(places);
  mark.degrees_ = std::move(degrees);
  return mark;
}

bool anyMarked(const Marks& marks) {
  return std::any_of(marks.begin(), marks.end(),
                     [](const Mark& mark) { return mark != Mark::None; });
}

bem::Mesh refine(const bem::Mesh& mesh, const Marks& marks) {
  return {mesh.sharedOutline(), cut(mesh, marks).pieces};
}

Refined refine(const bem::Mesh& mesh, const Marks& marks,
               const MultiplierSpace& multiplier, const contact::Conditions& conditions,
               const contact::State& state) {
  const Pieces next = cut(mesh, marks);
  Refined result{{mesh.sharedOutline(), next.pieces}, {}};
  result.start.rigid = state.rigid;
  if (!state.multiplier.empty())
    result.start.multiplier =
        carry(multiplier, state.multiplier,
              MultiplierSpace(result.mesh, multiplier.basis(), conditions), next.origins);
  return result;
}

}  // namespace epafi::adaptivity
