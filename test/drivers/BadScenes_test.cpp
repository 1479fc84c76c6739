// Lists in order that make no scene: outlines, meshes, conditions, expressions.
#include "drivers/commands/Commands.hpp"
#include "test/drivers/Complaints.hpp"

#include <Teuchos_UnitTestHarness.hpp>

namespace epafi {

namespace {

using namespace test;

const std::string body = "Bodies->block->";
const std::string base = body + "Boundary Conditions->base->";

SceneText withGap(const std::string& gap) {
  SceneText scene;
  scene.base = parameter("Type", "Contact") + parameter("Gap", gap);
  return scene;
}

/// What evaluating every expression of a scene ends with.
std::string complaintOfCheck(const SceneText& text) {
  const test::TemporaryFile file("scene.xml", text.xml());
  return messageOf([&] { drivers::checkScene(drivers::readScene(file.path())); });
}

}  // namespace

TEUCHOS_UNIT_TEST(BadScenes, polygonsThatAreOpenOrCrossAreRefused) {
  TEST_COMPLAINT(withVertices("4x2:{0,0, 2,0, 2,1, 0,1}", "{base, right, top}").xml(),
                 body + "Geometry->Edges", "4", "3");
  TEST_COMPLAINT(
      withVertices("4x2:{0,0, 2,1, 2,0, 0,1}", "{base, right, top, left}").xml(),
      body + "Geometry", "outer polygon", "crosses");
  SceneText disc = withVertices("4x2:{1,0, 0,-1, -1,0, 0,1}", "{base, right, top, left}");
  disc.geometry += entry("Bulges", "Array(double)", "{0.6, 0.6, 0.6, 0.6}");
  TEST_COMPLAINT(disc.xml(), body + "Geometry", "crosses", "clockwise");
  SceneText hole;
  hole.geometry +=
      entry("Hole 1 Vertices", "TwoDArray(double)", "3x2:{0.5,0.5, 1.5,0.5, 1,1}");
  TEST_COMPLAINT(hole.xml(), body + "Geometry->Hole 1 Edges", "missing");
  hole.geometry += entry("Hole 1 Edges", "Array(string)", "{h, h, h}");
  TEST_COMPLAINT(hole.xml(), body + "Geometry", "outer polygon", "hole 1");
}

TEUCHOS_UNIT_TEST(BadScenes, arcsFitTogether) {
  const auto with = [](const std::string& key, const std::string& values) {
    SceneText scene;
    scene.geometry += entry(key, "Array(double)", values);
    return scene.xml();
  };
  const std::string geometry = body + "Geometry";
  TEST_EQUALITY(complaintOf(with("Bulges", "{0, 0.1, 0, -0.2}")), "");
  TEST_COMPLAINT(with("Bulges", "{0, 0.1}"), geometry + "->Bulges", "4", "2");
  TEST_COMPLAINT(with("Bulges", "{0, 0.1, 0, -11}"), geometry + "->Bulges", "-11", "10");
  TEST_COMPLAINT(with("Bulges", "{0, 0.1, 0, inf}"), geometry + "->Bulges", "inf");
  TEST_COMPLAINT(with("Bulges", "{-1, 0, -1, 0}"), geometry, "touches or crosses");
  SceneText coarse;
  coarse.geometry += entry("Bulges", "Array(double)", "{0, 1.1, 0, 0}");
  coarse.discretization = elements("{4, 1, 4, 2}");
  TEST_COMPLAINT(coarse.xml(), "Discretization->Elements per Edge", "'right'", "180");
  TEST_COMPLAINT(with("Bulges", "{0, 0.1x, 0, 0}"), geometry + "->Bulges", "0.1x");
  TEST_COMPLAINT(with("Hole 1 Bulges", "{0, 0, 0}"), geometry + "->Hole 1 Bulges");
}

TEUCHOS_UNIT_TEST(BadScenes, unnamedEdgesAndConditionsForNoEdgeAreRefused) {
  TEST_COMPLAINT(withVertices("4x2:{0,0, 2,0, 2,1, 0,1}", "{base, , top, left}").xml(),
                 body + "Geometry->Edges", "1", "''");
  SceneText scene;
  scene.conditions = list("lefft", parameter("Type", "Neumann"));
  TEST_COMPLAINT(scene.xml(), body + "Boundary Conditions->lefft", "'left'");
}

std::string withHistory(const std::string& content) {
  return withRest(list("History", content)).xml();
}

std::string times(const std::string& value) {
  return entry("Times", "Array(double)", value);
}

std::string steps(const std::string& type, const std::string& value) {
  return entry("Steps", type, value);
}

TEUCHOS_UNIT_TEST(BadScenes, aPathGoesForward) {
  TEST_COMPLAINT(withHistory(steps("int", "3")), "History->Times", "missing", "Steps");
  TEST_COMPLAINT(withHistory(times("{}")), "History->Times", "empty");
  TEST_COMPLAINT(withHistory(times("{1, 2, 2}")), "History->Times", "2", "increase");
  TEST_COMPLAINT(withHistory(times("{0, 1}")), "History->Times", "> 0");
  TEST_COMPLAINT(withHistory(times("{-1}")), "History->Times", "> 0");
  TEST_COMPLAINT(withHistory(times("{1, 2}") + steps("Array(int)", "{1, 2, 3}")),
                 "History->Steps", "3", "2");
  TEST_COMPLAINT(withHistory(times("{1}") + steps("int", "0")), "History->Steps", "0");
  TEST_COMPLAINT(withHistory(times("{1}") + steps("int", "1000000")), "History->Steps",
                 "100000");
  TEST_COMPLAINT(withHistory(times("{1}") + steps("string", "many")), "History->Steps",
                 "Array(int)");
  TEST_COMPLAINT(withHistory(times("{1}") + real("Minimum Step", "0")),
                 "History->Minimum Step", "> 0");
  TEST_COMPLAINT(withHistory(times("{1}") + real("Tolerance", "1")), "History->Tolerance",
                 "[0, 1)");
  TEST_COMPLAINT(withHistory(times("{1}") + real("Step", "1")), "History->Step", "Steps");
}

TEUCHOS_UNIT_TEST(BadScenes, versionsBeforeTheFirstReleaseAreRefused) {
  const auto by = [](const std::string& version) {
    return withRest(list("Versions", parameter("Epafi", version)));
  };
  TEST_COMPLAINT(by("0.1.0").xml(), "written by Epafi 0.1.0", "0.2");
  TEST_NOTHROW(test::read(by("0.2.0")));
  TEST_NOTHROW(test::read(by("0.10.0")));
}

TEUCHOS_UNIT_TEST(BadScenes, theMeshFitsTheOutline) {
  SceneText scene;
  scene.discretization = elements("{4, 2, 4}");
  TEST_COMPLAINT(scene.xml(), "Discretization->Elements per Edge", "3", "4");
  scene.discretization = elements("{4, 2, 4, 2, 4, 2, 4, 2}");
  TEST_COMPLAINT(scene.xml(), "Discretization->Elements per Edge", "8", "Hole <k>");
  TEST_COMPLAINT(withDiscretization(real("Mesh Size", "0.5")).xml(),
                 "Discretization->Elements per Edge", "Mesh Size");
  scene.discretization = real("Mesh Size", "1e-9");
  TEST_COMPLAINT(scene.xml(), "Discretization->Mesh Size", "1e-09");
  const std::string hole = "Hole 1 Elements per Edge";
  TEST_COMPLAINT(withDiscretization(entry(hole, "Array(int)", "{1, 1, 1}")).xml(),
                 "Discretization->" + hole, "0");
}

TEUCHOS_UNIT_TEST(BadScenes, conditionsAreComplete) {
  SceneText scene;
  scene.top = parameter("Type", "Dirichlet");
  TEST_COMPLAINT(scene.xml(), "Boundary Conditions->top", "Displacement");
  scene = SceneText();
  scene.base = parameter("Type", "Contact") + friction("Tresca");
  TEST_COMPLAINT(scene.xml(), base + "Friction->Threshold", "missing");
  scene.base = parameter("Type", "Contact") + friction("Columb");
  TEST_COMPLAINT(scene.xml(), base + "Friction->Law", "'Columb'", "'Coulomb'");
  scene = SceneText();
  scene.rigid = entry("Fix", "Array(string)", "{X, Rotatoin}");
  TEST_COMPLAINT(scene.xml(), body + "Rigid Motions->Fix", "'Rotatoin'", "'Rotation'");
}

TEUCHOS_UNIT_TEST(BadScenes, expressionsAreOneNumberAndAssignNothing) {
  TEST_COMPLAINT(withGap("1,5").xml(), base + "Gap", "'1,5'", "2");
  TEST_COMPLAINT(withGap("x = 3").xml(), base + "Gap", "'x = 3'");
  TEST_COMPLAINT(withGap("x +").xml(), base + "Gap", "'x +'");
  TEST_COMPLAINT(withGap("2*z").xml(), base + "Gap", "'2*z'");
  TEST_COMPLAINT(withGap("1d-3").xml(), base + "Gap", "'1d-3'");
  TEST_COMPLAINT(withGap("foo(x)").xml(), base + "Gap", "'foo(x)'");
  TEST_COMPLAINT(withGap(" ").xml(), base + "Gap");
  SceneText scene;
  scene.base = parameter("Type", "Contact") + entry("Gap", "bool", "true");
  TEST_COMPLAINT(scene.xml(), base + "Gap", "bool");
}

TEUCHOS_UNIT_TEST(BadScenes, checkFindsThePointWhereAnExpressionIsNotFinite) {
  TEST_EQUALITY(complaintOfCheck(SceneText()), "");
  const std::string root = complaintOfCheck(withGap("sqrt(x - 1)"));
  TEST_ASSERT(contains(root, base + "Gap") && contains(root, "'sqrt(x - 1)'") &&
              contains(root, "(0.") && contains(root, "scene.xml: "));
  TEST_ASSERT(contains(complaintOfCheck(withGap("1/x")), "(0, 0)"));
  SceneText scene;
  scene.base = parameter("Type", "Contact") +
               friction("Coulomb", parameter("Coefficient", "0.5 - x"));
  TEST_ASSERT(contains(complaintOfCheck(scene), base + "Friction->Coefficient"));
}

TEUCHOS_UNIT_TEST(BadScenes, checkLooksWhereARunIntegratesLoads) {
  const auto withTraction = [](const std::string& traction) {
    SceneText scene;
    scene.rigid = entry("Fix", "Array(string)", "{X, Rotation}");
    scene.top = parameter("Type", "Neumann") + parameter("Traction Y", traction);
    return scene;
  };
  TEST_ASSERT(
      contains(complaintOfCheck(withTraction("-1/(x &gt; 0.005)")), "is -inf at"));
  TEST_EQUALITY(complaintOfCheck(withTraction("-1/(x &gt; 0.003)")), "");
}

TEUCHOS_UNIT_TEST(BadScenes, interiorPointsLieInside) {
  const std::string points =
      entry("Interior Points", "TwoDArray(double)", "2x2:{1, 0.5, 2, 0.5}");
  TEST_COMPLAINT(withRest(list("Output", points)).xml(), "Output->Interior Points", "1",
                 "(2, 0.5)");
}

}  // namespace epafi
