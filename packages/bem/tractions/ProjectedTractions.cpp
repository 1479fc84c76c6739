#include "bem/tractions/ProjectedTractions.hpp"

#include "bem/moments/EndMoments.hpp"
#include "bem/moments/NearPairs.hpp"
#include "bem/tractions/FarTractionRows.hpp"

#include <cmath>
#include <memory>

namespace epafi::bem {

namespace {

std::vector<int> nearSources(const ElementRuns& runs, int test) {
  std::vector<int> near;
  FarBatch batch{};
  for (int r = 0; r < runs.size(); ++r) {
    const ElementRange all = {runs[r].first, runs[r].last};
    const FarLanes chosen = runs.choose(test, r, all, batch);
    for (int f = all.first; f < all.last; ++f)
      if (!chosen.far[f - all.first])
        near.push_back(f);
  }
  return near;
}

}  // namespace

ProjectedTractions::ProjectedTractions(const Space& space, const Lame& lame,
                                       const DenseAlgebra& algebra,
                                       const std::vector<int>& elements)
    : space_(space),
      lame_(lame),
      densityRows_(algebra.myRows(space.densities())),
      displacementRows_(algebra.myRows(space.displacements())) {
  const Mesh& mesh = space.mesh();
  kernels_.elements = elements;
  kernels_.start.assign(1, 0);
  for (const int e : elements)
    kernels_.start.push_back(kernels_.start.back() + 2 * (mesh[e].degree + 1));
  kernels_.hypersingular = Matrix(displacementRows_.size(), kernels_.start.back());
  kernels_.adjoint = Matrix(densityRows_.size(), kernels_.start.back());
  if (elements.empty())
    return;
  const FarTractionRows far(space, lame, algebra);
  const auto count = static_cast<int>(elements.size());
#pragma omp parallel
  {
    NearMoments near;
    const auto moments = std::make_unique<TileMoments>();
#pragma omp for schedule(dynamic, 4)
    for (int k = 0; k < count; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const int test = elements[at];
      far.write(test, mesh[test].degree + 1, largestSmoothOrder, kernels_.start[at],
                kernels_.hypersingular, kernels_.adjoint);
      for (const int source : nearSources(far.runs(), test)) {
        near.evaluate(mesh, test, source, *moments, 0);
        addPair(test, source, kernels_.start[at], *moments);
      }
    }
  }
}

void ProjectedTractions::addHypersingular(int source, int j, Index column,
                                          const Block& block) {
  const auto [first, last] = DisplacementBasis::withDerivative(j);
  for (int k = first; k <= last; ++k)
    addBlock(kernels_.hypersingular, displacementRows_, space_.displacement(source, k, 0),
             column, DisplacementBasis::slope(k) * block);
}

void ProjectedTractions::addPair(int test, int source, Index first,
                                 const TileMoments& m) {
  const Element& x = space_.mesh()[test];
  const Element& y = space_.mesh()[source];
  const EndMoments start = endMoments(space_.mesh(), source, space_.mesh().at(test, -1));
  const EndMoments end = endMoments(space_.mesh(), source, space_.mesh().at(test, 1));
  const bool onLine = x.piece.edge == y.piece.edge && x.curve.isStraight();
  const Complex tangent = asComplex(y.curve.frame().tangent);
  for (int j = 0; j < y.degree; ++j) {
    const auto at = static_cast<std::size_t>(j);
    const Index density = space_.density(source, j, 0);
    // P_i' = (2i-1) P_{i-1} + (2i-5) P_{i-3} + ...: sums for odd and even i.  The
    // constant part of d d'/r² cancels between these sums and the ends.
    double log[2] = {start.log[at] - end.log[at], -start.log[at] - end.log[at]};
    Complex phase[2] = {start.phase[at] - end.phase[at],
                        -start.phase[at] - end.phase[at]};
    for (int i = 0; i <= x.degree; ++i) {
      double& l = log[i % 2];
      Complex& c = phase[i % 2];
      if (i > 0) {
        l += (2 * i - 1) * m.log[(i - 1) * TileMoments::stride + j][0];
        c += (2 * i - 1.0) * m.phase(i - 1, j, 0, tangent);
      }
      const double scale = std::sqrt((2 * i + 1) / (2 * x.half));
      const Index column = first + 2 * i;
      const PotentialMoments<double> potentials{l, c.real(), c.imag(), 0};
      addHypersingular(source, j, column,
                       scale * singleLayerBlock(lame_.d, lame_.d, potentials));

      const double laplace = onLine ? 0 : m.reverse[i * TileMoments::stride + j][0];
      Block adjoint = doubleLayerBlock(lame_, potentials, laplace);
      if (test == source && i == j) {  // 1/2 <P_i, P_i>
        adjoint.xx += 1.0 / (2 * i + 1);
        adjoint.yy += 1.0 / (2 * i + 1);
      }
      addBlock(kernels_.adjoint, densityRows_, density, column, scale * y.half * adjoint);
    }
  }
}

}  // namespace epafi::bem
