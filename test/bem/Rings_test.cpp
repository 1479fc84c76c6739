// Solids of revolution: entries against 33 digits, and identities of whole bodies.
#include "Largest.hpp"
#include "bem/algebra/DenseAlgebra.hpp"
#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/fields/BoundaryFields.hpp"
#include "bem/fields/Interior.hpp"
#include "bem/operators/Assembly.hpp"
#include "bem/operators/EnergyNorm.hpp"
#include "bem/operators/RingBlocks.hpp"
#include "bem/operators/RingLaplace.hpp"
#include "bem/operators/SteklovPoincare.hpp"
#include "reference/QuadRings.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>

namespace epafi::reference {

namespace {

using bem::Index;
using bem::Loop;
using bem::Mesh;
using bem::Vec2;
using bem::Vector;

std::shared_ptr<const bem::Outline> solid(const Loop& loop) {
  return std::make_shared<const bem::Outline>(loop, std::vector<Loop>{},
                                              bem::scalingOf(loop, true));
}

Loop arcs(const std::vector<Vec2>& vertices, const std::vector<double>& bulges) {
  Loop loop = polygon(vertices);
  loop.bulges = bulges;
  return loop;
}

const double quarter = std::tan(std::acos(-1.0) / 8);

const std::vector<Vec2> cylinder = {{0, 0}, {1, 0}, {1, 1.5}, {0, 1.5}};
const std::vector<Vec2> cones = {{0, 0}, {1, 0.5}, {0.7, 2}, {0, 1.5}};
const std::vector<Vec2> ring = {{1, 0}, {2, 0}, {2, 1}, {1, 1}};
const std::vector<Vec2> rod = {{0, 0}, {0.05, 0}, {0.05, 1.5}, {0, 1.5}};
const std::vector<Vec2> needle = {{0, 0}, {1, 0.01}, {0, 0.013}};
const std::vector<Vec2> cone = {{0, 0}, {1, 0.1}, {0, 0.1}};
const std::vector<Vec2> groove = {{1, 0},   {2, 0}, {2, 0.45}, {1.3, 0.5},
                                  {2, 0.5}, {2, 1}, {1, 1}};
const std::vector<Vec2> thinRing = {{20, 0}, {21, 0}, {21, 1}, {20, 1}};

Mesh uniform(const Loop& loop, int elements, int degree) {
  const auto outline = solid(loop);
  std::vector<int> counts;
  for (int k = 0; k < static_cast<int>(loop.vertices.size()); ++k)
    counts.push_back(outline->isAxis(k) ? 1 : elements);
  return bem::makeMesh(outline, counts, degree);
}

/// Graded to 1e-6 at one end of two edges, degrees 1 to 4.
Mesh graded() {
  std::vector<double> toStart;
  for (int k = 7; k >= 1; --k)
    toStart.push_back(std::pow(0.14, k));
  std::vector<double> toEnd;
  for (int k = 1; k <= 7; ++k)
    toEnd.push_back(1 - std::pow(0.14, k));
  return cutMesh(solid(polygon(cones)), {{0, toEnd}, {1, toStart}, {2, {0.5}}},
                 {1, 2, 3, 4});
}

/// Straight bodies, on which linear displacements are polynomials of arc length.
std::vector<Sample> straightSamples() {
  std::vector<Sample> samples;
  for (const int p : {1, 2, 5, 12}) {
    samples.push_back({"ring", uniform(polygon(ring), 2, p)});
    samples.push_back({"cylinder", uniform(polygon(cylinder), 3, p)});
    samples.push_back({"cones", uniform(polygon(cones), 3, p)});
  }
  samples.push_back({"graded", graded()});
  samples.push_back({"rod", uniform(polygon(rod), 3, 4)});
  samples.push_back({"thin ring", uniform(polygon(thinRing), 2, 3)});
  return samples;
}

/// So many elements that groups of them are summed together, on the axis and off it.
std::vector<Sample> largeSamples() {
  return {{"cones", uniform(polygon(cones), 120, 2)},
          {"ring", uniform(polygon(ring), 120, 2)},
          {"rod", uniform(polygon(rod), 110, 2)},
          {"thin ring", uniform(polygon(thinRing), 120, 2)}};
}

/// Neighbours that run beside each other, inside the body or outside, and such as come near each other
/// again at the axis, with one element an edge.
std::vector<Sample> sharpSamples() {
  std::vector<Sample> samples = {
      {"cone", uniform(polygon(cone), 2, 3)},
      {"needle", uniform(polygon(needle), 3, 2)},
      {"groove", uniform(polygon(groove), 2, 3)},
      {"thin lens", uniform(arcs({{3, 0}, {1, 0}}, {0.03, 0.03}), 2, 8)},
      {"crescent", uniform(arcs({{3, 0}, {1, 0}}, {0.4, -0.37}), 3, 12)}};
  for (const int p : {1, 2, 5, 12})
    for (const double height : {0.6, 0.2, 0.02})
      samples.push_back(
          {"sharp rim", uniform(polygon({{0, 0}, {1, height}, {0, height}}), 1, p)});
  return samples;
}

/// Arcs, with degrees that represent linear displacements to rounding.
std::vector<Sample> curvedSamples() {
  const double third = std::tan(std::acos(-1.0) / 6);
  return {
      {"sphere", uniform(arcs({{0, -1}, {1, 0}, {0, 1}}, {quarter, quarter, 0}), 2, 12)},
      {"O-ring", uniform(arcs({{3, 0}, {1, 0}}, {1, 1}), 3, 12)},
      {"lens", uniform(arcs({{3, 0}, {1, 0}}, {third, third}), 3, 12)}};
}

/// ψ of a traction, by scaled place and normal.
template <class Traction>
Vector densityOf(const bem::Space& space, const Traction& traction) {
  Vector psi(space.densities(), 0.0);
  const Mesh& mesh = space.mesh();
  for (int e = 0; e < mesh.size(); ++e) {
    const int count = mesh[e].densities;
    const bem::Rule& rule = bem::gaussLegendre(count + 20);
    for (int q = 0; q < rule.size(); ++q) {
      const double t = rule.points[q];
      std::vector<double> legendre(static_cast<std::size_t>(count) + 1);
      bem::legendreValues(count, t, legendre.data());
      const Vec2 force = traction(mesh.scaledPoint(e, t), mesh[e].curve.normal(t));
      for (int i = 0; i < count; ++i) {
        const double weight = (i + 0.5) * rule.weights[q] * legendre[i];
        psi[space.density(e, i, 0)] += weight * force.x;
        psi[space.density(e, i, 1)] += weight * force.y;
      }
    }
  }
  return psi;
}

/// Of a uniform stress with the radial part a and the axial part b.
Vector tractionOf(const bem::Space& space, double a, double b) {
  return densityOf(space, [&](Vec2, Vec2 n) { return Vec2{a * n.x, b * n.y}; });
}

/// Largest entry of a vector, or of what the first nodes on the axis do not take along: u_r is zero
/// there.
double largestOff(const bem::Space& space, Vector v) {
  for (int e = 0; e < space.mesh().size(); ++e)
    if (space.mesh().isAxis(e))
      for (const int k : {0, 1})
        v[space.displacement(e, k, 0)] = 0;
  return test::largest(v);
}

TEUCHOS_UNIT_TEST(Rings, knowUniformStressAndTheRigidMotion) {
  std::vector<Sample> samples = straightSamples();
  for (const auto& others : {sharpSamples(), curvedSamples()})
    samples.insert(samples.end(), others.begin(), others.end());
  for (const Sample& sample : samples)
    for (const double nu : {0.3, 0.4999}) {
      const bem::Lame lame({1, nu, false});
      const bem::Space space(sample.mesh);
      const bem::Operators operators = bem::assembleOperators(space, lame);
      out << sample.name << ", " << space.densities() << ", nu = " << nu << ": ";
      const Vector up = space.interpolate([](Vec2) { return Vec2{0, 1}; });
      TEST_COMPARE(test::largest(bem::product(operators.doubleLayer, up)), <, 1e-13);
      TEST_COMPARE(test::largest(bem::multiplySymmetric(operators.hypersingular, up)), <,
                   1e-13);
      // stress (s_r, s_r, s_z) of u = (r, 2 z)/10
      const double strain = 2 * 0.1 + 0.2;
      const double lambda = 2 * lame.mu * nu / (1 - 2 * nu);
      const double radial = lambda * strain + 2 * lame.mu * 0.1;
      const double axial = lambda * strain + 2 * lame.mu * 0.2;
      const double size = std::max(radial, 1.0) * test::largest(operators.singleLayer);
      const Vector u = space.interpolate([](Vec2 x) {
        return Vec2{0.1 * x.x, 0.2 * x.y};
      });
      const Vector t = tractionOf(space, radial, axial);
      TEST_COMPARE(
          test::largestDifference(bem::product(operators.doubleLayer, u),
                                  bem::multiplySymmetric(operators.singleLayer, t)),
          <, 1e-13 * std::max(1.0, size));
      // W u = (1/2 - K') t = <t, u> - (K + 1/2)' t
      Vector difference = bem::multiplySymmetric(operators.hypersingular, u);
      for (Index k = 0; k < operators.doubleLayer.columns(); ++k)
        difference[k] += bem::dot(bem::columnOf(operators.doubleLayer, k), t);
      for (int e = 0; e < space.mesh().size(); ++e) {
        const bem::Matrix mass = bem::ringMassOf(space.mesh(), e);
        for (int i = 0; i < space.mesh()[e].densities; ++i)
          for (int k = 0; k <= space.mesh()[e].degree; ++k)
            for (int c = 0; c < 2; ++c)
              difference[space.displacement(e, k, c)] -=
                  mass(i, k) * t[space.density(e, i, c)];
      }
      TEST_COMPARE(largestOff(space, difference), <, 1e-13 * std::max(1.0, radial));
    }
}

/// The largest errors of V, K and W of a pair, relative to the norms of its blocks; of K and W those
/// of bubbles, which no other pair has a part of.
struct EntryErrors {
  test::Largest single;
  test::Largest twofold;
  test::Largest hypersingular;
};

EntryErrors entryErrors(const bem::Space& space, const bem::Operators& operators,
                        const bem::Lame& lame, int e, int f) {
  const Mesh& mesh = space.mesh();
  const QuadRings exact = quadRings(mesh, e, f, lame, 1e-15);
  EntryErrors errors;
  const auto lower = [](const bem::Matrix& matrix, Index i, Index j) {
    return matrix(std::max(i, j), std::min(i, j));
  };
  // Laplace's double layer of a plane on itself is zero
  constexpr double nothing = 1e-20;
  const auto take = [&](double computed, const Quad& is, const QuadBlock& block,
                        test::Largest& largest) {
    const double size = block.frobenius();
    largest.take(static_cast<double>(computed - is) /
                 (size > nothing ? size : exact.singleLayer.frobenius()));
  };
  for (int c = 0; c < 2; ++c)
    for (int d = 0; d < 2; ++d)
      for (int i = 0; i < mesh[e].densities; ++i) {
        for (int j = 0; j < mesh[f].densities; ++j)
          take(lower(operators.singleLayer, space.density(e, i, c),
                     space.density(f, j, d)),
               exact.singleLayer(2 * i + c, 2 * j + d), exact.singleLayer, errors.single);
        const bem::Matrix mass = bem::ringMassOf(mesh, e);
        for (int k = 2; k <= mesh[f].degree; ++k)
          take(
              operators.doubleLayer(space.density(e, i, c), space.displacement(f, k, d)) -
                  (e == f && c == d ? 0.5 * mass(i, k) : 0),
              exact.doubleLayer(2 * i + c, 2 * k + d), exact.doubleLayer, errors.twofold);
        for (int k = 2; i + 2 <= mesh[e].degree && k <= mesh[f].degree; ++k)
          take(lower(operators.hypersingular, space.displacement(e, i + 2, c),
                     space.displacement(f, k, d)),
               exact.hypersingular(2 * (i + 2) + c, 2 * k + d), exact.hypersingular,
               errors.hypersingular);
      }
  return errors;
}

// With themselves, at nodes, facing, far, at the axis and beside it; Laplace's, too, as of Lamé's
// constants.
TEUCHOS_UNIT_TEST(Rings, haveEntriesOf13Digits) {
  struct Case {
    Sample sample;
    std::vector<std::pair<int, int>> pairs;
  };
  const Loop sphere = arcs({{0, -1}, {1, 0}, {0, 1}}, {quarter, quarter, 0});
  const std::vector<Case> cases = {
      {{"cones", uniform(polygon(cones), 2, 2)},
       {{0, 0}, {1, 1}, {0, 1}, {2, 1}, {0, 2}, {0, 5}}},
      {{"cone", uniform(polygon(cone), 2, 2)}, {{1, 2}, {2, 1}}},
      {{"groove", uniform(polygon(groove), 2, 2)}, {{5, 6}, {3, 8}}},
      {{"rod", uniform(polygon(rod), 2, 2)}, {{2, 2}, {2, 3}, {1, 4}}},
      {{"sphere", uniform(sphere, 2, 2)}, {{0, 0}, {1, 2}, {0, 3}}},
      {{"thin ring", uniform(polygon(thinRing), 1, 2)}, {{0, 0}, {0, 2}}}};
  for (const auto& [sample, pairs] : cases)
    for (const bem::Lame& lame : {bem::Lame({1, 0.3, false}), bem::lameOfRingLaplace()}) {
      const bem::Space space(sample.mesh);
      const bem::Operators operators = bem::assembleOperators(space, lame);
      for (const auto& [e, f] : pairs) {
        const EntryErrors errors = entryErrors(space, operators, lame, e, f);
        out << sample.name << ", " << e << " and " << f << ": ";
        TEST_COMPARE(errors.single.size(), <, 1e-13);
        TEST_COMPARE(errors.twofold.size(), <, 1e-13);
        TEST_COMPARE(errors.hypersingular.size(), <, 1e-12);
      }
    }
}

/// A sphere of radius 2 with a hole of radius 1, a quarter of a circle each.
Loop hollowSphere() {
  return arcs({{0, -2}, {2, 0}, {0, 2}, {0, 1}, {1, 0}, {0, -1}},
              {quarter, quarter, 0, -quarter, -quarter, 0});
}

/// Lame's solution u = (A R + B/R²) e_R; lengths over the diameter 4.
struct HollowSphere {
  double a = 0.1;
  double b = 0.2;
  bem::Lame lame{{1, 0.3, false}};

  Vec2 displacement(Vec2 x) const {
    const double radius = norm(x);
    return (a + b / std::pow(radius, 3)) * x;
  }
  double stress(double radius) const {
    const double bulk = 2 * lame.mu * (1 + lame.nu) / (1 - 2 * lame.nu);  // 3λ + 2μ
    return bulk * a - 4 * lame.mu * b / std::pow(radius, 3);
  }
  /// ∫ t·u
  double work() const {
    const auto of = [&](double radius) {
      return radius * radius * stress(radius) * displacement({radius, 0}).x;
    };
    return 4 * std::acos(-1.0) * (of(0.5) - of(0.25));
  }
};

TEUCHOS_UNIT_TEST(Rings, giveTheHollowSpheresEnergyExponentiallyInP) {
  const HollowSphere exact;
  double before = 1;
  for (const int p : {2, 4, 6, 8}) {
    const bem::Space space(uniform(hollowSphere(), 1, p));
    const bem::SteklovPoincare s(bem::assembleOperators(space, exact.lame));
    const Vector u = space.interpolate([&](Vec2 x) { return exact.displacement(x); });
    const double error = std::abs(bem::dot(u, s.apply(u)) / exact.work() - 1);
    out << "p = " << p << ", " << space.densities() + space.displacements()
        << " unknowns: ";
    TEST_COMPARE(error, <, std::max(0.1 * before, 1e-12));
    before = error;
  }
  TEST_COMPARE(before, <, 1e-12);
}

// <W u, u> + <V ψ, ψ> = ∫ t·u of the exact data, and both integral equations hold.
TEUCHOS_UNIT_TEST(Rings, haveTheEnergyNormAndFieldsOfExactData) {
  const HollowSphere exact;
  const bem::Space space(uniform(hollowSphere(), 2, 8));
  const bem::SteklovPoincare s(bem::assembleOperators(space, exact.lame));
  const Vector u = space.interpolate([&](Vec2 x) { return exact.displacement(x); });
  const Vector psi = s.density(u);
  TEST_FLOATING_EQUALITY(
      std::pow(bem::energyNorm(bem::makeCauchyData(space, u, psi), exact.lame), 2),
      exact.work(), 1e-12);
  const bem::Space fine(uniform(hollowSphere(), 4, 8));  // the same, to rounding
  const Vector v = fine.interpolate([&](Vec2 x) { return exact.displacement(x); });
  const bem::SteklovPoincare ofFine(bem::assembleOperators(fine, exact.lame));
  const bem::CauchyData difference =
      bem::difference(bem::makeCauchyData(space, u, psi),
                      bem::makeCauchyData(fine, v, ofFine.density(v)));
  TEST_COMPARE(bem::energyNorm(difference, exact.lame), <, 1e-6);
  const bem::BoundaryFields fields(space, exact.lame, {{u, psi}});
  for (int e = 0; e < space.mesh().size(); ++e) {
    const bem::BoundaryFields::Values values = fields.on(e);
    for (const bem::BoundaryValue& value : values.front()) {
      const double t = value.place.t;
      const Vec2 n = space.mesh()[e].curve.normal(t);
      const double stress = exact.stress(norm(space.mesh().scaledPoint(e, t)));
      TEST_COMPARE(norm(value.traction - stress * n), <, 1e-7);
      TEST_COMPARE(norm(value.mismatch), <, 1e-7);
    }
  }
}

TEUCHOS_UNIT_TEST(Rings, haveTheTractionsOfUniformStressOnSharpWedges) {
  for (const Sample& sample : sharpSamples()) {
    const bem::Lame lame({1, 0.3, false});
    const bem::Space space(sample.mesh);
    const double lambda = 2 * lame.mu * lame.nu / (1 - 2 * lame.nu);
    const double radial = 0.4 * lambda + 0.2 * lame.mu;
    const double axial = 0.4 * lambda + 0.4 * lame.mu;
    const Vector u = space.interpolate([](Vec2 x) { return Vec2{0.1 * x.x, 0.2 * x.y}; });
    const bem::BoundaryFields fields(space, lame,
                                     {{u, tractionOf(space, radial, axial)}});
    test::Largest error;
    for (int e = 0; e < space.mesh().size(); ++e) {
      if (space.mesh().isAxis(e))
        continue;
      const bem::BoundaryFields::Values values = fields.on(e);
      for (const bem::BoundaryValue& value : values.front()) {
        const Vec2 n = space.mesh()[e].curve.normal(value.place.t);
        error.take(norm(value.traction - Vec2{radial * n.x, axial * n.y}));
        error.take(norm(value.mismatch));
      }
    }
    out << sample.name << ": ";
    TEST_COMPARE(error.size(), <, 1e-11);
  }
}

/// Places below the surface, at a depth over half the element, and on the axis.
std::vector<Vec2> placesInside(const Mesh& mesh, double depth) {
  std::vector<Vec2> places;
  for (int e = 0; e < mesh.size(); ++e)
    for (const double t : {-0.9, 0.1, 0.6})
      if (mesh.isAxis(e))
        places.push_back(mesh.scaledPoint(e, t));
      else
        places.push_back(mesh.scaledPoint(e, t) -
                         depth * mesh[e].half * mesh[e].curve.normal(t));
  return places;
}

/// The largest error of displacement and stress, all four, over the largest displacement.
template <class Exact>
double errorInside(const bem::Space& space, const bem::Lame& lame, const Vector& u,
                   const Vector& psi, double depth, const Exact& exact) {
  const std::vector<Vec2> places = placesInside(space.mesh(), depth);
  const std::vector<bem::InteriorValue> values =
      bem::Interior(space, lame, u, psi).at(places);
  test::Largest error;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const bem::InteriorValue is = exact(places[k]);
    error.take(norm(values[k].displacement - is.displacement));
    error.take(values[k].xx - is.xx);
    error.take(values[k].yy - is.yy);
    error.take(values[k].xy - is.xy);
    error.take(values[k].zz - is.zz);
  }
  return error.size() / test::largest(u);
}

/// u = grad (z³ - 3/2 r² z) on straight samples.
class Quadratic {
 public:
  Quadratic(const Mesh& mesh, double nu) : lame_({1, nu, false}), space_(mesh) {
    u_ = space_.interpolate([&](Vec2 x) { return at(x).displacement; });
    psi_ = densityOf(space_, [&](Vec2 x, Vec2 n) { return traction(x, n); });
  }

  double errorInside(double depth) const {
    return reference::errorInside(space_, lame_, u_, psi_, depth,
                                  [&](Vec2 x) { return at(x); });
  }
  /// Of both integral equations, over the largest displacement.
  double errorOnSurface() const {
    const bem::BoundaryFields fields(space_, lame_, {{u_, psi_}});
    test::Largest error;
    for (int e = 0; e < space_.mesh().size(); ++e)
      for (const double t : {-0.7, 0.1, 0.8}) {
        const bem::BoundaryFields::Values values = fields.at(e, {{t, 1 + t, 1 - t}});
        for (const bem::BoundaryValue& value : values.front()) {
          const Vec2 x = space_.mesh().scaledPoint(e, t);
          error.take(
              norm(value.traction - traction(x, space_.mesh()[e].curve.normal(t))));
          error.take(norm(value.mismatch));
        }
      }
    return error.size() / test::largest(u_);
  }

 private:
  bem::InteriorValue at(Vec2 x) const {
    const double mu = lame_.mu;
    return {{-3 * x.x * x.y, 3 * x.y * x.y - 1.5 * x.x * x.x},
            -6 * mu * x.y,
            12 * mu * x.y,
            -6 * mu * x.x,
            -6 * mu * x.y};
  }
  Vec2 traction(Vec2 x, Vec2 n) const {
    const bem::InteriorValue is = at(x);
    return {is.xx * n.x + is.xy * n.y, is.xy * n.x + is.yy * n.y};
  }

  bem::Lame lame_;
  bem::Space space_;
  Vector u_;
  Vector psi_;
};

TEUCHOS_UNIT_TEST(Rings, giveQuadraticDisplacementsInside) {
  for (const Sample& sample : straightSamples())
    for (const double nu : {0.3, 0.5}) {
      if (sample.mesh[0].degree < 2)
        continue;
      const Quadratic exact(sample.mesh, nu);
      out << sample.name << ", p = " << sample.mesh[0].degree << ", nu = " << nu << ": ";
      TEST_COMPARE(exact.errorInside(0.1), <, 1e-12);
      TEST_COMPARE(exact.errorInside(1e-3), <, 2e-12);
      TEST_COMPARE(exact.errorInside(1e-6), <, 1e-9);
    }
}

TEUCHOS_UNIT_TEST(Rings, giveQuadraticDisplacementsOfLargeMeshesByGroups) {
  for (const Sample& sample : largeSamples()) {
    const Quadratic exact(sample.mesh, 0.5);
    out << sample.name << ": ";
    TEST_COMPARE(exact.errorInside(0.1), <, 1e-11);
    TEST_COMPARE(exact.errorOnSurface(), <, 1e-9);
  }
}

// Lame's solution: hoop stress, too
TEUCHOS_UNIT_TEST(Rings, giveTheHollowSpheresStressInside) {
  const HollowSphere exact;
  const bem::Space space(uniform(hollowSphere(), 2, 12));
  const bem::SteklovPoincare s(bem::assembleOperators(space, exact.lame));
  const Vector u = space.interpolate([&](Vec2 x) { return exact.displacement(x); });
  const Vector psi = s.density(u);
  const auto field = [&](Vec2 x) {
    const double radius = norm(x);
    const Vec2 away = (1 / radius) * x;
    const double along = exact.stress(radius);
    const double around = along + 6 * exact.lame.mu * exact.b / std::pow(radius, 3);
    return bem::InteriorValue{exact.displacement(x),
                              along * away.x * away.x + around * away.y * away.y,
                              along * away.y * away.y + around * away.x * away.x,
                              (along - around) * away.x * away.y, around};
  };
  TEST_COMPARE(errorInside(space, exact.lame, u, psi, 0.3, field), <, 1e-11);
  TEST_COMPARE(errorInside(space, exact.lame, u, psi, 1e-3, field), <, 1e-11);
}

}  // namespace

}  // namespace epafi::reference
