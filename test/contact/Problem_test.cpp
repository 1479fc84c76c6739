// A problem in numbers: what its parts must fit, what is shared, and a path in steps.
#include "Largest.hpp"
#include "bem/base/Error.hpp"
#include "contact/RandomProblem.hpp"
#include "contact/Solve.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>

namespace epafi {

namespace {

using contact::Index;
using contact::Problem;
using contact::Vector;
using test::solve;

/// A point on springs of flexibility 1 that is pressed by 1 and pulled sideways; γ of the
/// stabilisation is within them.
Problem pressedPoint(double pull) {
  Problem problem;
  problem.normals = 1;
  problem.tangentials = {{0, test::pointLaw("Coulomb", {0.5})}};
  problem.flexibility = test::identity(2);
  problem.offset = {1, pull};
  problem.rigid = contact::Matrix(2, 0);
  return problem;
}

/// Every step starts at the slip of the one before. Pull 0.8 slips at the bound 0.5, by 0.3;
/// -0.4 is within the other bound's reach; without pull the slip left pushes back.
TEUCHOS_UNIT_TEST(Path, everyStepStartsAtTheSlipBefore) {
  Vector shears;
  Vector slipBefore = {0};
  contact::State state;
  for (const double pull : {0.3, 0.3, 0.8, -0.4, 0.0}) {
    const Problem total = pressedPoint(pull);
    state = solve(withSlipBefore(total, slipBefore), state, {}).state;
    slipBefore = test::slip(total, state);
    shears.push_back(state.multiplier[1]);
  }
  TEST_COMPARE(test::largestDifference(shears, {0.3, 0.3, 0.5, -0.5, -0.1}), <, 1e-14);
}

TEUCHOS_UNIT_TEST(Flexibility, itsProductsAreThoseOfItsEntries) {
  std::mt19937 random(5);
  const Problem problem = test::randomProblem({7, "Tresca"}, random);
  const Index n = problem.size();
  Vector x;
  for (Index i = 0; i < n; ++i)
    x.push_back(i == 3 ? 0 : std::sin(static_cast<double>(5 * i)));
  const auto [value, magnitude] = problem.flexibility.product(x);
  TEST_ASSERT(problem.flexibility.times(x) == value);
  for (Index i = 0; i < n; ++i) {
    double sum = 0;
    double size = 0;
    for (Index j = 0; j < n; ++j) {
      const double term = problem.flexibility(i, j) * x[j];
      sum += term;
      size += std::abs(term);
    }
    TEST_COMPARE(std::abs(value[i] - sum), <=, 1e-15 * size);
    TEST_FLOATING_EQUALITY(magnitude[i], size, 1e-14);
  }
}

TEUCHOS_UNIT_TEST(Flexibility, isSharedByProblemsThatDifferInBounds) {
  std::mt19937 random(7);
  const Problem problem = test::randomProblem({7, "Coulomb"}, random);
  const Problem fixed = withSlipBounds(problem, Vector(7, 0.1));
  TEST_EQUALITY(&fixed.flexibility.entries(), &problem.flexibility.entries());
  TEST_EQUALITY(&problem.copy().flexibility.entries(), &problem.flexibility.entries());
}

/// The identity, whose n-th product breaks down.
class BreaksDown final : public contact::Flexibility::Operator {
 public:
  explicit BreaksDown(int product) : left_(product) {}

  Index size() const override { return 5; }
  Product product(const Vector& x) const override {
    if (--left_ == 0)
      throw bem::NumericalError("no more");
    return {x, x};
  }
  Vector times(const Vector& x) const override { return x; }
  contact::Matrix formed() const override { return test::identity(5); }
  std::unique_ptr<Factor> factor(System) const override { return nullptr; }

 private:
  mutable int left_;
};

TEUCHOS_UNIT_TEST(Flexibility, isAskedAnewWhereItBrokeDown) {
  for (const int product : {1, 2}) {
    const contact::Flexibility d(std::make_shared<const BreaksDown>(product));
    TEST_THROW(d.responses(2), bem::NumericalError);
    TEST_ASSERT(d.responses(2) == Vector(5, 1.0));
  }
}

TEUCHOS_UNIT_TEST(Problem, whatDoesNotFitIsRefusedAtTheDoor) {
  const auto refuses = [&](auto spoil) {
    Problem problem = pressedPoint(0.1);
    problem.check();
    spoil(problem);
    TEST_THROW(solve(problem, {}, {}), bem::InputError);
  };
  refuses([](Problem& p) { p.flexibility = test::identity(3); });
  refuses([](Problem& p) { p.offset.pop_back(); });
  refuses([](Problem& p) { p.rigid = contact::Matrix(2, 1); });
  refuses([](Problem& p) { p.rigidLoad = {1}; });
  refuses([](Problem& p) {
    p.rigidLoad = {1};
    p.rigid = contact::Matrix(1, 1);
  });
  refuses([](Problem& p) { p.rigidStiffness = {1}; });
  for (const Index normal : {-1, 1})
    refuses([normal](Problem& p) {
      p.tangentials[0] = {normal, test::pointLaw("Coulomb", {0.5})};
    });
  Problem problem = test::block(0.5, {2, 0});
  problem.rigidStiffness = {-1, -1};
  TEST_THROW(problem.check(), bem::NumericalError);
}

}  // namespace

}  // namespace epafi
