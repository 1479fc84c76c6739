#include "contact/solve/ContactSolver.hpp"
#include "drivers/output/PrintedTable.hpp"
#include "drivers/run/Solver.hpp"
#include "test/drivers/SceneText.hpp"

#include <Teuchos_UnitTestHarness.hpp>

namespace epafi {

namespace {

using contact::End;
using contact::Stage;
using test::contains;

TEUCHOS_UNIT_TEST(Reasons, nameTheLimitOfWhatWasNotTried) {
  const drivers::Scene scene = test::read(test::SceneText());
  const std::string limit = std::to_string(contact::ContactSolver::mostToPivot);
  contact::Report report;
  report.stages = {{Stage::FullSteps, 50, 1, End::Iterations}};
  const std::string alone = reasonOf(report, scene);
  TEST_ASSERT(contains(alone, "Solver->Maximum Iterations") && !contains(alone, limit));
  report.stages.push_back({Stage::FollowOffset, 0, 1, End::TooLarge});
  const std::string both = reasonOf(report, scene);
  TEST_ASSERT(contains(both, "Solver->Maximum Iterations") && contains(both, limit));
  TEST_ASSERT(contains(contact::told(report.stages), "follow offset 0 too large"));
}

TEUCHOS_UNIT_TEST(Reasons, nameTheWorkThatWasTooMuch) {
  const drivers::Scene scene = test::read(test::SceneText());
  contact::Report report;
  report.stages = {{Stage::FullSteps, 50, 1, End::Iterations},
                   {Stage::FollowOffset, 20, 1, End::Cycling},
                   {Stage::FollowOffset, 0, 1, End::TooLong}};
  const std::string text = reasonOf(report, scene);
  TEST_ASSERT(contains(text, "Solver->Maximum Iterations") &&
              contains(text, "given up after 5e+12"));
  TEST_ASSERT(contains(text, "smaller friction coefficient") &&
              !contains(text, "There is no solution"));
  TEST_ASSERT(contains(contact::told(report.stages), "follow offset 0 too long"));
}

TEUCHOS_UNIT_TEST(Reasons, blameFrictionWhereSomethingSlides) {
  contact::Report report;
  report.stages = {{Stage::FullSteps, 50, 1, End::Iterations},
                   {Stage::FollowOffset, 20, 1, End::Cycling}};
  test::SceneText text;
  const char* blamed = "beyond what friction holds";
  TEST_ASSERT(contains(reasonOf(report, test::read(text)), blamed));
  for (const char* law : {"None", "Tied"}) {
    text.base = test::parameter("Type", "Contact") + test::friction(law);
    const std::string reason = reasonOf(report, test::read(text));
    TEST_ASSERT(!contains(reason, blamed) && contains(reason, "rounding has taken"));
  }
}

TEUCHOS_UNIT_TEST(PrintedTable, namesTheContactsWithTheLargestForces) {
  drivers::StepRow row;
  for (const double force : {1., 5., 2., 4., 3.}) {
    contact::Summary summary;
    summary.forceNormal = force;
    row.contacts.emplace_back(bem::message("c", force), summary);
  }
  const std::string line = tableLine(row);
  out << line;
  TEST_ASSERT(line.find("; c5 ") < line.find("; c4 ") &&
              contains(line, "; c3 normal force 3"));
  TEST_ASSERT(!contains(line, "c2") && !contains(line, "c1") &&
              contains(line, "; 2 more in steps.csv"));
  row.contacts.resize(3);
  TEST_ASSERT(contains(tableLine(row), "; c1 ") && !contains(tableLine(row), "more"));
}

}  // namespace

}  // namespace epafi
