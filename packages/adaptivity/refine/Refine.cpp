#include "adaptivity/refine/Refine.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace epafi::adaptivity {

namespace {

using Pieces = std::vector<bem::Piece>;

void cutAt(const bem::Piece& piece, const std::vector<double>& places,
           const std::vector<int>& degrees, Pieces& result) {
  assert(degrees.size() == places.size() + 1);
  bem::Position start = piece.start;
  for (std::size_t k = 0; k < degrees.size(); ++k) {
    const bool last = k == places.size();
    const bem::Position end = last ? piece.end : positionAt(piece, places[k]);
    result.push_back({piece.edge, start, end, degrees[k]});
    start = end;
  }
}

Pieces cut(const bem::Mesh& mesh, const Marks& marks) {
  assert(static_cast<int>(marks.size()) == mesh.size());
  Pieces result;
  for (int e = 0; e < mesh.size(); ++e) {
    const bem::Piece piece = mesh[e].piece;
    if (mesh.isAxis(e)) {
      result.push_back(piece);
      continue;
    }
    const Mark& mark = marks[e];
    const int p = piece.degree;
    switch (mark.kind()) {
      case Mark::None:
        cutAt(piece, {}, {p}, result);
        break;
      case Mark::RaiseDegree:
        cutAt(piece, {}, {p + 1}, result);
        break;
      case Mark::Bisect:
        cutAt(piece, {0}, {p, p}, result);
        break;
      case Mark::Cut:
        cutAt(piece, mark.places(), mark.degrees(), result);
        break;
    }
  }
  return result;
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

double spacing(const bem::Outline& outline) {
  const bem::Scaling& scaling = outline.scaling();
  const double farthest =
      std::max(std::abs(scaling.origin.x), std::abs(scaling.origin.y));
  return std::numeric_limits<double>::epsilon() * (1 + farthest / scaling.length);
}

bool isShort(const bem::Mesh& mesh, int element) {
  constexpr double places = 100;  // of which a cut in the ratio 0.1 leaves ten
  return 2 * mesh[element].half < places * spacing(mesh.outline());
}

Marks withoutShort(const bem::Mesh& mesh, Marks marks) {
  for (int e = 0; e < mesh.size(); ++e)
    if ((marks[e] == Mark::Bisect || marks[e] == Mark::Cut) && isShort(mesh, e))
      marks[e] = Mark::None;
  return marks;
}

bem::Mesh refine(const bem::Mesh& mesh, const Marks& marks) {
  return {mesh.sharedOutline(), cut(mesh, marks)};
}

}  // namespace epafi::adaptivity
