#include "bem/mesh/Mesh.hpp"

#include "bem/base/Error.hpp"
#include "bem/basis/Legendre.hpp"

#include <cmath>

namespace epafi::bem {

Position positionAt(const Piece& piece, double t) {
  const double f = 0.5 * (1 + t);
  const Position& a = piece.start;
  const Position& b = piece.end;
  return {a.fromStart + f * (b.fromStart - a.fromStart),
          b.toEnd + (1 - f) * (a.toEnd - b.toEnd)};
}

namespace {

Vec2 place(const Edge& edge, const BoundaryPoint& p) {
  return edge.curve.point(p.position, p.offset);
}

Element makeElement(const Edge& edge, const Piece& piece) {
  Element element;
  element.piece = piece;
  element.degree = piece.degree;
  element.densities = piece.degree;
  element.curve = edge.curve.part(piece.start, piece.end);
  element.half = element.curve.half();
  return element;
}

void check(const Outline& outline, const Element& element) {
  const Piece& piece = element.piece;
  const std::string& name = outline.edge(piece.edge).boundary;
  if (!(element.half > 0))
    throw InputError("element of length ", 2 * element.half, " on boundary '", name,
                     "'; elements must have positive length");
  constexpr double halfACircle = 3.1415926535897932 * (1 + 1e-12);
  if (std::abs(element.curve.angle()) > halfACircle)
    throw InputError("an element of boundary '", name, "' turns by ",
                     std::abs(element.curve.angle()) * 180 / 3.1415926535897932,
                     " degrees; at most 180 are possible: use more elements");
  if (piece.degree < 1 || piece.degree > largestDegree)
    throw InputError("degree ", piece.degree, " on boundary '", name, "'; 1 to ",
                     largestDegree, " are possible");
}

}  // namespace

Mesh::Mesh(std::shared_ptr<const Outline> outline, const std::vector<Piece>& pieces)
    : outline_(std::move(outline)), onEdges_(outline_->edges().size()) {
  for (const Piece& piece : pieces) {
    const int e = size();
    if (e > 0 && piece.edge < pieces[e - 1].edge)
      throw InputError("the mesh goes back to edge ", piece.edge, " of boundary '",
                       outline_->edge(piece.edge).boundary,
                       "'; pieces come in the order of the edges");
    elements_.push_back(makeElement(outline_->edge(piece.edge), piece));
    check(*outline_, elements_.back());
    if (outline_->isAxis(piece.edge)) {
      elements_.back().piece.degree = elements_.back().degree = 1;
      elements_.back().densities = 0;
    }
    OnEdge& on = onEdges_[piece.edge];
    if (on.first < 0)
      on.first = e;
    else if (on.last != e - 1 || pieces[e - 1].end.fromStart != piece.start.fromStart)
      throw InputError("the mesh leaves a gap on boundary '",
                       outline_->edge(piece.edge).boundary, "'");
    on.last = e;
  }
  for (std::size_t k = 0; k < onEdges_.size(); ++k)
    if (onEdges_[k].first < 0 || pieces[onEdges_[k].first].start.fromStart != 0 ||
        pieces[onEdges_[k].last].end.toEnd != 0)
      throw InputError("the mesh does not cover edge ", k, " of boundary '",
                       outline_->edges()[k].boundary, "'");
  for (int e = 0; e < size(); ++e) {
    Element& element = elements_[e];
    const Edge& edge = outline_->edge(element.piece.edge);
    const OnEdge& on = onEdge(element.piece.edge);
    element.previous = e == on.first ? onEdge(edge.previous).last : e - 1;
    element.next = e == on.last ? onEdge(edge.next).first : e + 1;
    element.startNode = e;  // one node an element: the one it starts with
  }
  for (Element& element : elements_)
    element.endNode = elements_[element.next].startNode;
}

Mesh Mesh::withDensities(const std::vector<int>& densities) const {
  Mesh result = *this;
  for (int e = 0; e < size(); ++e) {
    const int count = densities[e];
    if (isAxis(e))
      continue;
    if (count < (*this)[e].degree || count > largestDegree)
      throw InputError(count, " functions of a density on an element of degree ",
                       (*this)[e].degree, "; up to ", largestDegree, " are possible");
    result.elements_[e].densities = count;
  }
  return result;
}

Mesh Mesh::withDegreesOfDensities() const {
  Mesh result = *this;
  for (Element& element : result.elements_)
    if (element.densities > 0)
      element.piece.degree = element.degree = element.densities;
  return result;
}

bool Mesh::hasArcs() const {
  for (int e = 0; e < size(); ++e)
    if (lineOf(e) < 0)
      return true;
  return false;
}

std::vector<int> Mesh::elementsOf(const std::string& name) const {
  std::vector<int> result;
  for (int e = 0; e < size(); ++e)
    if (boundary(e) == name)
      result.push_back(e);
  return result;
}

BoundaryPoint Mesh::at(int e, double fromStart, double toEnd) const {
  const Element& element = (*this)[e];
  const Piece& piece = element.piece;
  if (fromStart < toEnd)
    return {piece.edge, piece.start, element.half * fromStart};
  return {piece.edge, piece.end, -element.half * toEnd};
}

Vec2 Mesh::scaledPoint(int e, double t) const {
  return place(outline_->edge((*this)[e].piece.edge), at(e, t));
}

double Mesh::ofRevolution(int e, double t) const {
  constexpr double turn = 6.2831853071795865;
  return turn * scaledPoint(e, t).x * (*this)[e].half;
}

SurfacePoint Mesh::physicalPoint(int e, double t) const {
  const Vec2 x = outline_->physical(scaledPoint(e, t));
  return {x.x, x.y, (*this)[e].curve.normal(t)};
}

Vec2 Mesh::difference(const BoundaryPoint& x, const BoundaryPoint& y) const {
  const Edge& ex = outline_->edge(x.edge);
  const Edge& ey = outline_->edge(y.edge);
  if (x.edge == y.edge)
    return ex.curve.chord(y.position, y.offset, x.position, x.offset);
  const double fromStartOfX = x.position.fromStart + x.offset;
  const double fromStartOfY = y.position.fromStart + y.offset;
  const double toEndOfX = x.position.toEnd - x.offset;
  const double toEndOfY = y.position.toEnd - y.offset;
  const bool before = ex.next == y.edge;  // x's edge ends where y's starts
  const bool behind = ey.next == x.edge;
  if (before && !(behind && fromStartOfX + toEndOfY < toEndOfX + fromStartOfY))
    return ex.curve.fromEnd(-toEndOfX) - ey.curve.fromStart(fromStartOfY);
  if (behind)
    return ex.curve.fromStart(fromStartOfX) - ey.curve.fromEnd(-toEndOfY);
  // From the nearer ends, whose difference has the digits of the user's coordinates: of
  // edges much shorter than the outline scaled ones have lost them.
  const auto start = [&](const Edge& edge, bool isNearer) {
    return isNearer ? edge.start : outline_->edge(edge.next).start;
  };
  const bool startsX = fromStartOfX < toEndOfX;
  const bool startsY = fromStartOfY < toEndOfY;
  return (1 / outline_->scaling().length) * (start(ex, startsX) - start(ey, startsY)) +
         (startsX ? ex.curve.fromStart(fromStartOfX) : ex.curve.fromEnd(-toEndOfX)) -
         (startsY ? ey.curve.fromStart(fromStartOfY) : ey.curve.fromEnd(-toEndOfY));
}

Vec2 Mesh::offset(int e, int f) const {
  const Vec2 w = (*this)[e].curve.frame().middle - (*this)[f].curve.frame().middle;
  if (dot(w, w) >= plainDistance * plainDistance)
    return w;
  return e < f ? -difference(at(f, 0), at(e, 0)) : difference(at(e, 0), at(f, 0));
}

Mesh makeMesh(std::shared_ptr<const Outline> outline,
              const std::vector<int>& elementsPerEdge, int degree) {
  const std::size_t edges = outline->edges().size();
  if (elementsPerEdge.size() != edges)
    throw InputError("elements for ", elementsPerEdge.size(),
                     " edges given; the outline has ", edges);
  std::vector<Piece> pieces;
  for (std::size_t k = 0; k < edges; ++k) {
    const int count = elementsPerEdge[k];
    const double length = outline->edges()[k].curve.length();
    if (count < 1)
      throw InputError(count, " elements on edge ", k, "; at least 1 is needed");
    const auto node = [&](int i) {
      return Position{length * i / count, length * (count - i) / count};
    };
    for (int i = 0; i < count; ++i)
      pieces.push_back({static_cast<int>(k), node(i), node(i + 1), degree});
  }
  return Mesh(std::move(outline), pieces);
}

}  // namespace epafi::bem
