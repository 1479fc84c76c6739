// The compressed system: its entries are those of the operators, every cluster's skeleton
// stands for it before everything else, products and solutions are the dense ones.
#include "Algebra.hpp"
#include "bem/algebra/Blas.hpp"
#include "bem/base/Error.hpp"
#include "bem/compressed/CompressedFactor.hpp"
#include "bem/compressed/CoupledEntries.hpp"
#include "bem/compressed/Products.hpp"
#include "bem/operators/Entries.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace epafi::reference {

namespace {

using bem::at;
using bem::Index;
using bem::Matrix;

struct Case {
  std::string name;
  bem::Mesh mesh;
  double nu = 0.3;
};

std::shared_ptr<const bem::Outline> outlineOf(const bem::Loop& loop) {
  return std::make_shared<const bem::Outline>(loop);
}

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
    fractions.push_back(1 - fractions[static_cast<std::size_t>(k)]);
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

std::vector<Case> cases() {
  return {
      {"uniform", bem::makeMesh(outlineOf(square()), {48, 48, 48, 48}, 1)},
      {"nearly incompressible", bem::makeMesh(outlineOf(square()), {32, 32, 32, 32}, 1),
       0.4999},
      {"graded", cutAlike(outlineOf(square()), graded(24, 1e-8), {1})},
      {"rough", cutAlike(outlineOf(roughSquare(60)), even(2), {1})},
      {"hp with a hole", cutAlike(squareWithHole(), graded(4, 1e-3), {1, 12, 3, 2, 7})},
      {"arcs", bem::makeMesh(outlineOf(disc(4, 1)), {20, 20, 20, 20}, 2)},
      {"curved", cutAlike(outlineOf(curvedSample()), even(5), {1, 3})},
  };
}

/// The whole system by its entries.
Matrix wholeSystem(const bem::Space& space, const bem::Lame& lame) {
  const std::vector<bem::Unknown> unknowns = bem::unknownsOf(space);
  const bem::ClusterTree tree(space, 60);
  const std::vector<char> everywhere(at(space.mesh().size()), 1);
  const bem::NearBlocks near(space, lame, tree, everywhere, everywhere);
  bem::CoupledEntries entries(space, lame, near, unknowns);
  std::vector<Index> all(unknowns.size());
  std::iota(all.begin(), all.end(), 0);
  return entries(all, all);
}

/// Pᵀ Z P: with arcs, displacements hold the rotation exactly.
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

double largest(const Matrix& a) {
  double size = 0;
  for (Index j = 0; j < a.columns(); ++j)
    for (Index i = 0; i < a.rows(); ++i)
      size = std::abs(a(i, j)) <= size ? size : std::abs(a(i, j));
  return size;
}

// Of pairs whose gap is the limit between near and far rounding decides.  Whatever it says, both
// elements of a hat must be taken alike, also those where the loop closes.
TEUCHOS_UNIT_TEST(Compressed, rigidMotionsMakeNoTractionsAtTheLimitOfNearness) {
  const bem::Lame lame({1, 0.3, false});
  double worst = 0;
  for (int k = 1; k <= 64; ++k) {
    const double height = 0.6 + 0.01 * k;
    // the gap between the first element and the third is half of that
    const bem::Space space(
        cutAlike(outlineOf(polygon({{0, 0}, {1, 0}, {1, height}, {0, height}})),
                 {0.003125, 0.00625, 0.0125, 0.25, 0.5, 0.75, 0.9875, 0.996875}, {1}));
    const bem::CompressedOperators z(space, lame, smallLeaves(), {}, test::algebra());
    const Matrix rigid = space.rigidMotions();
    Matrix motions(z.size(), rigid.columns());
    for (Index j = 0; j < rigid.columns(); ++j)
      std::copy_n(rigid.column(j), rigid.rows(), motions.column(j));
    worst = std::max(worst, largest(z.times(motions)));
  }
  TEST_COMPARE(worst, <, 1e-11);
}

TEUCHOS_UNIT_TEST(Compressed, entriesAreThoseOfTheOperators) {
  for (const Case& sample : cases()) {
    const bem::Space space(sample.mesh);
    const bem::Lame lame({1, sample.nu, false});
    const Matrix z = wholeSystem(space, lame);
    std::vector<int> elements(static_cast<std::size_t>(sample.mesh.size()));
    std::iota(elements.begin(), elements.end(), 0);
    const bem::EntryBlocks blocks = bem::entries(space, lame, elements, elements);
    const Index n = space.displacements();
    double v = 0;
    double k = 0;
    double w = 0;
    double skew = 0;
    for (Index j = 0; j < z.columns(); ++j)
      for (Index i = 0; i < z.rows(); ++i) {
        skew = std::max(skew, std::abs(z(i, j) - z(j, i)));
        if (i < n && j < n)
          w = std::max(w, std::abs(z(i, j) - blocks.hypersingular(i, j)));
        else if (i >= n && j >= n)
          v = std::max(v, std::abs(z(i, j) + blocks.singleLayer(i - n, j - n)));
        else if (i >= n)
          k = std::max(k, std::abs(z(i, j) - blocks.doubleLayer(i - n, j)));
      }
    out << sample.name << ": V " << v / largest(blocks.singleLayer) << ", K "
        << k / largest(blocks.doubleLayer) << ", W " << w / largest(blocks.hypersingular)
        << "\n";
    TEST_COMPARE(v, <, 1e-12 * largest(blocks.singleLayer));
    TEST_COMPARE(k, <, 1e-12 * largest(blocks.doubleLayer));
    TEST_COMPARE(w, <, 1e-12 * largest(blocks.hypersingular));
    TEST_COMPARE(skew, <, 1e-12 * largest(z));
  }
}

/// T of a cluster for all of its unknowns.
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

TEUCHOS_UNIT_TEST(Compressed, skeletonsStandForTheirClustersBeforeAllOthers) {
  for (const Case& sample : cases()) {
    const bem::Space space(sample.mesh);
    const bem::Lame lame({1, sample.nu, false});
    const Matrix whole = wholeSystem(space, lame);
    const bem::CompressedOperators z(space, lame, smallLeaves());
    const std::vector<bem::Unknown> unknowns = bem::unknownsOf(space);
    // functions of size one in L²
    bem::Vector scales;
    for (const bem::Unknown& u : unknowns)
      scales.push_back(1 / std::sqrt(2 * sample.mesh[u.element].half));
    double worst = 0;
    Index saved = 0;
    for (int c = 1; c < z.tree().size(); ++c) {
      std::vector<Index> own;
      const Matrix weights = nestedWeights(z, c, own);
      std::vector<Index> others;
      for (std::size_t i = 0; i < unknowns.size(); ++i)
        if (unknowns[i].element < z.tree()[c].first ||
            unknowns[i].element >= z.tree()[c].last)
          others.push_back(static_cast<Index>(i));
      const std::vector<Index>& skeleton = z.part(c).skeleton;
      saved += static_cast<Index>(own.size() - skeleton.size());
      Matrix kept(static_cast<Index>(others.size()), weights.rows());
      for (Index j = 0; j < kept.columns(); ++j)
        for (Index i = 0; i < kept.rows(); ++i)
          kept(i, j) = whole(others[at(i)], skeleton[at(j)]);
      const Matrix approximation = bem::product(kept, weights);
      double error = 0;
      double size = 0;
      for (std::size_t j = 0; j < own.size(); ++j)
        for (std::size_t i = 0; i < others.size(); ++i) {
          const double scale = scales[at(others[i])] * scales[at(own[j])];
          const double exact = whole(others[i], own[j]);
          size = std::max(size, scale * std::abs(exact));
          error = std::max(
              error, scale * std::abs(exact - approximation(static_cast<Index>(i),
                                                            static_cast<Index>(j))));
        }
      worst = std::max(worst, error / size);
    }
    out << sample.name << ": " << worst << ", " << saved << " unknowns saved\n";
    TEST_COMPARE(worst, <, 1e-11);
    TEST_COMPARE(saved, >, 0);
  }
}

Matrix oscillating(Index rows, Index columns) {
  Matrix x(rows, columns);
  for (Index j = 0; j < columns; ++j)
    for (Index i = 0; i < rows; ++i)
      x(i, j) = std::sin(1.7 * static_cast<double>(i * (j + 1)) + 0.3);
  return x;
}

double relativeDifference(const Matrix& a, const Matrix& b) {
  Matrix difference = a.copy();
  for (Index j = 0; j < a.columns(); ++j)
    for (Index i = 0; i < a.rows(); ++i)
      difference(i, j) -= b(i, j);
  return largest(difference) / largest(b);
}

TEUCHOS_UNIT_TEST(Compressed, productsAreTheDenseOnes) {
  for (const Case& sample : cases()) {
    const bem::Space space(sample.mesh);
    const bem::Lame lame({1, sample.nu, false});
    const bem::CompressedOperators z(space, lame, smallLeaves(), {}, test::algebra());
    const Matrix x = oscillating(z.size(), 3);
    const double error = relativeDifference(
        z.times(x), bem::product(rotated(wholeSystem(space, lame), space), x));
    out << sample.name << ": " << error << "\n";
    TEST_COMPARE(error, <, 1e-11);
  }
}

/// Tractions that change from element to element, and displacements likewise: <f, φ> and
/// <g, P>, without bubbles.
Matrix loads(const bem::Space& space) {
  Matrix b(space.displacements() + space.densities(), 2);
  for (int e = 0; e < space.mesh().size(); ++e)
    for (int c = 0; c < 2; ++c) {
      const double value = std::sin(1.7 * e + c) * space.mesh()[e].half;
      b(space.displacement(e, 0, c), 0) += value;
      b(space.displacement(e, 1, c), 0) += value;
      b(space.displacements() + space.density(e, 0, c), 1) = 2 * value;
    }
  return b;
}

/// Of the kept equations, by pivoted elimination, unknowns and equations scaled by their
/// diagonal entries.
Matrix denseSolution(Matrix z, const bem::Restriction& restriction, Matrix b) {
  for (const auto& entry : restriction.entries)
    z(entry.row, entry.column) += entry.value;
  std::vector<Index> kept;
  for (Index i = 0; i < z.rows(); ++i)
    if (restriction.held[at(i)] == 0)
      kept.push_back(i);
  const int n = static_cast<int>(kept.size());
  Matrix a(n, n);
  bem::Vector scales;
  for (const Index i : kept)
    scales.push_back(z(i, i) == 0 ? 1 : 1 / std::sqrt(std::abs(z(i, i))));
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
      a(i, j) = z(kept[at(i)], kept[at(j)]);
  for (const auto& follower : restriction.followers)
    for (Index j = 0; j < n; ++j)
      if (kept[at(j)] == follower.leader)
        for (Index i = 0; i < n; ++i)
          a(i, j) += follower.factor * z(kept[at(i)], follower.unknown);
  Matrix right = bem::rowsOf(b, kept);
  const auto scale = [&](Matrix& x) {
    for (Index j = 0; j < x.columns(); ++j)
      for (Index i = 0; i < n; ++i)
        x(i, j) *= scales[at(i)];
  };
  scale(a);
  scale(right);
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
      a(i, j) *= scales[at(j)];
  const int columns = static_cast<int>(b.columns());
  const int lda = static_cast<int>(a.stride());
  const int ldb = static_cast<int>(right.stride());
  std::vector<int> pivots(kept.size());
  int info = 0;
  dgesv_(&n, &columns, a.data(), &lda, pivots.data(), right.data(), &ldb, &info);
  scale(right);
  Matrix x(b.rows(), columns);
  bem::putRows(right, kept, x);
  for (const auto& follower : restriction.followers)
    for (Index j = 0; j < columns; ++j)
      x(follower.unknown, j) = follower.factor * x(follower.leader, j);
  return x;
}

/// Displacements of some elements are held: a clamp.
bem::Restriction clamped(const bem::Space& space, int first, int last) {
  bem::Restriction restriction;
  restriction.held.resize(at(space.displacements() + space.densities()));
  for (int e = first; e < last; ++e)
    for (int k = 0; k <= space.mesh()[e].degree; ++k)
      for (int c = 0; c < 2; ++c)
        restriction.held[at(space.displacement(e, k, c))] = 1;
  return restriction;
}

/// (<W u, u> + <V ψ, ψ>)^½, of all columns together.
double energyNorm(const Matrix& whole, Index displacements, const Matrix& x) {
  Matrix parts(x.rows(), 2 * x.columns());
  for (Index j = 0; j < x.columns(); ++j)
    for (Index i = 0; i < x.rows(); ++i)
      parts(i, 2 * j + (i < displacements ? 0 : 1)) = x(i, j);
  const Matrix images = bem::product(whole, parts);
  double square = 0;
  for (Index j = 0; j < parts.columns(); ++j)
    for (Index i = 0; i < x.rows(); ++i)
      square += j % 2 == 0 ? parts(i, j) * images(i, j) : -parts(i, j) * images(i, j);
  return std::sqrt(std::abs(square));
}

TEUCHOS_UNIT_TEST(Compressed, solutionsAreTheDenseOnes) {
  for (const Case& sample : cases()) {
    const bem::Space space(sample.mesh);
    const bem::Lame lame({1, sample.nu, false});
    const Matrix whole = rotated(wholeSystem(space, lame), space);
    const bem::CompressedOperators z(space, lame, smallLeaves(), {}, test::algebra());
    const Matrix b = loads(space);
    const bem::Restriction clamp = clamped(space, 0, sample.mesh.size() / 5);
    const bem::Restriction dirichlet = clamped(space, 0, sample.mesh.size());
    bem::Restriction sprung;
    sprung.held.resize(at(z.size()));
    for (const int e : {0, sample.mesh.size() / 2})
      for (int c = 0; c < 2; ++c)
        sprung.entries.push_back(
            {space.displacement(e, 0, c), space.displacement(e, 0, c), 1.0});
    // one component in the other's equation, but not the other way
    bem::Restriction skew = clamp;
    skew.entries = {{space.displacement(sample.mesh.size() - 1, 0, 1),
                     space.displacement(sample.mesh.size() - 1, 0, 0), 0.3}};
    bem::Restriction following = clamp;
    const int last = sample.mesh.size() - 1;
    following.held[at(space.displacement(last, 0, 0))] = 1;
    following.followers = {
        {space.displacement(last, 0, 0), space.displacement(last, 0, 1), 0.4}};
    for (const bem::Restriction& restriction :
         {clamp, dirichlet, sprung, skew, following}) {
      const bem::CompressedFactor factor(z, restriction);
      const Matrix exact = denseSolution(whole.copy(), restriction, b.copy());
      const Matrix x = factor.solve(b);
      Matrix difference = x.copy();
      for (Index j = 0; j < 2; ++j)
        for (Index i = 0; i < b.rows(); ++i)
          difference(i, j) -= exact(i, j);
      const double error = energyNorm(whole, space.displacements(), difference);
      const double size = energyNorm(whole, space.displacements(), exact);
      out << sample.name << ": " << error / size << "\n";
      TEST_COMPARE(error, <, 1e-9 * size);
    }
  }
}

/// The outer loop is a cluster of its own, which nothing holds.
TEUCHOS_UNIT_TEST(Compressed, bodiesMayBeHeldAtTheirHolesAlone) {
  const auto outline = squareWithHole();
  const bem::Mesh mesh =
      bem::makeMesh(outline, std::vector<int>(outline->edges().size(), 24), 1);
  const bem::Space space(mesh);
  const bem::Lame lame({1, 0.3, false});
  const bem::CompressedOperators z(space, lame, smallLeaves(), {}, test::algebra());
  const bem::Restriction clamp = clamped(space, 4 * 24, mesh.size());
  const Matrix b = loads(space);
  const Matrix exact = denseSolution(wholeSystem(space, lame), clamp, b.copy());
  const bem::CompressedFactor factor(z, clamp);
  const double error = relativeDifference(factor.solve(b, 0), exact);
  TEST_COMPARE(error, <, 1e-9);
}

TEUCHOS_UNIT_TEST(Compressed, changedRestrictionsAreEliminatedWhereTheyChange) {
  const bem::Space space(bem::makeMesh(outlineOf(square()), {48, 48, 48, 48}, 1));
  const bem::Lame lame({1, 0.3, false});
  const bem::CompressedOperators z(space, lame, smallLeaves(), {}, test::algebra());
  const Matrix b = oscillating(z.size(), 1);
  const bem::Restriction before = clamped(space, 0, 48);
  const bem::Restriction after = clamped(space, 0, 50);
  bem::CompressedFactor factor(z, before);
  const int changed = factor.update(after);
  TEST_COMPARE(changed, <=, z.tree().levels() + 2);
  TEST_COMPARE(changed, >, 1);
  TEST_COMPARE(
      relativeDifference(factor.solve(b), bem::CompressedFactor(z, after).solve(b)), <,
      1e-13);
  TEST_EQUALITY(factor.update(after), 0);
}

/// A process that has a part of the tree alone, and one that has all of it: the same bits.
TEUCHOS_UNIT_TEST(Compressed, processesTogetherAreOne) {
  const bem::Space space(bem::makeMesh(outlineOf(square()), {48, 48, 48, 48}, 1));
  const bem::Lame lame({1, 0.3, false});
  const bem::CompressedOperators alone(space, lame, smallLeaves());
  const bem::CompressedOperators z(space, lame, smallLeaves(), {}, test::algebra());
  const Matrix x = oscillating(z.size(), 2);
  TEST_EQUALITY(relativeDifference(z.times(x), alone.times(x)), 0);
  // leaves at the end of a side, and a side
  for (const int last : {54, 96}) {
    std::vector<int> leaves;
    for (int e = 48; e < last; ++e)
      leaves.push_back(z.leafOf(space.displacement(e, 0, 0)));
    const bem::Restriction clamp = clamped(space, 0, 48);
    bem::Restriction changed = clamp;
    changed.held[at(space.displacement(50, 0, 1))] = 1;
    changed.held[at(space.displacement(last - 2, 0, 0))] = 1;
    const auto made = [&](const bem::CompressedOperators& from) {
      bem::CompressedFactor factor = bem::CompressedFactor(from, clamp).within(leaves);
      factor.update(changed);
      return factor;
    };
    const bem::CompressedFactor one = made(alone);
    const bem::CompressedFactor several = made(z);
    Matrix b(z.size(), 2);
    for (int e = 49; e < last; ++e)
      b(space.displacement(e, 0, 0), e % 2) = std::sin(1.7 * e);
    const std::vector<char> paths = one.paths(leaves);
    TEST_ASSERT(paths == several.paths(leaves));
    TEST_EQUALITY(
        relativeDifference(several.solveAlong(paths, b), one.solveAlong(paths, b)), 0);
    TEST_ASSERT(several.lastPivots() == one.lastPivots());
  }
  if (test::algebra().processes() > 1)
    TEST_COMPARE(z.bytes(), <, alone.bytes());
}

/// A leaf that one process alone has is singular: all of them say so, and go on.
TEUCHOS_UNIT_TEST(Compressed, singularLeavesAreEverybodys) {
  const bem::Space space(bem::makeMesh(outlineOf(square()), {48, 48, 48, 48}, 1));
  const bem::Lame lame({1, 0.3, false});
  bem::LocalCoupling local;
  local.elements = {100};
  local.entries = {
      {space.displacement(100, 0, 0), space.displacements() + space.densities(), 1}};
  const bem::CompressedOperators z(space, lame, smallLeaves(), local, test::algebra());
  bem::Restriction clamp = clamped(space, 0, 48);
  clamp.held.resize(at(z.size()));
  bem::Restriction all;
  all.held.assign(at(z.size()), 1);
  all.held.back() = 0;
  TEST_THROW(bem::CompressedFactor(z, all), bem::NumericalError);
  clamp.held.back() = 1;
  const Matrix b = oscillating(z.size(), 1);
  TEST_COMPARE(largest(bem::CompressedFactor(z, clamp).solve(b)), >, 0);
}

/// Two squares of different stiffness, the upper side of the first along the lower side of the
/// second, and further unknowns of the first that act on both.
struct Pair {
  bem::Space first;
  bem::Space second;
  bem::Lame soft{bem::Material{1, 0.3, false}, 1.0};
  bem::Lame stiff{bem::Material{1000, 0.2, false}, 1.0};
  bem::LocalCoupling local;
  Matrix whole;

  Pair()
      : first(bem::makeMesh(outlineOf(square()), {24, 40, 24, 24}, 1)),
        second(bem::makeMesh(outlineOf(square()), {16, 16, 16, 30}, 2)) {
    couple();
    const Matrix a = wholeSystem(first, soft);
    const Matrix b = wholeSystem(second, stiff);
    const Index n = a.rows() + b.rows();
    whole = Matrix(n + static_cast<Index>(local.elements.size()),
                   n + static_cast<Index>(local.elements.size()));
    for (Index j = 0; j < a.columns(); ++j)
      std::copy_n(a.column(j), a.rows(), whole.column(j));
    for (Index j = 0; j < b.columns(); ++j)
      std::copy_n(b.column(j), b.rows(), whole.column(a.rows() + j) + a.rows());
    for (const auto& entry : local.entries) {
      whole(entry.row, entry.column) += entry.value;
      whole(entry.column, entry.row) += entry.value;
    }
  }

  Index size() const { return whole.rows(); }
  Index split() const { return first.displacements() + first.densities(); }

 private:
  // elements 24 to 63 of the first against 48 to 77 of the second, from the other end
  void couple() {
    const Index further = split() + second.displacements() + second.densities();
    const auto meets = [&](int e) { return 77 - (e - 24) * 30 / 40; };
    for (int e = 24; e < 64; ++e)
      for (int c = 0; c < 2; ++c) {
        const Index k = further + static_cast<Index>(local.elements.size());
        local.elements.push_back(e);
        local.bodies.push_back(0);
        const double h = first.mesh()[e].half;
        local.entries.push_back({first.displacement(e, 0, c), k, h});
        local.entries.push_back({first.displacement(e, 1, c), k, 0.4 * h});
        for (const int i : {0, 1, 2})
          local.entries.push_back(
              {split() + second.displacement(meets(e), i, c), k, -(0.6 - 0.2 * i) * h});
      }
  }
};

TEUCHOS_UNIT_TEST(Compressed, bodiesThatFaceEachOtherAreCutTogether) {
  const Pair pair;
  const bem::CompressedOperators z({{pair.first, pair.soft}, {pair.second, pair.stiff}},
                                   smallLeaves(), pair.local);
  // what is one over its diagonal entry is of one size
  bem::Vector scales;
  for (Index i = 0; i < pair.size(); ++i)
    scales.push_back(i < pair.split() ? 1 : i < z.range(1).densities ? 0.03 : 30);
  double worst = 0;
  std::size_t most = 0;
  for (int c = 1; c < z.tree().size(); ++c) {
    std::vector<Index> own;
    const Matrix weights = nestedWeights(z, c, own);
    const std::vector<Index>& skeleton = z.part(c).skeleton;
    std::vector<char> isOwn(at(pair.size()));
    for (const Index i : own)
      isOwn[at(i)] = 1;
    double error = 0;
    double size = 0;
    for (Index i = 0; i < pair.size(); ++i)
      for (std::size_t j = 0; j < own.size() && isOwn[at(i)] == 0; ++j) {
        double sum = pair.whole(i, own[j]);
        size = std::max(size, scales[at(i)] * scales[at(own[j])] * std::abs(sum));
        for (std::size_t k = 0; k < skeleton.size(); ++k)
          sum -= pair.whole(i, skeleton[k]) *
                 weights(static_cast<Index>(k), static_cast<Index>(j));
        error = std::max(error, scales[at(i)] * scales[at(own[j])] * std::abs(sum));
      }
    worst = std::max(worst, error / size);
    // what acts across the cluster's end; all 80 where a side is alone
    std::set<Index> across;
    for (const auto& entry : pair.local.entries)
      if (isOwn[at(entry.column)] != 0 && isOwn[at(entry.row)] == 0 &&
          entry.row >= pair.split())
        across.insert(entry.column);
    most = std::max(most, across.size());
  }
  out << "clusters " << worst << ", across " << most << "\n";
  TEST_COMPARE(worst, <, 1e-11);
  TEST_COMPARE(most, <=, 8);

  const bem::CompressedOperators shared(
      {{pair.first, pair.soft}, {pair.second, pair.stiff}}, smallLeaves(), pair.local,
      test::algebra());
  Matrix x = oscillating(pair.size(), 2);
  for (Index j = 0; j < 2; ++j)
    for (Index i = 0; i < pair.size(); ++i)
      x(i, j) *= scales[at(i)];
  const auto scaled = [&](Matrix a, double power) {
    for (Index j = 0; j < a.columns(); ++j)
      for (Index i = 0; i < a.rows(); ++i)
        a(i, j) *= std::pow(scales[at(i)], power);
    return a;
  };
  TEST_COMPARE(relativeDifference(scaled(shared.times(x), 1),
                                  scaled(bem::product(pair.whole, x), 1)),
               <, 1e-11);

  // the lower side of the first and the upper one of the second held: 0 to 23, 16 to 31
  bem::Restriction clamp = clamped(pair.first, 0, 24);
  clamp.held.resize(at(pair.size()));
  const bem::Restriction above = clamped(pair.second, 16, 32);
  std::copy(above.held.begin(), above.held.end(),
            clamp.held.begin() + static_cast<std::ptrdiff_t>(pair.split()));
  const Matrix b = scaled(oscillating(pair.size(), 1), -1);
  bem::CompressedFactor factor(shared, clamp);
  const double error =
      relativeDifference(scaled(factor.solve(b), -1),
                         scaled(denseSolution(pair.whole.copy(), clamp, b.copy()), -1));
  out << "solution " << error << "\n";
  TEST_COMPARE(error, <, 1e-8);
}

}  // namespace

}  // namespace epafi::reference
