#include "adaptivity/mark/Strategy.hpp"

#include "Message.hpp"
#include "Processes.hpp"
#include "Rectangle.hpp"
#include "bem/basis/Legendre.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <numeric>

namespace epafi {

namespace {

using adaptivity::Mark;

std::vector<int> worstOf(const bem::Mesh& mesh) {
  bem::Vector squares;
  for (int e = 0; e < mesh.size(); ++e)
    squares.push_back(1 + e);
  return adaptivity::doerfler(squares, 0.3);
}

/// A level whose indicators grow along the boundary; every second element looks analytic.
adaptivity::LevelData levelOn(const bem::Mesh& mesh) {
  adaptivity::LevelData level{mesh, {}, {}, {}};
  level.singular.nodes.resize(mesh.size());
  level.singular.inside.resize(mesh.size());
  for (int e = 0; e < mesh.size(); ++e) {
    level.analytic.push_back(e % 2 == 0);
  }
  level.worst = worstOf(mesh);
  return level;
}

/// All elements of equal weight, marked and smooth.
adaptivity::LevelData allMarkedOn(const bem::Mesh& mesh) {
  adaptivity::LevelData level = levelOn(mesh);
  level.worst.resize(mesh.size());
  std::iota(level.worst.begin(), level.worst.end(), 0);
  level.analytic.assign(mesh.size(), true);
  return level;
}

/// One whose node 1, an end of elements 0 and 1, is singular.
adaptivity::LevelData singularOn(const bem::Mesh& mesh) {
  adaptivity::LevelData level = allMarkedOn(mesh);
  level.singular.nodes[1] = adaptivity::Singularity::Strong;
  return level;
}

adaptivity::Marks marksOf(const char* strategy, const adaptivity::LevelData& level) {
  return adaptivity::strategies().at(strategy).marks(level);
}

adaptivity::Marks graded(const adaptivity::LevelData& level) {
  return marksOf("Graded hp", level);
}

}  // namespace

/// Runs over the table, so a new strategy is tested from the day it is listed.
TEUCHOS_UNIT_TEST(Strategy, everyStrategyMarksEveryElementAndIsFoundByItsName) {
  const bem::Mesh mesh = test::squareMesh(2);
  for (const adaptivity::Strategy& strategy : adaptivity::strategies()) {
    TEST_EQUALITY(adaptivity::strategies().at(strategy.name).marks, strategy.marks);
    const adaptivity::Marks marks = strategy.marks(levelOn(mesh));
    TEST_EQUALITY(static_cast<int>(marks.size()), mesh.size());
    TEST_ASSERT(adaptivity::decide(strategy, levelOn(mesh), test::processes()) == marks);
  }
}

TEUCHOS_UNIT_TEST(Strategy, uniformStrategiesTreatAllElementsAlike) {
  const bem::Mesh mesh = test::squareMesh(2);
  const bem::Mesh finer = adaptivity::refine(mesh, marksOf("Uniform h", levelOn(mesh)));
  const bem::Mesh richer = adaptivity::refine(mesh, marksOf("Uniform p", levelOn(mesh)));
  TEST_EQUALITY(finer.size(), 2 * mesh.size());
  TEST_EQUALITY(richer.size(), mesh.size());
  for (int e = 0; e < mesh.size(); ++e) {
    TEST_FLOATING_EQUALITY(finer[2 * e].half, 0.5 * mesh[e].half, 1e-15);
    TEST_FLOATING_EQUALITY(finer[2 * e + 1].half, 0.5 * mesh[e].half, 1e-15);
    TEST_EQUALITY(finer[2 * e].degree, mesh[e].degree);
    TEST_EQUALITY(richer[e].degree, mesh[e].degree + 1);
    TEST_EQUALITY(richer[e].half, mesh[e].half);
  }
}

TEUCHOS_UNIT_TEST(Strategy, uniformPEndsAtTheLargestDegree) {
  const bem::Mesh mesh = test::squareMesh(bem::largestDegree);
  TEST_ASSERT(!adaptivity::anyMarked(marksOf("Uniform p", levelOn(mesh))));
  TEST_ASSERT(!adaptivity::anyMarked(marksOf("None", levelOn(mesh))));
  TEST_ASSERT(adaptivity::anyMarked(marksOf("Uniform h", levelOn(mesh))));
}

TEUCHOS_UNIT_TEST(Strategy, adaptiveStrategiesTouchOnlyTheWorstElements) {
  const bem::Mesh mesh = test::squareMesh(2);
  const adaptivity::LevelData level = levelOn(mesh);
  const std::vector<int> worst = worstOf(mesh);
  const adaptivity::Marks h = marksOf("Adaptive h", level);
  const adaptivity::Marks hp = marksOf("Adaptive hp", level);
  for (int e = 0; e < mesh.size(); ++e) {
    const bool marked = std::find(worst.begin(), worst.end(), e) != worst.end();
    TEST_EQUALITY(h[e] == Mark::Bisect, marked);
    TEST_EQUALITY(hp[e] == Mark::None, !marked);
    if (marked)
      TEST_EQUALITY(hp[e] == Mark::RaiseDegree, static_cast<bool>(level.analytic[e]));
  }
}

TEUCHOS_UNIT_TEST(Strategy, adaptiveHpBisectsWhereTheDegreeIsTheLargest) {
  const bem::Mesh mesh = test::squareMesh(bem::largestDegree);
  const adaptivity::LevelData level = levelOn(mesh);
  TEST_ASSERT(marksOf("Adaptive hp", level) == marksOf("Adaptive h", level));
}

TEUCHOS_UNIT_TEST(Strategy, anUnknownNameIsAnInputErrorThatListsTheKnownOnes) {
  const std::string told =
      test::messageOf([] { adaptivity::strategies().at("Uniform q"); });
  for (const adaptivity::Strategy& known : adaptivity::strategies())
    TEST_ASSERT(test::contains(told, known.name));
}

TEUCHOS_UNIT_TEST(GradedHp, cutsTowardSingularPointsAndRaisesDegreesElsewhere) {
  const bem::Mesh mesh = test::squareMesh(2);
  adaptivity::LevelData level = singularOn(mesh);
  level.singular.inside[3] = {0.1};
  const adaptivity::Marks marks = graded(level);
  const int p = mesh[0].degree;

  TEST_ASSERT(marks[0] == Mark::Cut);  // its end is singular
  TEST_FLOATING_EQUALITY(marks[0].places().front(), 0.8, 1e-14);
  TEST_ASSERT(marks[0].degrees() == std::vector<int>({p + 1, p}));
  TEST_ASSERT(marks[1] == Mark::Cut);
  TEST_FLOATING_EQUALITY(marks[1].places().front(), -0.8, 1e-14);
  TEST_ASSERT(marks[1].degrees() == std::vector<int>({p, p + 1}));
  TEST_ASSERT(marks[3] == Mark::cut({0.1}, {p, p}));
  TEST_ASSERT(marks[2] == Mark::RaiseDegree);
}

TEUCHOS_UNIT_TEST(GradedHp, doesWithTransitionsWhatItsOptionSays) {
  const bem::Mesh mesh = test::squareMesh(2);
  adaptivity::LevelData level = allMarkedOn(mesh);
  level.singular.inside[3] = {0.1};
  const int p = mesh[3].degree;
  level.grading.transitions = "Surround";
  const Mark surround = graded(level)[3];
  TEST_EQUALITY(static_cast<int>(surround.places().size()), 2);
  TEST_FLOATING_EQUALITY(surround.places().front(), -0.1, 1e-14);
  TEST_FLOATING_EQUALITY(surround.places().back(), 0.3, 1e-14);
  TEST_ASSERT(surround.degrees() == std::vector<int>({p + 1, p, p + 1}));
  level.grading.transitions = "Bisect";
  TEST_ASSERT(graded(level)[3] == Mark::Bisect);
}

// Between steps the kinks move, so that a piece of high degree has one inside in most of them.
TEUCHOS_UNIT_TEST(GradedHp, leavesDegreeTwoToPiecesThatTransitionsOfSeveralStatesCross) {
  for (const int degree : {1, 2, 5}) {
    const bem::Mesh mesh = test::squareMesh(degree);
    adaptivity::LevelData level = allMarkedOn(mesh);
    level.singular.inside[3] = {-0.3, 0.1};
    TEST_ASSERT(graded(level)[3] == Mark::cut({-0.3, 0.1}, {degree, degree, degree}));
    level.singular.states = 2;
    const int low = std::min(degree, 2);
    TEST_ASSERT(graded(level)[3] == Mark::cut({-0.3, 0.1}, {low, low, low}));
    TEST_ASSERT(graded(level)[1] == Mark::RaiseDegree);
  }
}

TEUCHOS_UNIT_TEST(GradedHp, takesRatioStepAndDecayFromItsOptions) {
  const bem::Mesh mesh = test::squareMesh(2);
  adaptivity::LevelData level = singularOn(mesh);
  level.analytic[2] = false;
  level.grading.ratio = 0.25;
  level.grading.degreeStep = 2;
  level.grading.smooth = "Legendre Decay";
  const adaptivity::Marks marks = graded(level);
  const int p = mesh[0].degree;
  TEST_ASSERT(marks[0] == Mark::cut({0.5}, {p + 2, p}));
  TEST_ASSERT(marks[2] == Mark::Bisect);
  TEST_ASSERT(marks[3] == Mark::RaiseDegree);
  level.grading.layers = 2;
  TEST_ASSERT(graded(level)[0] == Mark::cut({0.5, 0.875}, {p + 2, p + 2, p}));
  TEST_ASSERT(graded(level)[1] == Mark::cut({-0.875, -0.5}, {p, p + 2, p + 2}));
}

TEUCHOS_UNIT_TEST(GradedHp, halvesSmoothElementsAtTheLargestDegreeOfTheMultiplier) {
  const bem::Mesh mesh = test::squareMesh(6);
  adaptivity::LevelData level = singularOn(mesh);
  level.grading.largestDegree = 6;
  const adaptivity::Marks marks = graded(level);
  TEST_ASSERT(marks[1] == Mark::cut({-0.8}, {6, 6}));
  TEST_ASSERT(marks[3] == Mark::Bisect);
  level.grading.largestDegree = 7;
  TEST_ASSERT(graded(level)[3] == Mark::RaiseDegree);
}

TEUCHOS_UNIT_TEST(GradedHp, leavesWeakPointsToTheDegreeAtFirst) {
  for (const int degree : {1, 6}) {
    const bem::Mesh mesh = test::squareMesh(degree);
    adaptivity::LevelData level = allMarkedOn(mesh);
    level.singular.nodes[0] = adaptivity::Singularity::Weak;
    const adaptivity::Marks marks = graded(level);
    TEST_ASSERT(marks[0] == (degree == 1 ? Mark::RaiseDegree : Mark::Cut));
  }
}

TEUCHOS_UNIT_TEST(GradedHp, takesNeighboursAlongThatStayBehindByMoreThanTwo) {
  for (const int degree : {2, 3}) {
    const bem::Mesh square = test::squareMesh(1);
    std::vector<bem::Piece> pieces;
    for (const bem::Element& element : square.elements())
      pieces.push_back(element.piece);
    pieces[2].degree = degree;
    const bem::Mesh mesh(square.sharedOutline(), pieces);
    adaptivity::LevelData level = allMarkedOn(mesh);
    level.worst = {2};
    const adaptivity::Marks marks = graded(level);
    const Mark neighbour = degree == 3 ? Mark::RaiseDegree : Mark::None;
    TEST_ASSERT(marks[2] == Mark::RaiseDegree);
    TEST_ASSERT(marks[1] == neighbour);
    TEST_ASSERT(marks[3] == neighbour);
    TEST_ASSERT(marks[0] == Mark::None);
  }
}

}  // namespace epafi
