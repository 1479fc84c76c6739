#include "CompressedSamples.hpp"

#include "Largest.hpp"
#include "bem/algebra/LuFactor.hpp"
#include "bem/algebra/Products.hpp"
#include "bem/compressed/CoupledEntries.hpp"

#include <cmath>
#include <numeric>

namespace epafi::reference {

using bem::Index;
using bem::Matrix;
using test::largest;

namespace {

/// Cuts of all edges at the same fractions.
bem::Mesh cutAlike(const std::shared_ptr<const bem::Outline>& outline,
                   const std::vector<double>& fractions,
                   const std::vector<int>& degrees) {
  std::vector<Cuts> cuts;
  for (std::size_t edge = 0; edge < outline->edges().size(); ++edge)
    cuts.push_back({static_cast<int>(edge), fractions});
  return cutMesh(outline, cuts, degrees);
}

std::vector<double> even(int elements) {
  std::vector<double> fractions;
  for (int k = 1; k < elements; ++k)
    fractions.push_back(static_cast<double>(k) / elements);
  return fractions;
}

/// Towards both ends, down to `smallest` of the length.
std::vector<double> graded(int steps, double smallest) {
  std::vector<double> fractions;
  for (int k = 0; k <= steps; ++k)
    fractions.push_back(0.5 * std::pow(2 * smallest, 1 - static_cast<double>(k) / steps));
  for (int k = steps - 1; k >= 0; --k)
    fractions.push_back(1 - fractions[k]);
  return fractions;
}

/// A square whose upper side goes up and down.
bem::Loop roughSquare(int teeth) {
  std::vector<bem::Vec2> vertices = {{-0.5, -0.5}, {0.5, -0.5}};
  for (int k = 0; k <= teeth; ++k)
    vertices.push_back({0.5 - static_cast<double>(k) / teeth,
                        0.5 + 0.01 * std::sin(2.3 * k) + 0.02 * std::sin(0.4 * k * k)});
  return polygon(vertices);
}

std::shared_ptr<const bem::Outline> solid(const bem::Loop& loop) {
  return std::make_shared<const bem::Outline>(loop, std::vector<bem::Loop>{},
                                              bem::scalingOf(loop, true));
}

/// Of revolution, the first edge on the axis: a cylinder that widens upwards.
bem::Loop bowl() { return polygon({{0, 1.5}, {0, 0}, {1, 0.3}, {1.2, 1.2}}); }

bem::Loop hollowBall() {
  bem::Loop loop = polygon({{0, 2}, {0, 1}, {1, 0}, {0, -1}, {0, -2}, {2, 0}});
  const double quarter = std::tan(std::acos(-1.0) / 8);
  loop.bulges = {0, -quarter, -quarter, 0, quarter, quarter};
  return loop;
}

bem::Loop ring() { return polygon({{0.3, 0}, {0.6, 0}, {0.6, 0.2}, {0.3, 0.2}}); }

/// So many elements on all edges but those on the axis.
bem::Mesh cutOffAxis(const bem::Loop& loop, int elements, int degree) {
  const auto outline = solid(loop);
  std::vector<int> counts;
  for (int k = 0; k < static_cast<int>(loop.vertices.size()); ++k)
    counts.push_back(outline->isAxis(k) ? 1 : elements);
  return bem::makeMesh(outline, counts, degree);
}

/// Holes in rows, of two arcs each.
std::shared_ptr<const bem::Outline> roundHoles(int rows) {
  std::vector<bem::Loop> holes;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < rows; ++j) {
      holes.push_back(disc(2, 0.15 / rows));
      for (bem::Vec2& vertex : holes.back().vertices)
        vertex = vertex + bem::Vec2{(i + 0.5) / rows, (j + 0.5) / rows};
    }
  return std::make_shared<const bem::Outline>(square(), holes);
}

}  // namespace

std::vector<CompressedSample> compressedSamples() {
  return {
      {"uniform", bem::makeMesh(outlineOf(square()), {48, 48, 48, 48}, 1)},
      {"nearly incompressible", bem::makeMesh(outlineOf(square()), {32, 32, 32, 32}, 1),
       0.4999},
      {"graded", cutAlike(outlineOf(square()), graded(24, 1e-8), {1})},
      {"rough", cutAlike(outlineOf(roughSquare(60)), even(2), {1})},
      {"hp with a hole", cutAlike(squareWithHole(), graded(4, 1e-3), {1, 12, 3, 2, 7})},
      {"arcs", bem::makeMesh(outlineOf(disc(4, 1)), {20, 20, 20, 20}, 2)},
      {"half circles", cutAlike(roundHoles(5), even(1), {1})},
      {"curved", cutAlike(outlineOf(curvedSample()), even(5), {1, 3})},
      {"bowl", cutOffAxis(bowl(), 48, 1)},
      {"hollow ball", cutOffAxis(hollowBall(), 24, 2), 0.4999},
      {"graded ring", cutAlike(solid(ring()), graded(16, 1e-8), {1})},
      {"graded bowl",
       cutMesh(solid(bowl()),
               {{1, graded(8, 1e-6)}, {2, graded(8, 1e-4)}, {3, graded(8, 1e-6)}},
               {1, 7, 2, 3})},
  };
}

std::vector<std::shared_ptr<const bem::Kernel>> kernelsOf(
    const CompressedSample& sample) {
  const bem::Outline& outline = sample.mesh.outline();
  const auto elastic = bem::elasticKernel(outline, bem::Lame({1, sample.nu, false}));
  if (outline.isAxisymmetric())
    return {elastic};
  return {elastic, bem::laplaceKernel()};
}

Matrix wholeSystem(const bem::Space& space, const bem::Lame& lame) {
  return wholeSystem(space, *bem::elasticKernel(space.mesh().outline(), lame));
}

Matrix wholeSystem(const bem::Space& space, const bem::Kernel& kernel) {
  const std::vector<bem::Unknown> unknowns = bem::unknownsOf(space);
  const bem::ClusterTree tree(space, 60);
  const std::vector<char> everywhere(space.mesh().size(), 1);
  const bem::NearBlocks near(space, kernel, tree, everywhere, everywhere);
  bem::CoupledEntries entries(space, kernel, near, unknowns);
  std::vector<Index> all(unknowns.size());
  std::iota(all.begin(), all.end(), 0);
  return entries(all, all);
}

Matrix rotated(Matrix z, const bem::Space& space) {
  if (space.rotation() == nullptr)
    return z;
  const bem::Vector& r = space.rotation()->motion();
  const bem::Vector& q = space.rotation()->functional();
  for (const bool transposed : {false, true})
    for (Index i = 0; i < z.rows(); ++i) {
      const auto entry = [&](Index j) -> double& {
        return transposed ? z(j, i) : z(i, j);
      };
      double sum = 0;
      for (std::size_t j = 0; j < r.size(); ++j)
        sum += entry(static_cast<Index>(j)) * r[j];
      for (std::size_t j = 0; j < r.size(); ++j)
        entry(static_cast<Index>(j)) -= sum * q[j];
    }
  return z;
}

bem::Compression smallLeaves() {
  bem::Compression options;
  options.leafUnknowns = 60;
  return options;
}

Matrix nestedWeights(const bem::CompressedOperators& z, int c,
                     std::vector<Index>& unknowns) {
  const auto& part = z.part(c);
  if (z.tree()[c].isLeaf()) {
    unknowns.insert(unknowns.end(), part.active.begin(), part.active.end());
    return part.weights.full();
  }
  const Matrix first = nestedWeights(z, z.tree()[c].children[0], unknowns);
  const Matrix second = nestedWeights(z, z.tree()[c].children[1], unknowns);
  const Index split = first.rows();
  const Matrix left =
      bem::product(bem::columnsBetween(part.weights.full(), 0, split), first);
  const Matrix right = bem::product(
      bem::columnsBetween(part.weights.full(), split, part.weights.columns()), second);
  Matrix all(left.rows(), left.columns() + right.columns());
  for (Index j = 0; j < all.columns(); ++j)
    std::copy_n(j < left.columns() ? left.column(j) : right.column(j - left.columns()),
                all.rows(), all.column(j));
  return all;
}

Matrix oscillating(Index rows, Index columns) {
  Matrix x(rows, columns);
  for (Index j = 0; j < columns; ++j)
    for (Index i = 0; i < rows; ++i)
      x(i, j) = std::sin(1.7 * static_cast<double>(i * (j + 1)) + 0.3);
  return x;
}

Matrix denseSolution(Matrix z, const bem::Restriction& restriction, Matrix b) {
  for (const auto& entry : restriction.entries)
    z(entry.row, entry.column) += entry.value;
  std::vector<Index> kept;
  for (Index i = 0; i < z.rows(); ++i)
    if (restriction.held[i] == 0)
      kept.push_back(i);
  const auto n = static_cast<Index>(kept.size());
  Matrix a(n, n);
  bem::Vector scales;
  for (const Index i : kept)
    scales.push_back(z(i, i) == 0 ? 1 : 1 / std::sqrt(std::abs(z(i, i))));
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
      a(i, j) = z(kept[i], kept[j]);
  for (const auto& [follower, leader, factor] : restriction.followers)
    for (Index j = 0; j < n; ++j)
      if (kept[j] == leader)
        for (Index i = 0; i < n; ++i)
          a(i, j) += factor * z(kept[i], follower);
  Matrix right = bem::rowsOf(b, kept);
  const auto scale = [&](Matrix& x) {
    for (Index j = 0; j < x.columns(); ++j)
      for (Index i = 0; i < n; ++i)
        x(i, j) *= scales[i];
  };
  scale(a);
  scale(right);
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
      a(i, j) *= scales[j];
  const Index columns = b.columns();
  bem::LuFactor(std::move(a)).solve(right);
  scale(right);
  Matrix x(b.rows(), columns);
  bem::putRows(right, kept, x);
  for (const auto& [follower, leader, factor] : restriction.followers)
    for (Index j = 0; j < columns; ++j)
      x(follower, j) = factor * x(leader, j);
  return x;
}

bem::Restriction clamped(const bem::Space& space, int first, int last) {
  bem::Restriction restriction;
  restriction.held.resize(space.displacements() + space.densities());
  for (int e = 0; e < space.mesh().size(); ++e)
    for (int k = 0; k < 2 && space.mesh().isAxis(e); ++k)
      restriction.held[space.displacement(e, k, 0)] = 1;
  for (int e = first; e < last; ++e)
    for (int k = 0; k <= space.mesh()[e].degree; ++k)
      for (int c = 0; c < 2; ++c)
        restriction.held[space.displacement(e, k, c)] = 1;
  return restriction;
}

}  // namespace epafi::reference
