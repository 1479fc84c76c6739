#include "reference/QuadOperators.hpp"

#include <algorithm>
#include <array>

namespace epafi::reference {

namespace {

using bem::Index;
using Components = std::array<std::array<Quad, 2>, 2>;

/// A dense block of 2 x 2 matrices, one for each pair of scalar basis functions.
struct Block {
  Block(int m, int n) : rows(m), columns(n), values(m * n) {}

  Components& operator()(int i, int j) { return values[i * columns + j]; }
  const Components& operator()(int i, int j) const { return values[i * columns + j]; }

  Quad frobenius() const {
    Quad sum = 0;
    for (const Components& value : values)
      for (const auto& row : value)
        for (const Quad& v : row)
          sum += v * v;
    return sqrt(sum);
  }

  int rows;
  int columns;
  std::vector<Components> values;
  Quad norm = 0;  // what errors are measured by
};

/// Of the kernels as LogKernel and DoubleLayerKernel have them.
struct Constants {
  explicit Constants(const bem::Lame& lame) {
    const Quad nu = lame.nu;
    const Quad mu = lame.mu;
    b = 1 / (8 * pi * mu * (1 - nu));
    a = (3 - 4 * nu) * b;
    const Quad c3 = 1 / (4 * pi * (1 - nu));
    layer = {c3 * (1 - 2 * nu), 2 * c3, c3 * (1 - 2 * nu)};
    d = dyad = mu / (2 * pi * (1 - nu));
  }
  /// Laplace's of each component.
  Constants() : a(1 / (2 * pi)), b(0), d(a), dyad(0), layer{a, 0, 0} {}

  struct Layer {
    Quad diagonal, dyad, turn;
  };
  const Quad pi = acos(Quad(-1));
  Quad a, b;     // V
  Quad d, dyad;  // V*
  Layer layer;   // K
};

/// A scalar function on an element as its Legendre coefficients.
using Series = std::vector<Quad>;

/// φ₀, φ₁ and the integrated Legendre polynomials.
std::vector<Series> displacementBasis(int degree) {
  std::vector<Series> basis(static_cast<std::size_t>(degree) + 1);
  const Quad half = Quad(1) / 2;
  basis[0] = {half, -half};
  basis[1] = {half, half};
  for (int k = 2; k <= degree; ++k) {
    basis[k].resize(static_cast<std::size_t>(k) + 1);
    basis[k][k] = 1 / sqrt(Quad(2 * (2 * k - 1)));
    basis[k][k - 2] = -basis[k][k];
  }
  return basis;
}

/// dφ_k/ds on an element.
std::vector<Series> displacementSlopes(int degree, const Quad& length) {
  std::vector<Series> slopes(static_cast<std::size_t>(degree) + 1);
  slopes[0] = {-1 / length};
  slopes[1] = {1 / length};
  for (int k = 2; k <= degree; ++k) {
    slopes[k].resize(k);
    slopes[k][k - 1] = sqrt(Quad(2 * k - 1) / 2) * 2 / length;
  }
  return slopes;
}

std::vector<Series> legendreBasis(int degree) {
  std::vector<Series> basis(static_cast<std::size_t>(degree) + 1);
  for (int k = 0; k <= degree; ++k) {
    basis[k].resize(static_cast<std::size_t>(k) + 1);
    basis[k][k] = 1;
  }
  return basis;
}

/// ∫∫ ψ_i(x) kernel(x,y) φ_j(y), the kernel given by its Legendre moments.
template <class Kernel>
Block tested(const std::vector<Series>& psi, const Kernel& kernel,
             const std::vector<Series>& phi) {
  std::size_t m = 0;
  std::size_t n = 0;
  for (const Series& s : psi)
    m = std::max(m, s.size());
  for (const Series& s : phi)
    n = std::max(n, s.size());
  std::vector<Components> moments;
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j)
      moments.push_back(kernel(static_cast<int>(i), static_cast<int>(j)));

  Block block(static_cast<int>(psi.size()), static_cast<int>(phi.size()));
  for (int i = 0; i < block.rows; ++i)
    for (int j = 0; j < block.columns; ++j)
      for (std::size_t k = 0; k < psi[i].size(); ++k)
        for (std::size_t l = 0; l < phi[j].size(); ++l) {
          const Quad factor = psi[i][k] * phi[j][l];
          for (int c = 0; c < 2 && factor != 0; ++c)
            for (int e = 0; e < 2; ++e)
              block(i, j)[c][e] += factor * moments[k * n + l][c][e];
        }
  block.norm = block.frobenius();
  return block;
}

/// α (-log r I) + β dd'/r²
struct LogKernel {
  Quad alpha;
  Quad beta;
  const PairMoments& moments;
  Quad area;  // ∫∫ ds ds

  Components operator()(int i, int j) const {
    const Quad log = -alpha * moments(Field::LogR, i, j);
    const Quad xx = beta * moments(Field::Xx, i, j);
    const Quad xy = beta * moments(Field::Xy, i, j);
    const Quad both = i == 0 && j == 0 ? beta * area : Quad(0);  // xx + yy
    return {{{log + xx, xy}, {xy, log + both - xx}}};
  }
};

/// (diagonal I + dyad dd'/r²) (d.n)/r² - turn (dn' - nd')/r²
struct DoubleLayerKernel {
  Constants::Layer of;
  const PairMoments& moments;
  QuadVec n;

  Components operator()(int i, int j) const {
    const Quad xxx = moments(Field::Xxx, i, j);
    const Quad xxy = moments(Field::Xxy, i, j);
    const Quad xyy = moments(Field::Xyy, i, j);
    const Quad yyy = moments(Field::Yyy, i, j);
    const Quad dx = xxx + xyy;  // d/r²
    const Quad dy = xxy + yyy;
    const Quad diagonal = of.diagonal * (dx * n.x + dy * n.y);
    const Quad turn = of.turn * (dx * n.y - dy * n.x);
    const Quad xx = of.dyad * (xxx * n.x + xxy * n.y);
    const Quad xy = of.dyad * (xxy * n.x + xyy * n.y);
    const Quad yy = of.dyad * (xyy * n.x + yyy * n.y);
    return {{{diagonal + xx, xy - turn}, {xy + turn, diagonal + yy}}};
  }
};

/// The double layer of a pair.
Block doubleLayerBlock(const Constants& constants, int densities,
                       const PairMoments& moments, const QuadCurve& second,
                       int secondDegree) {
  const auto psi = legendreBasis(densities - 1);
  const auto phi = displacementBasis(secondDegree);
  const QuadVec n = second.normal(0);
  return tested(psi, DoubleLayerKernel{constants.layer, moments, n}, phi);
}

Meeting meeting(const bem::Mesh& mesh, int e, int f) {
  if (e == f)
    return Meeting::Same;
  if (mesh[e].next == f)
    return Meeting::ToFrom;
  if (mesh[f].next == e)
    return Meeting::FromTo;
  return Meeting::Apart;
}

/// What one pair of elements adds to the three matrices.
struct PairBlocks {
  Block singleLayer;       // (e, f)
  Block doubleLayer;       // densities on e, displacements on f
  Block transposedDouble;  // densities on f, displacements on e
  Block hypersingular;     // (e, f)
};

PairBlocks pairBlocks(const bem::Mesh& mesh, const std::vector<QuadCurve>& segments,
                      const PairIntegrator& integrate, const Constants& constants, int e,
                      int f) {
  const int p = mesh[e].degree;
  const int q = mesh[f].degree;
  const int m = mesh[e].densities;  // p, or more
  const int n = mesh[f].densities;
  const QuadCurve& first = segments[e];
  const QuadCurve& second = segments[f];
  const Quad length = 2 * first.half;
  const Quad otherLength = 2 * second.half;
  const PairMoments moments = integrate(first, m, second, n, meeting(mesh, e, f));
  const Quad area = length * otherLength;
  return {tested(legendreBasis(m - 1), LogKernel{constants.a, constants.b, moments, area},
                 legendreBasis(n - 1)),
          doubleLayerBlock(constants, m, moments, second, q),
          doubleLayerBlock(constants, n, moments.transposed(), first, p),
          tested(displacementSlopes(p, length),
                 LogKernel{constants.d, constants.dyad, moments, area},
                 displacementSlopes(q, otherLength))};
}

/// 1/2 ∫ P_i φ_j ds on one element.
void addHalfMass(Block& block, const Quad& length) {
  const std::vector<Series> basis = displacementBasis(block.columns - 1);
  for (int j = 0; j < block.columns; ++j)
    for (int i = 0; i < block.rows && i < static_cast<int>(basis[j].size()); ++i)
      for (int c = 0; c < 2; ++c)
        block(i, j)[c][c] += basis[j][i] * length / (2 * (2 * i + 1));
  block.norm = block.frobenius();
}

/// Adds a block; `row` and `column` number (local function, component).
template <class Row, class Column>
void scatter(QuadMatrix& matrix, const Block& block, int components, const Row& row,
             const Column& column) {
  for (int i = 0; i < block.rows; ++i)
    for (int j = 0; j < block.columns; ++j)
      for (int c = 0; c < components; ++c)
        for (int d = 0; d < components; ++d)
          matrix.add(row(i, c), column(j, d), block(i, j)[c][d], block.norm);
}

template <class Row, class Column>
void scatterTransposed(QuadMatrix& matrix, const Block& block, int components,
                       const Row& row, const Column& column) {
  for (int i = 0; i < block.rows; ++i)
    for (int j = 0; j < block.columns; ++j)
      for (int c = 0; c < components; ++c)
        for (int d = 0; d < components; ++d)
          matrix.add(column(j, d), row(i, c), block(i, j)[c][d], block.norm);
}

QuadVec nodeOf(const bem::Mesh& mesh, int e) {
  const bem::Piece& piece = mesh[e].piece;
  const bem::Edge& edge = mesh.outline().edge(piece.edge);
  const QuadVec from{edge.curve.from().x, edge.curve.from().y};
  const QuadVec to{edge.curve.to().x, edge.curve.to().y};
  const QuadVec tau = segment(from, to).middleTangent;
  return piece.start.fromStart < piece.start.toEnd
             ? from + Quad(piece.start.fromStart) * tau
             : to - Quad(piece.start.toEnd) * tau;
}

/// Elements of a mesh in 33 digits: neighbours share their common node exactly.
std::vector<QuadCurve> segments(const bem::Mesh& mesh) {
  std::vector<QuadCurve> result;
  result.reserve(mesh.size());
  for (int e = 0; e < mesh.size(); ++e)
    result.push_back(segment(nodeOf(mesh, e), nodeOf(mesh, mesh[e].next)));
  return result;
}

/// Of all entries, or of those on and below the diagonal.
double largestError(const bem::Matrix& matrix, const QuadMatrix& exact, bool lower) {
  Quad largest = 0;
  for (Index j = 0; j < exact.columns(); ++j)
    for (Index i = lower ? j : 0; i < exact.rows(); ++i)
      largest =
          std::max<Quad>(largest, abs(matrix(i, j) - exact(i, j)) / exact.scale(i, j));
  return static_cast<double>(largest);
}

}  // namespace

QuadMatrix::QuadMatrix(Index rows, Index columns)
    : rows_(rows), columns_(columns), values_(rows * columns), scales_(rows * columns) {}

void QuadMatrix::add(Index i, Index j, const Quad& value, const Quad& blockNorm) {
  values_[at(i, j)] += value;
  scales_[at(i, j)] += blockNorm;
}

namespace {

QuadOperators quadOperators(const bem::Space& space, const Constants& constants,
                            double tolerance) {
  const bem::Mesh& mesh = space.mesh();
  const int components = space.components();
  const std::vector<QuadCurve> lines = segments(mesh);
  int degree = 1;
  for (const bem::Element& element : mesh.elements())
    degree = std::max(degree, element.densities);
  const PairIntegrator integrate(degree, tolerance);

  const Index n = space.densities();
  const Index m = space.displacements();
  QuadOperators result{QuadMatrix(n, n), QuadMatrix(n, m), QuadMatrix(m, m)};
  const auto density = [&space](int e) {
    return [&space, e](int i, int c) { return space.density(e, i, c); };
  };
  const auto displacement = [&space](int e) {
    return [&space, e](int k, int c) { return space.displacement(e, k, c); };
  };
  const int size = mesh.size();
#pragma omp parallel for schedule(dynamic)
  for (int pair = 0; pair < size * size; ++pair) {
    const int e = pair / size;
    const int f = pair % size;
    if (f > e)
      continue;
    PairBlocks blocks = pairBlocks(mesh, lines, integrate, constants, e, f);
    if (e == f)
      addHalfMass(blocks.doubleLayer, 2 * lines[e].half);
#pragma omp critical
    {
      scatter(result.singleLayer, blocks.singleLayer, components, density(e), density(f));
      scatter(result.doubleLayer, blocks.doubleLayer, components, density(e),
              displacement(f));
      scatter(result.hypersingular, blocks.hypersingular, components, displacement(e),
              displacement(f));
      if (e != f) {
        scatter(result.doubleLayer, blocks.transposedDouble, components, density(f),
                displacement(e));
        scatterTransposed(result.singleLayer, blocks.singleLayer, components, density(e),
                          density(f));
        scatterTransposed(result.hypersingular, blocks.hypersingular, components,
                          displacement(e), displacement(f));
      }
    }
  }
  return result;
}

}  // namespace

QuadOperators quadOperators(const bem::Space& space, const bem::Lame& lame,
                            double tolerance) {
  return quadOperators(space, Constants(lame), tolerance);
}

QuadOperators quadLaplace(const bem::Space& space, double tolerance) {
  return quadOperators(space, Constants(), tolerance);
}

OperatorErrors operatorErrors(const bem::Operators& operators,
                              const QuadOperators& exact) {
  return {largestError(operators.singleLayer, exact.singleLayer, true),
          largestError(operators.doubleLayer, exact.doubleLayer, false),
          largestError(operators.hypersingular, exact.hypersingular, true)};
}

}  // namespace epafi::reference
