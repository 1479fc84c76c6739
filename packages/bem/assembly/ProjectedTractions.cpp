#include "bem/assembly/ProjectedTractions.hpp"

#include "bem/assembly/Block.hpp"
#include "bem/assembly/MyElements.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace epafi::bem {

namespace {

constexpr double inverse2Pi = 0.15915494309189533577;

}  // namespace

ProjectedTractions::ProjectedTractions(const Space& space, const Lame& lame,
                                       const DenseAlgebra& algebra,
                                       const std::vector<int>& elements)
    : space_(space),
      lame_(lame),
      densityRows_(algebra.myRows(space.densities())),
      displacementRows_(algebra.myRows(space.displacements())),
      sourceAt_(static_cast<std::size_t>(space.mesh().size()), notMine),
      tests_(static_cast<std::size_t>(space.mesh().size())) {
  const Mesh& mesh = space.mesh();
  kernels_.elements = elements;
  kernels_.start.assign(1, 0);
  for (const int e : elements) {
    tests_[static_cast<std::size_t>(e)].column = kernels_.start.back();
    kernels_.start.push_back(kernels_.start.back() + 2 * (mesh[e].degree + 1));
  }
  kernels_.hypersingular = Matrix(displacementRows_.size(), kernels_.start.back());
  kernels_.adjoint = Matrix(densityRows_.size(), kernels_.start.back());
  for (int k = 0; k <= largestDegree; ++k)
    slopes_[static_cast<std::size_t>(k)] = DisplacementBasis::slope(k);
  // whole batches, so that results do not depend on the number of processes
  const MyElements mine(space, algebra);
  std::size_t at = 0;
  for (int first = 0; first < mesh.size(); first += lanes) {
    const int last = std::min(first + lanes, mesh.size());
    bool isMine = false;
    for (int f = first; f < last; ++f)
      isMine = isMine || mine.contain(f);
    for (int f = first; isMine && f < last; ++f) {
      sources_.push_back(f);
      sourceAt_[static_cast<std::size_t>(f)] = at;
      at += static_cast<std::size_t>(mesh[f].degree);
    }
  }
  chooseNodes();
}

// Neighbours share a node, but not across a vertex: there each sees the point on its own
// edge, where the phase is exact.
void ProjectedTractions::chooseNodes() {
  const Mesh& mesh = space_.mesh();
  std::map<std::pair<int, int>, std::size_t> numbers;
  std::vector<BoundaryPoint> places;
  const auto number = [&](int e, int node, double t) {
    const auto [entry, isNew] =
        numbers.emplace(std::pair{mesh[e].piece.edge, node}, places.size());
    if (isNew)
      places.push_back(mesh.at(e, t));
    return entry->second;
  };
  for (const int e : kernels_.elements) {
    Test& test = tests_[static_cast<std::size_t>(e)];
    test.startNode = number(e, mesh[e].startNode, -1);
    test.endNode = number(e, mesh[e].endNode, 1);
  }
  nodes_.resize(places.size());
  const auto count = static_cast<int>(places.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (int k = 0; k < count; ++k)
    nodes_[static_cast<std::size_t>(k)] =
        nodeMoments(mesh, places[static_cast<std::size_t>(k)], sources_);
}

template <class Moments>
void ProjectedTractions::addTest(int test, int source, const Moments& m) {
  const Element& x = space_.mesh()[test];
  const Element& y = space_.mesh()[source];
  const Test& place = tests_[static_cast<std::size_t>(test)];
  const NodeMoments& start = nodes_[place.startNode];
  const NodeMoments& end = nodes_[place.endNode];
  const bool sameEdge = x.piece.edge == y.piece.edge;
  const double ofLog = 2 * lame_.mu * (1 - 2 * lame_.nu) * lame_.b;
  const double ofPhase = lame_.mu * lame_.b;
  for (int j = 0; j < y.degree; ++j) {
    const std::size_t at =
        sourceAt_[static_cast<std::size_t>(source)] + static_cast<std::size_t>(j);
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
        l += (2 * i - 1) * m.log(i - 1, j);
        c += (2 * i - 1.0) * Complex(m.phaseReal(i - 1, j), m.phaseImag(i - 1, j));
      }
      const double scale = std::sqrt((2 * i + 1) / (2 * x.half));
      const Index column = place.column + 2 * i;

      const double re = 0.5 * c.real();
      const double im = 0.5 * c.imag();
      const Block hyper = scale * lame_.d * Block{re - l, im, im, -re - l};
      for (int k = j == 0 ? 0 : j + 1; k <= (j == 0 ? 1 : j + 1); ++k)
        addBlock(kernels_.hypersingular, displacementRows_,
                 space_.displacement(source, k, 0), column,
                 slopes_[static_cast<std::size_t>(k)] * hyper);

      double laplace = sameEdge ? 0 : inverse2Pi * m.reverse(i, j);
      if (test == source && i == j)
        laplace = 1.0 / (2 * i + 1);  // 1/2 <P_i, P_i>; the double layer is zero
      // -X J e_x = (X_xy, X_yy),  -X J e_y = (-X_xx, -X_xy)
      const double xx = ofPhase * c.real() - ofLog * l;
      const double xy = ofPhase * c.imag();
      const double yy = -ofPhase * c.real() - ofLog * l;
      addBlock(kernels_.adjoint, densityRows_, density, column,
               scale * y.half * Block{xy + laplace, yy, -xx, laplace - xy});
    }
  }
}

void ProjectedTractions::add(int e, int f, const PairMoments& moments) {
  if (tests_[static_cast<std::size_t>(e)].column >= 0 && isMine(f))
    addTest(e, f, MomentsAsTheyAre{moments});
  if (e != f && tests_[static_cast<std::size_t>(f)].column >= 0 && isMine(e))
    addTest(f, e, MomentsSwapped{moments});
}

}  // namespace epafi::bem
