// A contact problem on compressed operators is the one on dense matrices: flexibility,
// solution, displacement, density, reactions.
#include "Largest.hpp"
#include "Rectangle.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/BodyScene.hpp"
#include "contact/Form.hpp"
#include "contact/Solve.hpp"
#include "contact/equation/Classify.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi {

namespace {

using bem::Index;
using bem::Vector;
using contact::Stabilization;
using test::largest;

struct Case {
  std::string name;
  Stabilization::Form form;
  std::string basis;
  int degree;
  bool isClamped;
  std::string law;
  double friction;
  double nu = 0.3;
  double bulge = 0;              ///< of the side in contact, and of others alike
  const char* normal = nullptr;  ///< law by which the side yields
};

std::vector<Case> cases() {
  using Form = Stabilization::Form;
  return {
      {"Tresca", Form::None, "Biorthogonal", 1, true, "Tresca", 0.02},
      {"frictionless", Form::None, "Biorthogonal", 2, true, "", 0},
      {"Coulomb", Form::None, "Biorthogonal", 1, true, "Coulomb", 0.3},
      {"leaves of few functions", Form::None, "Biorthogonal", 8, true, "Coulomb", 0.3},
      {"Density, p = 1", Form::Density, "Gauss-Legendre-Lagrange", 1, true, "Tresca",
       0.02},
      {"Density, p = 3", Form::Density, "Gauss-Legendre-Lagrange", 3, true, "Coulomb",
       0.4},
      {"control points", Form::Density, "Bernstein", 3, true, "Coulomb", 0.4},
      {"incompressible", Form::Density, "Gauss-Legendre-Lagrange", 1, true, "Coulomb",
       0.4, 0.4999},
      {"free to fall", Form::None, "Biorthogonal", 1, false, "Coulomb", 0.3},
      {"free, Density", Form::Density, "Gauss-Legendre-Lagrange", 1, false, "Tresca",
       0.02},
      {"arcs", Form::None, "Biorthogonal", 1, true, "Coulomb", 0.3, 0.3, 0.2},
      {"arcs, Density", Form::Density, "Gauss-Legendre-Lagrange", 3, true, "Tresca", 0.02,
       0.3, 0.2},
      {"arcs, free to fall", Form::Density, "Gauss-Legendre-Lagrange", 1, false,
       "Coulomb", 0.3, 0.3, 0.2},
      {"rough", Form::Density, "Gauss-Legendre-Lagrange", 3, true, "Coulomb", 0.4, 0.3, 0,
       "Exponential"},
      {"a layer, control points", Form::Density, "Bernstein", 3, true, "Coulomb", 0.4,
       0.3, 0, "Linear"},
      {"a layer, free to fall", Form::Density, "Gauss-Legendre-Lagrange", 1, false,
       "Coulomb", 0.3, 0.3, 0.2, "Linear"},
  };
}

double zero(bem::Vec2) { return 0; }

/// Pressed onto a parabola and pulled aside; clamped above, or free to move down.
contact::Conditions conditionsOf(const Case& c, double load = 1) {
  contact::Conditions conditions;
  if (c.isClamped)
    conditions.dirichlet["top"] = {zero, [load](bem::Vec2) { return -0.003 * load; }};
  else
    conditions.neumann["top"] = {zero, [load](bem::Vec2) { return -0.02 * load; }};
  conditions.fix = {!c.isClamped, false, !c.isClamped};
  conditions.neumann["left"] = {[load](bem::Vec2 x) { return 0.01 * load * (1 - x.y); },
                                zero};
  contact::Friction friction;
  if (!c.law.empty())
    friction = contact::makeFriction(
        c.law, {[&c](bem::Vec2 x) {
          return c.basis == "Bernstein" ? c.friction * (1 + x.x * x.x) : c.friction;
        }});
  conditions.contact["bottom"] = {
      [](bem::Vec2 x) { return 0.004 * (x.x - 0.5) * (x.x - 0.5); }, friction};
  if (c.normal != nullptr)
    conditions.contact["bottom"].normal = contact::makeNormal(
        c.normal, std::vector<bem::Function>(c.normal == std::string("Linear") ? 1 : 2,
                                             [](bem::Vec2) { return 0.01; }));
  return conditions;
}

/// All that comes of a stiffness.
struct Results {
  contact::ContactSystem system;
  contact::Solution solution;
  Vector force;
  Vector displacement;
  Vector density;

  explicit Results(const contact::BodyInput& input)
      : system({input}),
        solution(test::solve(system.numbers())),
        force(body().contactForce(solution.state.multiplier)),
        displacement(body().displacement(solution.state, force)),
        density(body().density(solution.state, displacement, force)) {}

  const contact::ContactBody& body() const { return system.body(0); }
  Vector clampWork() const {
    return body().clampWork(
        body().results(solution.state, displacement, force).clampForces);
  }
};

bem::Matrix entriesOf(const contact::Flexibility& flexibility) {
  bem::Matrix result(flexibility.size(), flexibility.size());
  for (Index j = 0; j < flexibility.size(); ++j) {
    Vector unit(bem::at(flexibility.size()));
    unit[j] = 1;
    const Vector column = flexibility.times(unit);
    std::copy(column.begin(), column.end(), result.column(j));
  }
  return result;
}

double difference(const Vector& a, const Vector& b, double size) {
  return test::largestDifference(a, b) / size;
}

bem::Mesh meshOf(const Case& c) {
  bem::Loop loop = test::rectangle({0, 0}, 1, 1);
  if (c.bulge != 0)
    loop.bulges = {c.bulge, 0, -c.bulge, c.bulge};
  const int elements = c.degree == 1 ? 40 : c.degree > 3 ? 6 : 16;
  return bem::makeMesh(test::outlineOf(loop), std::vector<int>(4, elements), c.degree);
}

/// What both ways to know a stiffness make of a case.
struct Pair : test::BodyScene {
  bem::SteklovPoincare dense = BodyScene::dense();
  bem::SteklovPoincare compressed = BodyScene::compressed();

  explicit Pair(const Case& c)
      : BodyScene({meshOf(c),
                   {1, c.nu, false},
                   conditionsOf(c),
                   c.basis,
                   test::ofForm(c.form)}) {}

  contact::BodyInput input(const bem::SteklovPoincare& stiffness,
                           Index formedUpTo = 0) const {
    contact::BodyInput result = BodyScene::input(stiffness);
    result.formedUpTo = formedUpTo;
    return result;
  }
};

TEUCHOS_UNIT_TEST(CompressedBody, problemsAreTheDenseOnes) {
  for (const Case& c : cases()) {
    out << c.name << "\n";
    const Pair pair(c);
    const Results exact(pair.input(pair.dense));
    const Results own(pair.input(pair.compressed));

    const contact::Problem& a = exact.system.numbers();
    const contact::Problem& b = own.system.numbers();
    TEST_ASSERT(!b.flexibility.isFormed());
    const bem::Matrix columns = entriesOf(b.flexibility);
    const contact::ContactSystem formed({pair.input(pair.compressed, a.size())});
    const contact::Flexibility& entries = formed.numbers().flexibility;
    double size = 0;
    double error = 0;
    double skew = 0;
    for (Index j = 0; j < a.size(); ++j)
      for (Index i = 0; i < a.size(); ++i) {
        size = std::max(size, std::abs(a.flexibility(i, j)));
        error = std::max({error, std::abs(a.flexibility(i, j) - columns(i, j)),
                          std::abs(a.flexibility(i, j) - entries(i, j))});
        skew = std::max(skew, std::abs(entries(i, j) - entries(j, i)));
      }
    TEST_COMPARE(error, <, 1e-9 * size);
    TEST_EQUALITY(skew, 0);
    const Vector& sums = a.flexibility.responses(a.normals);
    const Vector& estimates = b.flexibility.responses(b.normals);
    for (Index i = 0; i < a.size(); ++i)
      TEST_COMPARE(std::abs(estimates[i] / sums[i] - 1), <, 0.05);
    TEST_COMPARE(difference(b.offset, a.offset, largest(a.offset)), <, 1e-9);

    TEST_ASSERT(exact.solution.report.converged());
    TEST_ASSERT(own.solution.report.converged());
    const Vector& lambda = exact.solution.state.multiplier;
    TEST_COMPARE(difference(own.solution.state.multiplier, lambda, largest(lambda)), <,
                 1e-8);
    TEST_COMPARE(
        difference(own.displacement, exact.displacement, largest(exact.displacement)), <,
        1e-9);
    TEST_COMPARE(difference(own.density, exact.density, largest(exact.density)), <, 1e-7);
    const Vector work = exact.clampWork();
    TEST_COMPARE(difference(own.clampWork(), work, 1e-2), <, 1e-9);
    TEST_COMPARE(difference(own.body().fixedReactions(own.force),
                            exact.body().fixedReactions(exact.force), 1e-2),
                 <, 1e-9);
  }
}

/// Newton's method that gives up at once where D is not formed.
class OnlyFormed final : public contact::Newton {
 public:
  contact::NewtonRun run(const contact::Equation& equation, const Vector& start,
                         int maximumIterations) const override {
    const bool formed = equation.problem().flexibility.isFormed();
    return newton_.run(equation, start, formed ? maximumIterations : 1);
  }

 private:
  contact::NoxNewton newton_;
};

/// Where Newton's method fails, D is formed and the offset followed.
TEUCHOS_UNIT_TEST(CompressedBody, isSolvedWhereNewtonsStepsFail) {
  const OnlyFormed newton;
  for (const Case& c : cases()) {
    const Pair pair(c);
    const Results exact(pair.input(pair.dense));
    const contact::ContactSystem own({pair.input(pair.compressed)});
    const contact::ContactSolver solver(newton);
    const auto coulomb = makeCoulomb(solver, {});
    const contact::Solution solution = coulomb->solve(own.numbers(), {});
    TEST_EQUALITY(solution.report.stages.size(), 2u);
    TEST_ASSERT(solution.report.stages.back().stage == contact::Stage::FollowOffset);
    TEST_ASSERT(solution.report.converged());
    const Vector& lambda = exact.solution.state.multiplier;
    TEST_COMPARE(difference(solution.state.multiplier, lambda, largest(lambda)), <, 1e-7);
  }
}

using System = contact::Flexibility::Operator::System;

/// Every n-th normal coefficient, no motions.
System systemOf(const contact::Problem& problem, Index n) {
  System system;
  system.motions = bem::Matrix(problem.size(), 0);
  for (Index i = 0; i < problem.normals; i += n)
    system.rows.push_back(i);
  return system;
}

/// What is not a number breaks every elimination, whatever the kernels' order of sums.
System brokenSystem(const contact::Problem& problem) {
  System system = systemOf(problem, 2);
  system.followers.push_back({1, 0, std::numeric_limits<double>::quiet_NaN()});
  return system;
}

/// Of ones in the rows of every n-th.
Vector solved(const contact::Flexibility::Operator::Factor& factor,
              const contact::Problem& problem, Index n) {
  Vector b(bem::at(problem.size()));
  for (const Index i : systemOf(problem, n).rows)
    b[bem::at(i)] = 1;
  return columnOf(factor.solve(bem::ConstMatrixView(b).copy()), 0);
}

/// Two points of Newton's may be solved with in turns, and what breaks down leaves nothing behind.
TEUCHOS_UNIT_TEST(CompressedBody, aFactorStaysWhateverIsFactoredAfterIt) {
  for (const Case& c : cases()) {
    out << c.name << "\n";
    const Pair pair(c);
    const contact::ContactSystem own({pair.input(pair.compressed)});
    const contact::Problem& problem = own.numbers();
    const contact::Flexibility& d = problem.flexibility;
    const auto first = d.factor(systemOf(problem, 2));
    const Vector alone = solved(*first, problem, 2);
    const auto second = d.factor(systemOf(problem, 3));
    const Vector other = solved(*second, problem, 3);
    TEST_COMPARE(difference(solved(*first, problem, 2), alone, largest(alone)), <, 1e-13);
    TEST_THROW(d.factor(brokenSystem(problem)), bem::NumericalError);
    TEST_COMPARE(difference(solved(*second, problem, 3), other, largest(other)), <,
                 1e-13);
    const auto again = d.factor(systemOf(problem, 2));
    TEST_COMPARE(difference(solved(*again, problem, 2), alone, largest(alone)), <, 1e-13);
  }
}

/// A step of a path and what follows from its solution.
struct Step {
  std::vector<contact::Conditions> conditions;
  contact::ContactSystem system;
  contact::Configuration at;

  Step(const contact::ContactSystem& atZero, const Case& c, double load)
      : conditions{conditionsOf(c, load)}, system(atZero.under(conditions)) {}

  /// Energies, forces and densities: all that bodies keep something for.
  std::vector<Vector> results() const {
    const contact::ContactBody& body = system.body(0);
    const Vector& u = at.displacements.front();
    const contact::ContactBody::Results own =
        body.results(at.state, u, at.contactForces.front());
    return {{own.strainEnergy}, {own.storedEnergy}, at.state.multiplier, u,
            own.clampForces,    own.density};
  }
};

/// A step that fails, in whatever state it ends, changes no later one.
TEUCHOS_UNIT_TEST(CompressedBody, aFailedStepLeavesNothingBehind) {
  for (const Case& c : cases()) {
    out << c.name << "\n";
    const Pair pair(c);
    for (const bem::SteklovPoincare* stiffness : {&pair.dense, &pair.compressed}) {
      const auto lastStep = [&](bool failsBefore) {
        const contact::ContactSystem atZero({pair.input(*stiffness)});
        if (failsBefore) {
          Step failing(atZero, c, 2);
          const contact::Problem& problem = failing.system.numbers();
          const contact::Equation equation = test::equationOf(problem);
          const contact::NewtonRun run =
              contact::NoxNewton().run(equation, Vector(bem::at(equation.size())), 1);
          TEST_ASSERT(run.end != contact::End::Converged);
          failing.at = failing.system.configuration(contact::unpack(problem, run.last));
          failing.results();
          if (!problem.flexibility.isFormed())
            TEST_THROW(problem.flexibility.factor(brokenSystem(problem)),
                       bem::NumericalError);
        }
        Step step(atZero, c, 1);
        const contact::Solution solution = test::solve(step.system.numbers());
        TEST_ASSERT(solution.report.converged());
        step.at = step.system.configuration(solution.state);
        return step.results();
      };
      const std::vector<Vector> fresh = lastStep(false);
      const std::vector<Vector> later = lastStep(true);
      for (std::size_t k = 0; k < fresh.size(); ++k)
        TEST_COMPARE(test::largestDifference(later[k], fresh[k]), <=,
                     1e-12 * largest(fresh[k]));
    }
  }
}

TEUCHOS_UNIT_TEST(CompressedBody, whatCannotBeCompressedIsRefused) {
  TEST_ASSERT(!contact::whyNotCompressed(test::projected()).empty());
  TEST_ASSERT(contact::whyNotCompressed(Stabilization()).empty());
}

}  // namespace

}  // namespace epafi
