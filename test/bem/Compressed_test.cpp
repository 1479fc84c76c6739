// Products and solutions of the compressed system are the dense ones, alone and on several
// processes.
#include "CompressedSamples.hpp"
#include "Largest.hpp"
#include "Processes.hpp"
#include "bem/algebra/Products.hpp"
#include "bem/base/Error.hpp"
#include "bem/compressed/NearBlocks.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>

namespace epafi::reference {

namespace {

using bem::Index;
using bem::Matrix;
using test::largest;

TEUCHOS_UNIT_TEST(Compressed, productsAreTheDenseOnes) {
  for (const CompressedSample& sample : compressedSamples()) {
    for (const auto& kernel : kernelsOf(sample)) {
      const bem::Space space(sample.mesh, kernel->components());
      const bem::CompressedOperators z({{space, kernel}}, smallLeaves(), {},
                                       test::processes());
      const Matrix x = oscillating(z.size(), 3);
      const double error = relativeDifference(
          z.times(x), bem::product(rotated(wholeSystem(space, *kernel), space), x));
      Index saved = 0;
      for (int c = 1; c < z.tree().size(); ++c)
        saved += static_cast<Index>(z.part(c).active.size()) -
                 static_cast<Index>(z.part(c).skeleton.size());
      out << sample.name << ", " << kernel->components() << " components: " << error
          << ", " << saved << " unknowns saved\n";
      TEST_COMPARE(error, <, 1e-11);
      TEST_COMPARE(saved, >, 0);
    }
  }
}

TEUCHOS_UNIT_TEST(Compressed, translationsCauseNothingWhateverTheTolerance) {
  for (const CompressedSample& sample : compressedSamples()) {
    for (const auto& kernel : kernelsOf(sample)) {
      const bem::Space space(sample.mesh, kernel->components());
      bem::Compression coarse = smallLeaves();
      coarse.tolerance = 1e-7;
      const bem::CompressedOperators z({{space, kernel}}, coarse, {}, test::processes());
      const int components = kernel->components();
      const int first = sample.mesh.outline().isAxisymmetric() ? components - 1 : 0;
      Matrix x(z.size(), components);
      for (int e = 0; e < sample.mesh.size(); ++e)
        for (int c = first; c < components; ++c)
          x(space.displacement(e, 0, c), c) = 1;
      const Matrix forces = z.times(x);
      double along = 0;  // at a node
      double all = 0;    // of all nodes
      for (int k = 0; k < components; ++k)
        for (int c = first; c < components; ++c) {
          double sum = 0;
          for (int e = 0; e < sample.mesh.size(); ++e) {
            const double force = forces(space.displacement(e, 0, c), k);
            sum += force;
            if (c == k)
              along = std::max(along, std::abs(force));
          }
          all = std::max(all, std::abs(sum));
        }
      out << sample.name << ", " << components << " components: " << along << ", " << all
          << '\n';
      TEST_COMPARE(along, <, 1e-11);
      TEST_COMPARE(all, <, 1e-13);
      double moved = 0;  // of K
      for (Index i = space.displacements(); i < z.size(); ++i)
        for (int c = first; c < components; ++c)
          moved = std::max(moved, std::abs(forces(i, c)));
      TEST_COMPARE(moved, <, 1e-13);
    }
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
  for (const CompressedSample& sample : compressedSamples()) {
    const bem::Space space(sample.mesh);
    const bem::Lame lame({1, sample.nu, false});
    const Matrix whole = rotated(wholeSystem(space, lame), space);
    const bem::CompressedOperators z(space, lame, smallLeaves(), {}, test::processes());
    const Matrix b = loads(space);
    const bem::Restriction clamp = clamped(space, 0, sample.mesh.size() / 5);
    const bem::Restriction dirichlet = clamped(space, 0, sample.mesh.size());
    bem::Restriction sprung = clamped(space, 0, 0);
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
    following.held[space.displacement(last, 0, 0)] = 1;
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
  const bem::CompressedOperators z(space, lame, smallLeaves(), {}, test::processes());
  const bem::Restriction clamp = clamped(space, 4 * 24, mesh.size());
  const Matrix b = loads(space);
  const Matrix exact = denseSolution(wholeSystem(space, lame), clamp, b.copy());
  const bem::CompressedFactor factor(z, clamp);
  const double error = relativeDifference(factor.solve(b, 0), exact);
  TEST_COMPARE(error, <, 1e-9);
}

/// So is the outer surface of a hollow ball, which ends on the axis.
TEUCHOS_UNIT_TEST(Compressed, ballsMayBeHeldInTheirHollowAlone) {
  for (const CompressedSample& sample : compressedSamples()) {
    if (sample.name != "hollow ball")
      continue;
    const bem::Space space(sample.mesh);
    const bem::Lame lame({1, 0.3, false});
    const bem::CompressedOperators z(space, lame, smallLeaves(), {}, test::processes());
    const bem::Restriction clamp = clamped(space, 1, 49);
    const Matrix b = loads(space);
    const Matrix exact = denseSolution(wholeSystem(space, lame), clamp, b.copy());
    const bem::CompressedFactor factor(z, clamp);
    TEST_COMPARE(relativeDifference(factor.solve(b, 0), exact), <, 1e-9);
  }
}

TEUCHOS_UNIT_TEST(Compressed, changedRestrictionsAreEliminatedWhereTheyChange) {
  const bem::Space space(bem::makeMesh(outlineOf(square()), {48, 48, 48, 48}, 1));
  const bem::Lame lame({1, 0.3, false});
  const bem::CompressedOperators z(space, lame, smallLeaves(), {}, test::processes());
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
  const bem::CompressedOperators z(space, lame, smallLeaves(), {}, test::processes());
  const Matrix x = oscillating(z.size(), 2);
  TEST_EQUALITY(relativeDifference(z.times(x), alone.times(x)), 0);
  // leaves at the end of a side, and a side
  for (const int last : {54, 96}) {
    std::vector<int> leaves;
    for (int e = 48; e < last; ++e)
      leaves.push_back(z.leafOf(space.displacement(e, 0, 0)));
    const bem::Restriction clamp = clamped(space, 0, 48);
    bem::Restriction changed = clamp;
    changed.held[space.displacement(50, 0, 1)] = 1;
    changed.held[space.displacement(last - 2, 0, 0)] = 1;
    const auto made = [&](const bem::CompressedOperators& from) {
      bem::CompressedFactor factor =
          bem::CompressedFactor(from, clamp).restrictedTo(leaves);
      factor.update(changed);
      return factor;
    };
    const bem::CompressedFactor one = made(alone);
    const bem::CompressedFactor several = made(z);
    Matrix b(z.size(), 2);
    for (int e = 49; e < last; ++e)
      b(space.displacement(e, 0, 0), e % 2) = std::sin(1.7 * e);
    const std::vector<char> paths = one.activePaths(leaves);
    TEST_ASSERT(paths == several.activePaths(leaves));
    TEST_EQUALITY(
        relativeDifference(several.solveAlong(paths, b), one.solveAlong(paths, b)), 0);
  }
  if (test::processes().count() > 1)
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
  const bem::CompressedOperators z(space, lame, smallLeaves(), local, test::processes());
  bem::Restriction clamp = clamped(space, 0, 48);
  clamp.held.resize(z.size());
  bem::Restriction all;
  all.held.assign(z.size(), 1);
  all.held.back() = 0;
  TEST_THROW(bem::CompressedFactor(z, all), bem::NumericalError);
  clamp.held.back() = 1;
  const Matrix b = oscillating(z.size(), 1);
  TEST_COMPARE(largest(bem::CompressedFactor(z, clamp).solve(b)), >, 0);
}

/// What failed half way is not taken for what is asked for next.
TEUCHOS_UNIT_TEST(Compressed, updatesThatFailAreMadeUpForByTheNext) {
  const bem::Space space(bem::makeMesh(outlineOf(square()), {48, 48, 48, 48}, 1));
  const bem::Lame lame({1, 0.3, false});
  bem::LocalCoupling local;
  local.elements = {100};
  const Index further = space.displacements() + space.densities();
  local.entries = {{space.displacement(100, 0, 0), further, 1}};
  const bem::CompressedOperators z(space, lame, smallLeaves(), local, test::processes());
  bem::Restriction before = clamped(space, 0, 48);
  before.held.resize(z.size());
  before.held.back() = 1;
  // in another leaf, too
  bem::Restriction singular = clamped(space, 0, 60);
  singular.held.resize(z.size());
  singular.held[space.displacement(100, 0, 0)] = 1;
  bem::CompressedFactor factor(z, before);
  TEST_THROW(factor.update(singular), bem::NumericalError);
  singular.held.back() = 1;
  const Matrix b = oscillating(z.size(), 1);
  for (const bem::Restriction& next : {singular, before}) {
    bem::CompressedFactor again = factor;
    again.update(next);
    const Matrix exact = bem::CompressedFactor(z, next).solve(b);
    TEST_COMPARE(relativeDifference(again.solve(b), exact), <, 1e-13);
  }
}

/// What answers from outside a part is of the restriction that it was made with.
TEUCHOS_UNIT_TEST(Compressed, partsChangeInside) {
  const bem::Space space(bem::makeMesh(outlineOf(square()), {48, 48, 48, 48}, 1));
  const bem::Lame lame({1, 0.3, false});
  const bem::CompressedOperators z(space, lame, smallLeaves(), {}, test::processes());
  const auto leafOf = [&](int e) { return z.leafOf(space.displacement(e, 0, 0)); };
  bem::CompressedFactor part =
      bem::CompressedFactor(z, clamped(space, 0, 48)).restrictedTo({leafOf(100)});
  bem::Restriction outside = clamped(space, 0, 48);
  outside.held[space.displacement(10, 0, 0)] = 0;
  TEST_THROW(part.update(outside), std::logic_error);
  bem::Restriction inside = clamped(space, 0, 48);
  inside.held[space.displacement(100, 0, 0)] = 1;
  TEST_NOTHROW(part.update(inside));
}

/// What would be read beside its place is refused: followers in other leaves than their
/// leaders, blocks of pairs that are far from one another.
TEUCHOS_UNIT_TEST(Compressed, nothingIsReadBesideItsPlace) {
  const bem::Space space(bem::makeMesh(outlineOf(square()), {48, 48, 48, 48}, 1));
  const bem::Lame lame({1, 0.3, false});
  const bem::CompressedOperators z(space, lame, smallLeaves(), {}, test::processes());
  bem::Restriction apart = clamped(space, 0, 48);
  const Index follower = space.displacement(100, 0, 0);
  apart.held[follower] = 1;
  apart.followers = {{follower, space.displacement(60, 0, 0), 1}};
  TEST_THROW(bem::CompressedFactor(z, apart), std::logic_error);

  const bem::ClusterTree tree(space, 60);
  const std::vector<char> everywhere(space.mesh().size(), 1);
  const bem::NearBlocks near(space, *bem::elasticKernel(space.mesh().outline(), lame),
                             tree, everywhere, everywhere);
  TEST_NOTHROW(near.of(10, 11));
  TEST_THROW(near.of(10, 100), std::logic_error);
}

/// An unknown that touches nothing, held: the others are as without it.
TEUCHOS_UNIT_TEST(Compressed, unknownsWithoutEntriesLeaveTheirClusterAlone) {
  const bem::Space space(bem::makeMesh(outlineOf(square()), {48, 48, 48, 48}, 1));
  const bem::Lame lame({1, 0.3, false});
  const Index further = space.displacements() + space.densities();
  bem::LocalCoupling local;
  local.elements = {100};
  local.entries = {{space.displacement(100, 0, 0), further, 0}};
  const bem::CompressedOperators z(space, lame, smallLeaves(), local, test::processes());
  Matrix x = oscillating(z.size(), 1);
  x(further, 0) = 0;
  const Matrix image = z.times(x);
  const Matrix whole = rotated(wholeSystem(space, lame), space);
  Matrix exact(z.size(), 1);
  for (Index j = 0; j < further; ++j)
    for (Index i = 0; i < further; ++i)
      exact(i, 0) += whole(i, j) * x(j, 0);
  TEST_COMPARE(relativeDifference(image, exact), <, 1e-10);
}

}  // namespace

}  // namespace epafi::reference
