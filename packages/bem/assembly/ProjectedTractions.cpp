#include "bem/assembly/ProjectedTractions.hpp"

#include "bem/potential/RelativeTarget.hpp"

#include <cmath>

namespace epafi::bem {

namespace {

constexpr double inverse2Pi = 0.15915494309189533577;

/// ∫ P_j log|w| dt and ∫ P_j w/conj(w) dt over an element, at one point.
struct PointMoments {
  std::array<double, largestDegree> log{};
  std::array<Complex, largestDegree> phase{};
};

PointMoments atPoint(const Element& source, const RelativeTarget& target) {
  PointMoments result;
  const Complex tangent(source.tangent.x, source.tangent.y);
  const Complex square = tangent * tangent;
  const bool atStart = target.zPlus1 == 0.0;
  const bool atEnd = target.zMinus1 == 0.0;
  LegendreMoments m;
  if (!atStart && !atEnd)
    evaluateMoments(target, source.degree - 1, Need::CandL, m);
  for (int j = 0; j < source.degree; ++j) {
    const double constant = j == 0 ? 2 : 0;
    double l = 0;
    Complex bc = 0;          // b C_j -> 0 at the ends
    if (atStart || atEnd) {  // limits of the closed form
      const double limit = j == 0 ? 2 * std::log(2.0) - 2 : -2.0 / (j * (j + 1.0));
      l = atStart && j % 2 == 1 ? -limit : limit;
    } else {
      l = m.l[j];
      bc = target.b() * m.c[j];
    }
    result.log[j] = l + constant * std::log(source.half);
    result.phase[j] = square * (constant - Complex(0, 2) * bc);
  }
  return result;
}

}  // namespace

/// Symmetric 2 x 2 blocks of V* and of X (its constant part left out) and the Laplace
/// term.
struct ProjectedTractions::Blocks {
  double vStar[3];  // xx, xy, yy
  double x[3];
  double laplace = 0;

  Blocks(const Lame& lame, double log, Complex phase, double constant)
      : vStar{lame.d * (0.5 * (constant + phase.real()) - log),
              lame.d * 0.5 * phase.imag(),
              lame.d * (0.5 * (constant - phase.real()) - log)} {
    const double a = 2 * lame.mu * (1 - 2 * lame.nu) * lame.b;
    const double b = lame.mu * lame.b;
    x[0] = b * phase.real() - a * log;
    x[1] = b * phase.imag();
    x[2] = -b * phase.real() - a * log;
  }
};

ProjectedTractions::ProjectedTractions(const Space& space, const Lame& lame,
                                       const DenseAlgebra& algebra,
                                       const std::vector<int>& elements)
    : space_(space),
      lame_(lame),
      densityRows_(algebra.myRows(space.densities())),
      displacementRows_(algebra.myRows(space.displacements())),
      mine_(space, algebra),
      columnOf_(static_cast<std::size_t>(space.mesh().size()), -1) {
  kernels_.elements = elements;
  kernels_.start.assign(1, 0);
  for (const int e : elements) {
    columnOf_[e] = kernels_.start.back();
    kernels_.start.push_back(kernels_.start.back() + 2 * (space.mesh()[e].degree + 1));
  }
  kernels_.hypersingular = Matrix(displacementRows_.size(), kernels_.start.back());
  kernels_.adjoint = Matrix(densityRows_.size(), kernels_.start.back());
}

// W and K' of the source's Legendre component j tested with P_i, times factor; the test's
// normalisation is put in here.
void ProjectedTractions::put(int test, int i, int source, int j, const Blocks& blocks,
                             double factor) {
  const Element& x = space_.mesh()[test];
  const Element& y = space_.mesh()[source];
  const double scale = factor * std::sqrt((2 * i + 1) / (2 * x.half));
  const Index column = columnOf_[test] + 2 * i;

  const auto addHyper = [&](int l, double slope) {
    const Index row = space_.displacement(source, l, 0);
    const double s = scale * slope;
    const auto add = [&](int c, int a, double value) {
      if (displacementRows_.contain(row + c))
        kernels_.hypersingular(row + c - displacementRows_.begin, column + a) +=
            s * value;
    };
    add(0, 0, blocks.vStar[0]);
    add(0, 1, blocks.vStar[1]);
    add(1, 0, blocks.vStar[1]);
    add(1, 1, blocks.vStar[2]);
  };
  if (j == 0) {
    addHyper(0, -0.5);
    addHyper(1, 0.5);
  } else {
    addHyper(j + 1, DisplacementBasis::slope(j + 1));
  }

  const Index row = space_.density(source, j, 0);
  const double s = scale * y.half;
  const auto add = [&](int b, int a, double value) {
    if (densityRows_.contain(row + b))
      kernels_.adjoint(row + b - densityRows_.begin, column + a) += s * value;
  };
  // -X J e_x = (X_xy, X_yy),  -X J e_y = (-X_xx, -X_xy)
  add(0, 0, blocks.x[1] + blocks.laplace);
  add(1, 0, blocks.x[2]);
  add(0, 1, -blocks.x[0]);
  add(1, 1, -blocks.x[1] + blocks.laplace);
}

template <class Moments>
void ProjectedTractions::addTest(int test, int source, const Moments& m) {
  const int p = space_.mesh()[test].degree;
  const int q = space_.mesh()[source].degree;
  for (int k = 0; k < p; ++k)
    for (int j = 0; j < q; ++j) {
      const Blocks blocks(lame_, m.log(k, j), m.phase(k, j), k == 0 && j == 0 ? 4 : 0);
      for (int i = k + 1; i <= p; i += 2)  // P_i' = Σ (2k+1) P_k
        put(test, i, source, j, blocks, 2 * k + 1);
    }
  if (space_.mesh()[test].piece.edge == space_.mesh()[source].piece.edge)
    return;  // the Laplace double layer vanishes on a line
  Blocks onlyLaplace(lame_, 0, 0, 0);
  for (int i = 0; i <= p; ++i)
    for (int j = 0; j < q; ++j) {
      onlyLaplace.laplace = inverse2Pi * m.laplace(i, j);
      put(test, i, source, j, onlyLaplace, 1);
    }
}

namespace {

struct AsIs {
  const PairMoments& m;
  double log(int k, int j) const { return m.log(k, j); }
  Complex phase(int k, int j) const { return {m.phaseReal(k, j), m.phaseImag(k, j)}; }
  double laplace(int i, int j) const { return m.reverse(i, j); }
};

struct Swapped {
  const PairMoments& m;
  double log(int k, int j) const { return m.log(j, k); }
  Complex phase(int k, int j) const { return {m.phaseReal(j, k), m.phaseImag(j, k)}; }
  double laplace(int i, int j) const { return m.direct(j, i); }
};

}  // namespace

void ProjectedTractions::add(int e, int f, const PairMoments& moments) {
  if (columnOf_[e] >= 0)
    addTest(e, f, AsIs{moments});
  if (e != f && columnOf_[f] >= 0)
    addTest(f, e, Swapped{moments});
}

// -[P_i V*φ'] and [X J v]: both are minus what put() adds
void ProjectedTractions::addEnds(std::size_t k) {
  const Mesh& mesh = space_.mesh();
  const int test = kernels_.elements[k];
  const Element& x = mesh[test];
  for (int f = 0; f < mesh.size(); ++f) {
    if (!mine_.contain(f))
      continue;
    const PointMoments atStart = atPoint(mesh[f], seenFrom(mesh, f, mesh.at(test, -1.0)));
    const PointMoments atEnd = atPoint(mesh[f], seenFrom(mesh, f, mesh.at(test, 1.0)));
    for (int j = 0; j < mesh[f].degree; ++j) {
      const double constant = j == 0 ? 2 : 0;
      const Blocks start(lame_, atStart.log[j], atStart.phase[j], constant);
      const Blocks end(lame_, atEnd.log[j], atEnd.phase[j], constant);
      for (int i = 0; i <= x.degree; ++i) {
        put(test, i, f, j, end, -1);
        put(test, i, f, j, start, i % 2 == 0 ? 1 : -1);
      }
    }
  }
  for (int i = 0; i < x.degree; ++i) {  // 1/2 <P_i, P̂_i>
    Blocks half(lame_, 0, 0, 0);
    half.laplace = 1.0 / (2 * i + 1);
    put(test, i, test, i, half, 1);
  }
}

TractionKernels ProjectedTractions::finish() {
  const auto count = static_cast<int>(kernels_.elements.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (int k = 0; k < count; ++k)
    addEnds(static_cast<std::size_t>(k));
  return std::move(kernels_);
}

}  // namespace epafi::bem
