#include "contact/conditions/ParticularSolution.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>

namespace epafi {

namespace {

using bem::Complex;
using bem::Vec2;
using contact::BodyLoads;
using contact::ParticularSolution;

/// All kinds of loads at once, the temperature of degree 4 with terms of every kind.
BodyLoads allLoads(double expansion) {
  BodyLoads loads;
  loads.uniform = {0.3, -0.7};
  loads.linear = {0.9, -0.4};
  loads.temperature = {{0, 0, 0.5},          {1, 0, {0.2, -0.3}},   {0, 1, {0.2, 0.3}},
                       {1, 1, 0.7},          {2, 1, {-0.4, 0.1}},   {1, 2, {-0.4, -0.1}},
                       {3, 1, {0.15, 0.25}}, {1, 3, {0.15, -0.25}}, {2, 2, -0.6},
                       {4, 0, {0.3, 0.2}},   {0, 4, {0.3, -0.2}}};
  loads.expansion = expansion;
  return loads;
}

const Vec2 places[] = {{0.1, 0.2}, {-0.3, 0.4}, {0.45, -0.2}, {-0.05, 0.02}};
constexpr double step = 1e-4;

/// By central differences.
template <class Value>
double slope(const Value& value, Vec2 at, Vec2 along) {
  return (value(at + step * along) - value(at - step * along)) / (2 * step);
}

TEUCHOS_UNIT_TEST(ParticularSolution, stressesCarryTheForces) {
  for (const double nu : {0.0, 0.3, 0.5}) {
    const ParticularSolution solution(allLoads(0.8), bem::Lame({2.0, nu, false}));
    for (const Vec2 at : places) {
      const auto xx = [&](Vec2 y) { return solution.stress(y).xx; };
      const auto yy = [&](Vec2 y) { return solution.stress(y).yy; };
      const auto xy = [&](Vec2 y) { return solution.stress(y).xy; };
      const Vec2 b = solution.force(at);
      TEST_COMPARE(std::abs(slope(xx, at, {1, 0}) + slope(xy, at, {0, 1}) + b.x), <,
                   1e-7);
      TEST_COMPARE(std::abs(slope(xy, at, {1, 0}) + slope(yy, at, {0, 1}) + b.y), <,
                   1e-7);
    }
  }
}

// E' εxx = σxx - ν' σyy + E' α' T, likewise the others: regular at 1/2, too
TEUCHOS_UNIT_TEST(ParticularSolution, strainsAreThoseOfStressAndHeat) {
  for (const double nu : {0.0, 0.3, 0.5}) {
    constexpr double expansion = 0.8;
    const bem::Lame lame({2.0, nu, false});
    const ParticularSolution solution(allLoads(expansion), lame);
    for (const Vec2 at : places) {
      const auto ux = [&](Vec2 y) { return solution.displacement(y).x; };
      const auto uy = [&](Vec2 y) { return solution.displacement(y).y; };
      const ParticularSolution::Stress s = solution.stress(at);
      const double heat = expansion * solution.temperature(at);
      const double mean = lame.nu * (s.xx + s.yy);
      const double exx = (s.xx - mean) / (2 * lame.mu) + heat;
      const double eyy = (s.yy - mean) / (2 * lame.mu) + heat;
      TEST_COMPARE(std::abs(slope(ux, at, {1, 0}) - exx), <, 1e-7);
      TEST_COMPARE(std::abs(slope(uy, at, {0, 1}) - eyy), <, 1e-7);
      const double shear = slope(ux, at, {0, 1}) + slope(uy, at, {1, 0});
      TEST_COMPARE(std::abs(shear - s.xy / lame.mu), <, 1e-7);
      const double energy =
          0.5 * (s.xx * (exx - heat) + s.yy * (eyy - heat) + s.xy * s.xy / lame.mu);
      TEST_FLOATING_EQUALITY(solution.energyDensity(at), energy, 1e-12);
    }
  }
}

TEUCHOS_UNIT_TEST(ParticularSolution, aHarmonicTemperatureHasNoStress) {
  BodyLoads loads;
  loads.temperature = {{0, 0, 2.0}, {3, 0, {0.5, 1.0}}, {0, 3, {0.5, -1.0}}};
  loads.expansion = 1;
  const ParticularSolution solution(loads, bem::Lame({1.0, 0.3, false}));
  for (const Vec2 at : places) {
    const ParticularSolution::Stress s = solution.stress(at);
    TEST_COMPARE(std::abs(s.xx) + std::abs(s.yy) + std::abs(s.xy), <, 1e-15);
  }
}

TEUCHOS_UNIT_TEST(ParticularSolution, itsPartsAddUp) {
  const bem::Lame lame({1.0, 0.3, false});
  const BodyLoads all = allLoads(0.8);
  BodyLoads cold = all;
  cold.temperature.clear();
  BodyLoads hot;
  hot.temperature = all.temperature;
  hot.expansion = all.expansion;
  const ParticularSolution solution(all, lame);
  for (const Vec2 at : places) {
    const Vec2 u = solution.displacementOfForces(at);
    TEST_EQUALITY_CONST(norm(u - ParticularSolution(cold, lame).displacement(at)), 0);
    const auto s = solution.stressOfHeat(at);
    TEST_EQUALITY_CONST(s.xx, ParticularSolution(hot, lame).stress(at).xx);
    TEST_COMPARE(std::abs(s.xx) + std::abs(s.xy), >, 0);
  }
}

}  // namespace

}  // namespace epafi
