// Every instruction set that this processor has gives the same moments and sums.
#include "MomentErrors.hpp"
#include "bem/fields/PointSources.hpp"
#include "bem/moments/FarPairs.hpp"
#include "bem/moments/NearPairs.hpp"
#include "bem/simd/Dispatch.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>
#include <memory>

namespace epafi {

namespace {

using epafi::reference::polygon;

TEUCHOS_UNIT_TEST(InstructionSets, startWithTheBaselineAndEndWithTheLargest) {
  TEST_ASSERT(bem::instructionSets().front() == bem::InstructionSet::Baseline);
  TEST_ASSERT(bem::instructionSets().back() == bem::largestInstructionSet());
}

bem::ElementLanes anyLanes(int densities, bem::Nearness order) {
  bem::ElementLanes all{};
  all.densities = densities;
  all.smooth = order;
  for (int lane = 0; lane < bem::lanes; ++lane) {
    bem::Element f;
    f.half = 0.1 + 0.02 * lane;
    const bem::Vec2 half{f.half * std::cos(0.7 * lane), f.half * std::sin(0.7 * lane)};
    f.curve = bem::Curve(-half, half);
    all.set(lane, {1.5 + 0.3 * lane, 0.2 * lane - 1}, f);
  }
  return all;
}

double difference(const bem::Tile& a, const bem::Tile& b, int degree) {
  test::MomentErrors errors;
  for (int lane = 0; lane < bem::lanes; ++lane)
    errors.take(a, lane, b, lane, degree, degree);
  return errors.difference.size();
}

TEUCHOS_UNIT_TEST(InstructionSets, giveTheSameTileMoments) {
  const auto outline = std::make_shared<const bem::Outline>(
      polygon({{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}));
  const auto baseline = std::make_unique<bem::Tile>();
  const auto other = std::make_unique<bem::Tile>();
  for (const int degree : {1, 2, 3, 8, 20}) {
    const bem::Mesh mesh = bem::makeMesh(outline, {2, 2, 2, 2}, degree);
    const bem::ElementLanes lanes = anyLanes(degree, {degree + 5, degree + 7});
    bem::farMoments(mesh[1], lanes, *baseline, bem::InstructionSet::Baseline);
    for (const bem::InstructionSet set : bem::instructionSets()) {
      bem::farMoments(mesh[1], lanes, *other, set);
      TEST_COMPARE(difference(*baseline, *other, degree), <, 1e-13);
    }
  }
}

/// Touching on an edge and at a corner, beside each other, with itself; degrees so high
/// that both recurrences are there.
TEUCHOS_UNIT_TEST(InstructionSets, giveTheSameNearMoments) {
  const auto outline = std::make_shared<const bem::Outline>(
      polygon({{-0.5, -0.1}, {0.5, -0.1}, {0.5, 0.1}, {-0.4, 0.1}}));
  const auto baseline = std::make_unique<bem::Tile>();
  const auto other = std::make_unique<bem::Tile>();
  for (const int degree : {1, 2, 8, 20}) {
    const bem::Mesh mesh = bem::makeMesh(outline, {4, 2, 3, 2}, degree);
    for (const int e : {0, 1, 2, 4, 6, 7}) {
      bem::nearMoments(mesh, e, 2, *baseline, 0, bem::InstructionSet::Baseline);
      for (const bem::InstructionSet set : bem::instructionSets()) {
        bem::nearMoments(mesh, e, 2, *other, 0, set);
        for (int lane = 1; lane < bem::lanes; ++lane)
          for (int i = 0; i <= degree; ++i)
            for (int j = 0; j <= degree; ++j) {
              const int at = i * bem::Tile::stride + j;
              for (const auto table :
                   {&bem::Tile::log, &bem::Tile::along, &bem::Tile::across,
                    &bem::Tile::direct, &bem::Tile::reverse})
                ((*baseline).*table)[at][lane] = ((*other).*table)[at][lane] = 0;
            }
        TEST_COMPARE(difference(*baseline, *other, degree), <, 1e-13);
      }
    }
  }
}

struct Angles {
  const bem::Pack& y;
  const bem::Pack& x;
  bem::Pack& result;
  template <bem::Division>
  EPAFI_INLINE void run() const {
    bem::angle(y, x, result);
  }
};

TEUCHOS_UNIT_TEST(InstructionSets, measureAngles) {
  for (const bem::InstructionSet set : bem::instructionSets())
    for (int k = 0; k < 100; ++k) {
      bem::Pack x{};
      bem::Pack y{};
      for (int lane = 0; lane < bem::lanes; ++lane) {
        const double turn = 0.008 * (8 * k + lane) - 3.2;
        const double size = std::pow(10, 2 * lane - 8);
        x[lane] = size * std::cos(turn);
        y[lane] = size * std::sin(turn);
      }
      bem::Pack result{};
      bem::dispatch(set, Angles{y, x, result});
      for (int lane = 0; lane < bem::lanes; ++lane) {
        const double exact = std::atan2(y[lane], x[lane]);
        TEST_COMPARE(std::abs(result[lane] - exact), <=, 4.5e-16 * std::abs(exact));
      }
    }
}

TEUCHOS_UNIT_TEST(InstructionSets, giveTheSameSumsOfSources) {
  for (const std::size_t states : {1, 3}) {
    bem::PointSources sources(states);
    for (std::size_t k = 0; k < 1001; ++k) {
      const auto at = static_cast<double>(k);
      sources.add({std::cos(0.1 * at), std::sin(0.1 * at)});
      for (std::size_t i = 0; i < states; ++i)
        sources.carry(i,
                      {std::sin((1.3 + static_cast<double>(i)) * at), std::cos(0.4 * at)},
                      {std::cos(2.1 * at), 0.3});
    }
    const bem::Complex x(0.2, -0.1);
    const auto sumsBy = [&](bem::InstructionSet set) {
      std::vector<bem::PointSources::Sums> sums(states);
      sources.addAt(x, 3, sources.size(), sums, set);
      std::vector<bem::FieldSums> totals;
      for (const auto& of : sums)
        totals.push_back(of.total());
      return totals;
    };
    const auto baseline = sumsBy(bem::InstructionSet::Baseline);
    for (const bem::InstructionSet set : bem::instructionSets()) {
      const auto sums = sumsBy(set);
      for (std::size_t i = 0; i < states; ++i)
        for (const auto part : {&bem::FieldSums::density, &bem::FieldSums::slope})
          for (const auto kernel : {&bem::SourceSums::overW, &bem::SourceSums::overConj,
                                    &bem::SourceSums::cubic})
            TEST_COMPARE(std::abs(sums[i].*part.*kernel - baseline[i].*part.*kernel), <,
                         1e-10);
    }
  }
}

}  // namespace

}  // namespace epafi
