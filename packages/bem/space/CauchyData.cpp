#include "bem/space/CauchyData.hpp"

#include "bem/base/Error.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::bem {

namespace {

bool same(Position a, Position b) {
  constexpr double tolerance = 1e-12;
  return std::abs(distanceAlong(a, b)) <= tolerance * std::min(a.fromStart, a.toEnd);
}

Origin originIn(const Mesh& mesh, int e, const Piece& part) {
  const Piece& whole = mesh[e].piece;
  const double length = 2 * mesh[e].half;
  const double start = 2 * distanceAlong(whole.start, part.start) / length - 1;
  const double end = 1 - 2 * distanceAlong(part.end, whole.end) / length;
  return {e, 0.5 * (start + end), 0.5 * (end - start)};
}

using Series = LegendreSeries<Complex>;

/// A series of this degree as a function on a part of its element; -1: zero.
Series restricted(const Series& series, int degree, const Origin& origin) {
  if (degree < 0)
    return {};
  return project(
      [&](double t) {
        return evaluate(series, degree, origin.middle + origin.scale * t);
      },
      degree);
}

LocalField restricted(const CauchyData& data, const Origin& origin) {
  const LocalField& field = data.fields[origin.element];
  const int p = data.mesh[origin.element].degree;
  return {restricted(field.value, p, origin), restricted(field.slope, p - 1, origin),
          restricted(field.density, data.mesh[origin.element].densities - 1, origin)};
}

void subtract(Series& a, const Series& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] -= b[i];
}

}  // namespace

CauchyData makeCauchyData(const Space& space, const Vector& u, const Vector& psi) {
  CauchyData data{space.mesh(), {}};
  const Vector inner = space.withoutRotation(u);
  for (int e = 0; e < space.mesh().size(); ++e)
    data.fields.push_back(localField(space, inner, psi, e));
  return data;
}

UnionMesh unite(const Mesh& first, const Mesh& second) {
  const std::size_t edges = first.outline().edges().size();
  if (second.outline().edges().size() != edges)
    throw InputError("meshes of outlines with ", edges, " and ",
                     second.outline().edges().size(), " edges cannot be compared");
  std::vector<Piece> pieces;
  std::vector<int> densities;
  std::vector<Origin> inFirst;
  std::vector<Origin> inSecond;
  for (int edge = 0; edge < static_cast<int>(edges); ++edge) {
    int i = first.onEdge(edge).first;
    int j = second.onEdge(edge).first;
    Position start = first[i].piece.start;
    while (i <= first.onEdge(edge).last && j <= second.onEdge(edge).last) {
      const Element& a = first[i];
      const Element& b = second[j];
      const bool together = same(a.piece.end, b.piece.end);
      const bool aEnds = together || distanceAlong(a.piece.end, b.piece.end) > 0;
      const Position end = aEnds ? a.piece.end : b.piece.end;
      pieces.push_back({edge, start, end, std::max(a.degree, b.degree)});
      densities.push_back(std::max(a.densities, b.densities));
      inFirst.push_back(originIn(first, i, pieces.back()));
      inSecond.push_back(originIn(second, j, pieces.back()));
      start = end;
      i += aEnds ? 1 : 0;
      j += together || !aEnds ? 1 : 0;
    }
  }
  return {Mesh(first.sharedOutline(), pieces).withDensities(densities),
          std::move(inFirst), std::move(inSecond)};
}

CauchyData difference(const CauchyData& a, const CauchyData& b) {
  UnionMesh both = unite(a.mesh, b.mesh);
  CauchyData result{std::move(both.mesh), {}};
  for (std::size_t e = 0; e < both.first.size(); ++e) {
    LocalField field = restricted(a, both.first[e]);
    const LocalField other = restricted(b, both.second[e]);
    subtract(field.value, other.value);
    subtract(field.slope, other.slope);
    subtract(field.density, other.density);
    result.fields.push_back(field);
  }
  return result;
}

}  // namespace epafi::bem
