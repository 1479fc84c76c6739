#include "adaptivity/refine/Refine.hpp"

#include <algorithm>
#include <cassert>

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

bem::Mesh refine(const bem::Mesh& mesh, const Marks& marks) {
  return {mesh.sharedOutline(), cut(mesh, marks)};
}

}  // namespace epafi::adaptivity
