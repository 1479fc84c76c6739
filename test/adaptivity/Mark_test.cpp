#include "Rectangle.hpp"
#include "adaptivity/mark/Analyticity.hpp"
#include "adaptivity/mark/Strategy.hpp"
#include "bem/basis/Legendre.hpp"
#include "bem/quadrature/Gauss.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

namespace epafi {

namespace {

double sumOf(const bem::Vector& squares, const std::vector<int>& elements) {
  double sum = 0;
  for (const int e : elements)
    sum += squares[e];
  return sum;
}

/// The fewest elements that carry a fraction of the sum, by trying all subsets.
int fewest(const bem::Vector& squares, double fraction) {
  const double total = std::accumulate(squares.begin(), squares.end(), 0.0);
  int best = static_cast<int>(squares.size());
  for (unsigned set = 1; set < 1U << squares.size(); ++set) {
    double sum = 0;
    int count = 0;
    for (std::size_t e = 0; e < squares.size(); ++e)
      if ((set >> e & 1U) != 0) {
        sum += squares[e];
        ++count;
      }
    if (sum >= fraction * total)
      best = std::min(best, count);
  }
  return best;
}

/// Legendre coefficients 0 ... degree.
bem::Vector legendreSeries(const std::function<double(double)>& f, int degree) {
  const bem::Rule& rule = bem::gaussLegendre(90);
  bem::Vector series(degree + 1, 0.0);
  bem::Vector legendre(series.size());
  for (int q = 0; q < rule.size(); ++q) {
    bem::legendreValues(degree, rule.points[q], legendre.data());
    for (std::size_t i = 0; i < series.size(); ++i)
      series[i] += (static_cast<double>(i) + 0.5) * rule.weights[q] * legendre[i] *
                   f(rule.points[q]);
  }
  return series;
}

}  // namespace

TEUCHOS_UNIT_TEST(Doerfler, marksTheSmallestSetOfAll) {
  std::mt19937 random(7);
  std::exponential_distribution<double> size(1);
  for (int trial = 0; trial < 60; ++trial) {
    bem::Vector squares(10);
    for (double& square : squares)
      square = std::pow(size(random), 3);
    for (double fraction : {0.1, 0.3, 0.5, 0.9}) {
      const std::vector<int> marked = adaptivity::doerfler(squares, fraction);
      const double total = std::accumulate(squares.begin(), squares.end(), 0.0);
      TEST_COMPARE(sumOf(squares, marked), >=, fraction * total * (1 - 1e-14));
      TEST_EQUALITY(static_cast<int>(marked.size()), fewest(squares, fraction));
      TEST_ASSERT(std::is_sorted(marked.begin(), marked.end()));
    }
  }
}

TEUCHOS_UNIT_TEST(Doerfler, marksWhatIsEqualUpToQuadratureTogether) {
  // what ought to be equal differs by the quadrature of indicators
  const double tie = 1 - 4e-6;
  const bem::Vector squares = {1, 0.1, tie, 0.2, 1, tie, 0.9999};
  TEST_ASSERT((adaptivity::doerfler(squares, 0.05) == std::vector<int>{0, 2, 4, 5}));
}

TEUCHOS_UNIT_TEST(Doerfler, marksEverythingThatHasAnErrorForTheWholeSum) {
  TEST_ASSERT((adaptivity::doerfler({3, 0, 1e-30, 2}, 1) == std::vector<int>{0, 2, 3}));
  TEST_ASSERT(adaptivity::doerfler({0, 0, 0}, 0.3).empty());
}

TEUCHOS_UNIT_TEST(Analyticity, isSeenInLegendreCoefficients) {
  for (int degree : {3, 6, 12}) {
    const auto decision = [&](const std::function<double(double)>& f) {
      return adaptivity::decays(legendreSeries(f, degree), 1e-14, 0.5);
    };
    // poles at 2 and 1.1: coefficients fall like 0.27 and 0.64 to the degree
    TEST_ASSERT(decision([](double t) { return 1 / (2 - t); }));
    TEST_ASSERT(!decision([](double t) { return 1 / (1.1 - t); }));
    TEST_ASSERT(decision([](double t) { return std::exp(t); }));
    TEST_ASSERT(!decision([](double t) { return std::abs(t - 0.3); }));
  }
}

// The first coefficients of sqrt(1+t) are those of a smooth function.
TEUCHOS_UNIT_TEST(Analyticity, ofARootIsDeniedOnceTheDegreeShowsIt) {
  const auto root = [](double t) { return std::sqrt(1 + t); };
  TEST_ASSERT(adaptivity::decays(legendreSeries(root, 3), 1e-14, 0.5));
  TEST_ASSERT(!adaptivity::decays(legendreSeries(root, 12), 1e-14, 0.5));
}

TEUCHOS_UNIT_TEST(Analyticity, doesNotDependOnTheUnitOfTheFunction) {
  for (double pole : {1.05, 1.2, 1.3, 1.5, 3.0}) {
    bem::Vector series = legendreSeries([=](double t) { return 1 / (pole - t); }, 5);
    const bool decision = adaptivity::decays(series, 0, 0.5);
    for (double unit : {1e-9, 1e6, 1e12}) {
      bem::Vector other = series;
      for (double& a : other)
        a *= unit;
      TEST_EQUALITY(adaptivity::decays(other, 0, 0.5), decision);
    }
  }
}

TEUCHOS_UNIT_TEST(Analyticity, oneTermOrRoundingIsNothingToDecideFrom) {
  TEST_ASSERT(adaptivity::decays({1}, 0, 0.5));
  TEST_ASSERT(adaptivity::decays({1e-17, -3e-17, 2e-17}, 1e-16, 0.5));
  TEST_ASSERT(!adaptivity::decays({1e-17, -3e-17, 2e-17}, 0, 0.5));
}

// u on the free sides, psi on the clamp, and on a roller one component of each.
TEUCHOS_UNIT_TEST(Analyticity, looksAtWhatIsUnknownOnEachSide) {
  const int p = 6;
  const bem::Space space(test::squareMesh(p));
  contact::Conditions conditions;
  const auto zero = [](bem::Vec2) { return 0.0; };
  conditions.dirichlet["top"] = {zero, zero};
  conditions.dirichlet["left"] = {zero, {}};
  const auto decision = [&](const bem::Vector& u, const bem::Vector& psi, int e) {
    return static_cast<bool>(
        adaptivity::looksAnalytic(space, conditions, u, psi, 0.5)[e]);
  };
  const auto e = [&](const std::string& side) {
    return space.mesh().elementsOf(side).front();
  };
  const bem::Vector smooth(space.displacements(), 0.0);
  const bem::Vector smoothDensity(space.densities(), 0.0);
  for (const char* side : {"bottom", "right", "top", "left"})
    for (int c : {0, 1}) {
      bem::Vector u = smooth;
      bem::Vector psi = smoothDensity;
      u[space.displacement(e(side), p, c)] = 1;
      psi[space.density(e(side), p - 1, c)] = 1;
      const std::string name = side;
      const bool prescribed = name == "top" || (name == "left" && c == 0);
      TEST_EQUALITY(decision(u, smoothDensity, e(side)), prescribed);
      TEST_EQUALITY(decision(smooth, psi, e(side)), !prescribed);
    }
}

}  // namespace epafi
