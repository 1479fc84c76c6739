#include "bem/tractions/ProjectedTractions.hpp"

#include "bem/base/Parallel.hpp"
#include "bem/moments/EndMoments.hpp"
#include "bem/moments/NearPairs.hpp"
#include "bem/tractions/FarTractionRows.hpp"

#include <cmath>
#include <memory>

namespace epafi::bem {

namespace {

constexpr int moments = 2;  // those of P_0 and P_1

}  // namespace

ProjectedTractions::ProjectedTractions(const Space& space, const Lame& lame,
                                       const std::vector<int>& elements)
    : space_(space), lame_(lame) {
  const Mesh& mesh = space.mesh();
  kernels_.elements = elements;
  kernels_.start.assign(1, 0);
  kernels_.lowest.assign(1, 0);
  if (elements.empty())
    return;
  for (std::size_t k = 0; k < elements.size(); ++k)
    raise(k);
  const Index columns = kernels_.lowest.back() + (space.rotation() == nullptr ? 0 : 1);
  kernels_.hypersingular = Matrix(space.displacements(), columns);
  kernels_.adjoint = Matrix(space.densities(), columns);
  const FarTractionRows far(space, lame);
  struct Workspace {
    NearMoments near;
    std::unique_ptr<TileMoments> tile = std::make_unique<TileMoments>();
  };
  const auto count = static_cast<Index>(elements.size());
  constexpr double ofSource = 200;  // ns
  parallelFor(
      {count, ofSource * count * mesh.size(), 4}, [] { return Workspace(); },
      [&](Workspace& own, Index k) {
        const int test = elements[at(k)];
        const Index first = kernels_.lowest[at(k)];
        const Index last = kernels_.lowest[at(k) + 1];
        far.write(test, static_cast<int>(last - first) / 2, largestSmoothOrder, first,
                  kernels_.hypersingular, kernels_.adjoint);
        for (const int source : far.near(test, largestSmoothOrder)) {
          own.near.evaluate(mesh, test, source, *own.tile, 0);
          addPair(test, source, first, last, *own.tile);
        }
      });
}

// φ_i = slope(i) (P_i - P_{i-2}) / (2i-1),  P̂_i = √((2i+1)/2h) P_i;  a hat is (P_0 + P_1) / 2
// before its node, (P_0 - P_1) / 2 behind it
void ProjectedTractions::raise(std::size_t k) {
  const Mesh& mesh = space_.mesh();
  const int element = kernels_.elements[k];
  const Element& e = mesh[element];
  const Index first = kernels_.start[k];
  const bool follows = k > 0 && e.previous == kernels_.elements[k - 1];
  for (int c = 0; c < 2 && follows; ++c) {
    const Index before = kernels_.start[k - 1] + c;
    const double ratio = mesh[e.previous].half / e.half;
    kernels_.raised.push_back({first + 2 + c,
                               {{before, std::sqrt(3 * ratio)},
                                {before + 2, std::sqrt(ratio)},
                                {first + c, std::sqrt(3.0)}},
                               space_.displacement(element, 0, c),
                               -std::sqrt(6 / e.half)});
  }
  for (int i = 2; i <= e.degree; ++i)
    for (int c = 0; c < 2; ++c) {
      const Index column = first + 2 * i + c;
      kernels_.raised.push_back({column,
                                 {{column - 4, std::sqrt((2 * i + 1) / (2 * i - 3.0))}},
                                 space_.displacement(element, i, c),
                                 std::sqrt((2 * i + 1) / (2 * e.half)) * (2 * i - 1) /
                                     DisplacementBasis::slope(i)});
    }
  kernels_.start.push_back(first + 2 * (e.degree + 1));
  kernels_.lowest.push_back(kernels_.lowest.back() + (follows ? 2 : 2 * moments));
}

void ProjectedTractions::addHypersingular(int source, int j, Index column,
                                          const Block& block) {
  const auto [first, last] = DisplacementBasis::withDerivative(j);
  for (int k = first; k <= last; ++k)
    addBlock(kernels_.hypersingular, space_.displacement(source, k, 0), column,
             DisplacementBasis::slope(k) * block);
}

void ProjectedTractions::addPair(int test, int source, Index first, Index last,
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
    // the constant part of d d'/r² cancels between P_1' = P_0 and the ends
    const double log[moments] = {start.log[at] - end.log[at],
                                 m.log[j][0] - start.log[at] - end.log[at]};
    const Complex phase[moments] = {
        start.phase[at] - end.phase[at],
        m.phase(0, j, 0, tangent) - start.phase[at] - end.phase[at]};
    for (int i = 0; first + 2 * i < last; ++i) {
      const Complex c = phase[i];
      const double scale = std::sqrt((2 * i + 1) / (2 * x.half));
      const Index column = first + 2 * i;
      const PotentialMoments<double> potentials{log[i], c.real(), c.imag(), 0};
      addHypersingular(source, j, column,
                       scale * singleLayerBlock(lame_.d, lame_.d, potentials));

      const double laplace = onLine ? 0 : m.reverse[i * TileMoments::stride + j][0];
      Block adjoint = doubleLayerBlock(lame_, potentials, laplace);
      if (test == source && i == j) {  // 1/2 <P_i, P_i>
        adjoint.xx += 1.0 / (2 * i + 1);
        adjoint.yy += 1.0 / (2 * i + 1);
      }
      addBlock(kernels_.adjoint, density, column, scale * y.half * adjoint);
    }
  }
}

}  // namespace epafi::bem
