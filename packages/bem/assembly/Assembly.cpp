#include "bem/assembly/Assembly.hpp"

#include "bem/assembly/FarPairs.hpp"
#include "bem/assembly/MyElements.hpp"
#include "bem/assembly/NearPair.hpp"

#include <algorithm>
#include <memory>

namespace epafi::bem {

namespace {

/// A 2 x 2 block, symmetric: the xx, xy and yy entries.
struct Block {
  double xx;
  double xy;
  double yy;
};

Block operator*(double s, const Block& b) { return {s * b.xx, s * b.xy, s * b.yy}; }

/// Turns moments into entries of the three matrices and adds them to the rows that are
/// mine.
class Scatter {
 public:
  Scatter(const Space& space, const Lame& lame, const DenseAlgebra& algebra,
          Operators& out)
      : space_(space),
        lame_(lame),
        densityRows_(algebra.myRows(space.densities())),
        displacementRows_(algebra.myRows(space.displacements())),
        out_(out) {}

  void add(int e, int f, const PairMoments& moments) const {
    addPair(e, f, moments);
    if (e == f)
      addHalfMass(e);
  }

 private:
  void addPair(int e, int f, const PairMoments& m) const {
    const Element& x = space_.mesh()[e];
    const Element& y = space_.mesh()[f];
    const bool sameEdge = x.piece.edge == y.piece.edge;
    for (int i = 0; i < x.degree; ++i)
      for (int j = 0; j < y.degree; ++j) {
        const double constant = i == 0 && j == 0 ? 4 : 0;
        // d d'/r² = (I + [Re, Im; Im, -Re] of w/conj(w)) / 2
        const Block radial = {0.5 * (constant + m.phaseReal(i, j)),
                              0.5 * m.phaseImag(i, j),
                              0.5 * (constant - m.phaseReal(i, j))};
        const double log = m.log(i, j);
        const Block kelvin = combine(lame_.a, log, lame_.b, radial);
        addSingleLayer(e, i, f, j, (x.half * y.half) * kelvin);
        // X = 2μ V - V_Δ without its constant part, which ∫ v' = 0 over a loop removes:
        // 2μ A - 1/2π = μ (A - B) = 2 μ (1-2ν) B keeps its digits as ν -> 1/2
        Block turning = {0.5 * m.phaseReal(i, j), 0.5 * m.phaseImag(i, j),
                         -0.5 * m.phaseReal(i, j)};
        if (sameEdge) {
          if (i == 0 && j == 0)
            addTurningAtEdgeEnds(e, f, 2 * lame_.mu * lame_.b * turning);
          turning = {0, 0, 0};
        }
        const Block rotated = combine(2 * lame_.mu * (1 - 2 * lame_.nu) * lame_.b, log,
                                      2 * lame_.mu * lame_.b, turning);
        addByParts(e, i, f, j, x.half * rotated);
        if (e != f)
          addByParts(f, j, e, i, y.half * rotated);
        addHypersingular(e, i, f, j, combine(lame_.d, log, lame_.d, radial));
      }
    if (sameEdge)
      return;  // the Laplace double layer vanishes on a line
    addLaplace(e, f, [&](int i, int j) { return m.direct(i, j); });
    addLaplace(f, e, [&](int j, int i) { return m.reverse(i, j); });
  }

  static Block combine(double a, double log, double b, const Block& radial) {
    return {b * radial.xx - a * log, b * radial.xy, b * radial.yy - a * log};
  }

  void put(Matrix& matrix, const Rows& mine, Index row, Index column,
           double value) const {
    if (mine.contain(row))
      matrix(row - mine.begin, column) += value;
  }

  void addSingleLayer(int e, int i, int f, int j, const Block& v) const {
    const Index row = space_.density(e, i, 0);
    const Index column = space_.density(f, j, 0);
    put(out_.singleLayer, densityRows_, row, column, v.xx);
    put(out_.singleLayer, densityRows_, row + 1, column, v.xy);
    put(out_.singleLayer, densityRows_, row, column + 1, v.xy);
    put(out_.singleLayer, densityRows_, row + 1, column + 1, v.yy);
  }

  /// Basis functions whose derivative has the Legendre component P_j: two hats or one
  /// bubble.
  template <class Visit>
  static void forDerivative(int j, const Visit& visit) {
    if (j == 0) {
      visit(0, -0.5);
      visit(1, 0.5);
    } else {
      visit(j + 1, DisplacementBasis::slope(j + 1));
    }
  }

  // -X M v: for v = φ e_x, M v = (0, -φ'); for v = φ e_y, M v = (φ', 0)
  void addByParts(int test, int i, int source, int j, const Block& x) const {
    forDerivative(
        j, [&](int k, double slope) { addRotated(test, i, source, k, slope * x); });
  }

  void addRotated(int test, int i, int source, int k, const Block& x) const {
    const Index row = space_.density(test, i, 0);
    const Index column = space_.displacement(source, k, 0);
    put(out_.doubleLayer, densityRows_, row, column, x.xy);
    put(out_.doubleLayer, densityRows_, row + 1, column, x.yy);
    put(out_.doubleLayer, densityRows_, row, column + 1, -x.xx);
    put(out_.doubleLayer, densityRows_, row + 1, column + 1, -x.xy);
  }

  // On one line the phase is one constant, whose contributions of neighbours cancel at
  // every node but the edge's ends.  Adding and subtracting it would leave rounding,
  // which is large beside the rest as ν -> 1/2.
  void addTurningAtEdgeEnds(int e, int f, const Block& x) const {
    addTurningAtEnds(e, f, space_.mesh()[e].half * x);
    if (e != f)
      addTurningAtEnds(f, e, space_.mesh()[f].half * x);
  }

  void addTurningAtEnds(int test, int source, const Block& x) const {
    const Mesh& mesh = space_.mesh();
    const Element& y = mesh[source];
    if (mesh[y.previous].piece.edge != y.piece.edge)
      addRotated(test, 0, source, 0, -0.5 * x);
    if (mesh[y.next].piece.edge != y.piece.edge)
      addRotated(test, 0, source, 1, 0.5 * x);
  }

  template <class Moment>
  void addLaplace(int test, int source, const Moment& moment) const {
    const Element& x = space_.mesh()[test];
    const int p = space_.mesh()[source].degree;
    for (int i = 0; i < x.degree; ++i) {
      const Index row = space_.density(test, i, 0);
      if (!densityRows_.contain(row) && !densityRows_.contain(row + 1))
        continue;
      const double scale = x.half * inverse2Pi;
      for (int k = 0; k <= p; ++k) {
        double value = 0;  // ∫∫ P_i φ_k
        if (k < 2)
          value = 0.5 * (moment(i, 0) + (k == 0 ? -1 : 1) * moment(i, 1));
        else
          value = DisplacementBasis::slope(k) / (2 * k - 1) *
                  (moment(i, k) - moment(i, k - 2));
        const Index column = space_.displacement(source, k, 0);
        put(out_.doubleLayer, densityRows_, row, column, scale * value);
        put(out_.doubleLayer, densityRows_, row + 1, column + 1, scale * value);
      }
    }
  }

  void addHypersingular(int e, int i, int f, int j, const Block& v) const {
    forDerivative(i, [&](int k, double slopeE) {
      forDerivative(j, [&](int l, double slopeF) {
        const Block w = (slopeE * slopeF) * v;
        const Index row = space_.displacement(e, k, 0);
        const Index column = space_.displacement(f, l, 0);
        const double entries[2][2] = {{w.xx, w.xy}, {w.xy, w.yy}};
        for (int a = 0; a < 2; ++a)
          for (int b = 0; b < 2; ++b)
            addSymmetric(e == f, row + a, column + b, entries[a][b]);
      });
    });
  }

  // Off the diagonal blocks an entry stands for its mirror image too.
  void addSymmetric(bool diagonalBlock, Index row, Index column, double value) const {
    if (diagonalBlock) {
      if (row >= column)
        put(out_.hypersingular, displacementRows_, row, column, value);
      return;
    }
    const double twice = row == column ? 2 : 1;
    put(out_.hypersingular, displacementRows_, std::max(row, column),
        std::min(row, column), twice * value);
  }

  void addHalfMass(int e) const {
    const Element& x = space_.mesh()[e];
    const Matrix coefficients = DisplacementBasis::legendreCoefficients(x.degree);
    for (int i = 0; i < x.degree; ++i)
      for (int k = 0; k <= x.degree; ++k)
        for (int c = 0; c < 2; ++c)
          put(out_.doubleLayer, densityRows_, space_.density(e, i, c),
              space_.displacement(e, k, c), x.half * coefficients(i, k) / (2 * i + 1));
  }

  static constexpr double inverse2Pi = 0.15915494309189533577;
  const Space& space_;
  const Lame& lame_;
  Rows densityRows_;
  Rows displacementRows_;
  Operators& out_;
};

/// What a thread needs for one row of pairs.
struct Scratch {
  PairMoments pair;
  FarMoments far;
};

/// All pairs (e, f) with f <= e, e in a group, of which a row is mine.
class RowOfPairs {
 public:
  RowOfPairs(const Space& space, const DenseAlgebra& algebra, const Scatter& scatter,
             ProjectedTractions& tractions)
      : space_(space), mine_(space, algebra), scatter_(scatter), tractions_(tractions) {}

  /// Batch by batch for all e of a group: the columns that a batch writes stay in cache.
  void assemble(const std::vector<int>& group, Scratch& scratch) const {
    for (int first = 0; first <= group.back(); first += lanes)
      for (const int e : group)
        if (first <= e)
          assembleBatch(e, first, std::min(first + lanes, e + 1), scratch);
  }

 private:
  // A batch is computed as a whole or not at all: what else is in it decides on the
  // quadrature, and results shall not depend on the number of processes.
  void assembleBatch(int e, int first, int last, Scratch& scratch) const {
    const Mesh& mesh = space_.mesh();
    if (!isMine(e, first, last))
      return;
    FarBatch batch;
    PairOrder order;
    int columns = 0;
    bool near[lanes];
    for (int lane = 0; lane < lanes; ++lane) {
      const int f = first + lane;
      PairOrder own;
      near[lane] = f >= last || isNear(mesh, e, f, own);
      setLane(batch, lane, e, near[lane] ? -1 : f);
      if (near[lane])
        continue;
      order = {std::max(order.outer, own.outer), std::max(order.inner, own.inner)};
      columns = std::max(columns, mesh[f].degree);
    }
    if (columns > 0)
      farMoments(mesh[e], batch, mesh[e].degree, columns, order, scratch.far);
    for (int f = first; f < last; ++f) {
      if (!isMine(e, f, f + 1))
        continue;
      if (near[f - first])
        nearPairMoments(mesh, e, f, scratch.pair);
      else
        extractLane(scratch.far, f - first, mesh[f].tangent, mesh[e].degree,
                    mesh[f].degree, scratch.pair);
      scatter_.add(e, f, scratch.pair);
      tractions_.add(e, f, scratch.pair);
    }
  }

  bool isMine(int e, int first, int last) const {
    bool mine = mine_.contain(e);
    for (int f = first; f < last; ++f)
      mine = mine || mine_.contain(f);
    return mine;
  }

  // f < 0: a lane to be thrown away, far off so that nothing overflows
  void setLane(FarBatch& batch, int lane, int e, int f) const {
    const Mesh& mesh = space_.mesh();
    const Vec2 w = f < 0 ? Vec2{10, 10} : mesh.difference(mesh.at(e, 0), mesh.at(f, 0));
    const Vec2 tangent = f < 0 ? Vec2{1, 0} : mesh[f].tangent;
    batch.wx[lane] = w.x;
    batch.wy[lane] = w.y;
    batch.tx[lane] = tangent.x;
    batch.ty[lane] = tangent.y;
    batch.half[lane] = f < 0 ? 1 : mesh[f].half;
  }

  const Space& space_;
  MyElements mine_;
  const Scatter& scatter_;
  ProjectedTractions& tractions_;
};

/// Groups of elements that threads may treat at once: two groups of the same colour share
/// no node, so their columns of K and rows of W are different.
std::vector<std::vector<std::vector<int>>> colouredGroups(const Mesh& mesh) {
  constexpr int groupSize = 8;
  std::vector<std::vector<std::vector<int>>> colours(2);
  std::vector<int> current;
  int colour = 0;
  for (int e = 0; e < mesh.size(); ++e) {
    if (mesh[e].next != e + 1) {  // closes its loop: on its own
      colours.push_back({{e}});
      continue;
    }
    current.push_back(e);
    if (static_cast<int>(current.size()) == groupSize) {
      colours[colour].push_back(current);
      current.clear();
      colour = 1 - colour;
    }
  }
  if (!current.empty())
    colours[colour].push_back(current);
  return colours;
}

}  // namespace

Operators assembleOperators(const Space& space, const Lame& lame,
                            const DenseAlgebra& algebra,
                            const std::vector<int>& tractionElements) {
  const Index densities = algebra.myRows(space.densities()).size();
  const Index displacements = algebra.myRows(space.displacements()).size();
  Operators out{Matrix(densities, space.densities()),
                Matrix(densities, space.displacements()),
                Matrix(displacements, space.displacements()),
                {}};
  const Scatter scatter(space, lame, algebra, out);
  ProjectedTractions tractions(space, lame, algebra, tractionElements);
  const RowOfPairs row(space, algebra, scatter, tractions);
#pragma omp parallel
  {
    const auto scratch = std::make_unique<Scratch>();
    for (const auto& groups : colouredGroups(space.mesh())) {
      // the last groups have the most pairs: first come, first served, from the back
#pragma omp for schedule(dynamic, 1)
      for (int g = static_cast<int>(groups.size()) - 1; g >= 0; --g)
        row.assemble(groups[static_cast<std::size_t>(g)], *scratch);
    }
  }
  out.tractions = tractions.finish();
  return out;
}

}  // namespace epafi::bem
