#include "reference/ArcErrors.hpp"

#include "reference/QuadMoments.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::reference {

using bem::Mesh;

namespace {

/// As the mesh's doubles say: places from the nearer end of their edge.
QuadCurve curveOf(const Mesh& mesh, int e) {
  const bem::Piece& piece = mesh[e].piece;
  const bem::Curve& edge = mesh.outline().edge(piece.edge).curve;
  const QuadVec tangent{edge.frame().tangent.x, edge.frame().tangent.y};
  const QuadCurve whole{{edge.from().x, edge.from().y},
                        (1 / sqrt(dot(tangent, tangent))) * tangent,
                        edge.half(),
                        Quad(edge.angle()) / 2};
  const auto place = [&](const bem::Position& p) {
    return p.fromStart < p.toEnd ? Quad(p.fromStart) / whole.half - 1
                                 : 1 - Quad(p.toEnd) / whole.half;
  };
  const Quad start = place(piece.start);
  const Quad end = place(piece.end);
  return {whole.point(start), whole.tangent((start + end) / 2),
          whole.half * (end - start) / 2, whole.alpha * (end - start) / 2};
}

/// The largest error of the moments of a pair over the largest moment.
double error(const Mesh& mesh, bem::Tile& tile, const bem::ElementRuns& runs, int e,
             int f) {
  const int r = runs.runOf(f);
  tile.evaluate(runs, e, r, {runs[r].first, runs[r].last});
  const int lane = f - runs[r].first;
  const bem::Tile& m = tile;
  const int rows = mesh[e].degree;
  const int columns = mesh[f].degree;
  const QuadCurve first = curveOf(mesh, e);
  const QuadCurve second = curveOf(mesh, f);
  const PairIntegrator integrate(std::max(rows, columns), 1e-17);
  const PairMoments exact =
      integrate(first, rows, second, columns, e == f ? Meeting::Same : Meeting::Apart);
  const bem::Complex tangent = bem::asComplex(mesh[f].curve.frame().tangent);
  double worst = 0;
  double largest = 0;
  const auto compare = [&](double value, const Quad& wanted) {
    worst = std::max(worst, std::abs(value - static_cast<double>(wanted)));
    largest = std::max(largest, std::abs(static_cast<double>(wanted)));
  };
  const Quad area = first.half * second.half;
  for (int i = 0; i <= rows; ++i)
    for (int j = 0; j <= columns; ++j) {
      const int at = i * bem::Tile::stride + j;
      if (i < rows)
        compare(m.direct[at][lane], exact(Field::Direct, i, j) / first.half);
      if (j < columns)
        compare(m.reverse[at][lane], exact(Field::Reverse, i, j) / second.half);
      if (i == rows || j == columns)
        continue;
      compare(m.log[at][lane], exact(Field::LogR, i, j) / area);
      const bem::Complex phase = m.phase(i, j, lane, tangent);  // of w/conj(w)
      compare(phase.real(), 2 * exact(Field::Xx, i, j) / area - (i + j == 0 ? 4 : 0));
      compare(phase.imag(), 2 * exact(Field::Xy, i, j) / area);
    }
  return worst / largest;
}

}  // namespace

void testPairs(const Mesh& mesh, const std::vector<std::pair<int, int>>& pairs,
               Teuchos::FancyOStream& out, bool& success) {
  const bem::ElementRuns runs(mesh);
  bem::Tile tile;
  for (const auto& [e, f] : pairs) {
    out << "elements " << e << ", " << f << ": ";
    TEST_COMPARE(error(mesh, tile, runs, e, f), <, 1e-13);
  }
}

}  // namespace epafi::reference
