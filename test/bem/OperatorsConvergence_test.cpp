// Every entry of V, K + 1/2 and W on all hard meshes against 33 digits.
#include "bem/operators/Assembly.hpp"
#include "reference/QuadOperators.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>

namespace epafi::reference {

namespace {

TEUCHOS_UNIT_TEST(OperatorsConvergence, everyEntryIsExactTo12DigitsOfItsBlock) {
  for (const Sample& sample : hardSamples())
    for (double nu : {-0.5, 0.3, 0.4999999}) {
      const bem::Space space(sample.mesh);
      const bem::Lame lame({1, nu, false});
      const OperatorErrors error =
          operatorErrors(bem::assembleOperators(space, lame), quadOperators(space, lame));
      out << sample.name << ", nu = " << nu << ":\n";
      TEST_COMPARE(error.singleLayer, <, 1e-12);
      TEST_COMPARE(error.doubleLayer, <, 1e-12);
      TEST_COMPARE(error.hypersingular, <, 1e-12);
    }
}

// K is integrated by parts, where a hat is the difference of two large terms however
// small it is: entries of tiny hats far away are exact to rounding of their row, not of
// their block.
TEUCHOS_UNIT_TEST(OperatorsConvergence, lengthsOfOneTo1e10CostNoDigits) {
  const bem::Space space(gradedSample().mesh);
  const bem::Lame lame({1, 0.3, false});
  const bem::Operators operators = bem::assembleOperators(space, lame);
  const QuadOperators exact = quadOperators(space, lame);
  const OperatorErrors error = operatorErrors(operators, exact);
  TEST_COMPARE(error.singleLayer, <, 1e-12);
  TEST_COMPARE(error.hypersingular, <, 1e-12);

  const QuadMatrix& k = exact.doubleLayer;
  double worst = 0;
  for (bem::Index i = 0; i < k.rows(); ++i) {
    Quad difference = 0;
    Quad row = 0;
    for (bem::Index j = 0; j < k.columns(); ++j) {
      difference = std::max<Quad>(difference, abs(operators.doubleLayer(i, j) - k(i, j)));
      row = std::max(row, k.scale(i, j));
    }
    worst = std::max(worst, static_cast<double>(difference / row));
  }
  TEST_COMPARE(worst, <, 1e-12);
}

// The oracle against itself with a third more points: six digits more than the test
// needs.
TEUCHOS_UNIT_TEST(OperatorsConvergence, theReferenceHas18Digits) {
  const auto difference = [](const QuadMatrix& a, const QuadMatrix& b) {
    Quad worst = 0;
    for (bem::Index i = 0; i < a.rows(); ++i)
      for (bem::Index j = 0; j < a.columns(); ++j)
        worst = std::max<Quad>(worst, abs(a(i, j) - b(i, j)) / b.scale(i, j));
    return static_cast<double>(worst);
  };
  for (const Sample& sample : hardSamples()) {
    const bem::Space space(sample.mesh);
    const bem::Lame lame({1, 0.3, false});
    const QuadOperators used = quadOperators(space, lame);
    const QuadOperators finer = quadOperators(space, lame, 1e-28);
    out << sample.name << ":\n";
    TEST_COMPARE(difference(used.singleLayer, finer.singleLayer), <, 1e-18);
    TEST_COMPARE(difference(used.doubleLayer, finer.doubleLayer), <, 1e-18);
    TEST_COMPARE(difference(used.hypersingular, finer.hypersingular), <, 1e-18);
  }
}

}  // namespace

}  // namespace epafi::reference
