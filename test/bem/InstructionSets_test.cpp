// Every instruction set that this processor has gives the same sums of sources; moments: TileBlocks.
#include "bem/fields/PointSources.hpp"
#include "bem/simd/Dispatch.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>

namespace epafi {

namespace {

TEUCHOS_UNIT_TEST(InstructionSets, startWithTheBaselineAndEndWithTheLargest) {
  TEST_ASSERT(bem::instructionSets().front() == bem::InstructionSet::Baseline);
  TEST_ASSERT(bem::instructionSets().back() == bem::largestInstructionSet());
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
