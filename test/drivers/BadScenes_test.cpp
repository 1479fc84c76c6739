// Lists in order that make no scene: outlines, meshes, conditions, expressions.
#include "drivers/commands/Commands.hpp"
#include "test/drivers/Complaints.hpp"

#include <Teuchos_UnitTestHarness.hpp>

namespace epafi {

namespace {

using test::complaintOf;
using test::contains;
using test::real;
using test::SceneText;
using test::withDiscretization;
using test::withVertices;

const std::string body = "Bodies->block->";
const std::string base = body + "Boundary Conditions->base->";

SceneText withGap(const std::string& gap) {
  SceneText scene;
  scene.base =
      R"(<Parameter name="Type" type="string" value="Contact"/>
         <Parameter name="Gap" type="string" value=")" +
      gap + "\"/>";
  return scene;
}

/// What evaluating every expression of a scene ends with.
std::string complaintOfCheck(const SceneText& text) {
  const test::TemporaryFile file("scene.xml", text.xml());
  try {
    drivers::checkScene(drivers::readScene(file.path()));
  } catch (const bem::InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEUCHOS_UNIT_TEST(BadScenes, openCrossingAndClockwisePolygonsAreRefused) {
  TEST_COMPLAINT(withVertices("4x2:{0,0, 2,0, 2,1, 0,1}", "{base, right, top}").xml(),
                 body + "Geometry->Edges", "4", "3");
  TEST_COMPLAINT(
      withVertices("4x2:{0,0, 2,1, 2,0, 0,1}", "{base, right, top, left}").xml(),
      body + "Geometry", "outer polygon", "crosses");
  TEST_COMPLAINT(
      withVertices("4x2:{0,0, 0,1, 2,1, 2,0}", "{base, right, top, left}").xml(),
      body + "Geometry", "outer polygon", "clockwise");
  SceneText disc = withVertices("4x2:{1,0, 0,-1, -1,0, 0,1}", "{base, right, top, left}");
  disc.geometry += R"(<Parameter name="Bulges" type='Array(double)'
    value="{0.6, 0.6, 0.6, 0.6}"/>)";
  TEST_COMPLAINT(disc.xml(), body + "Geometry", "crosses", "clockwise");
  TEST_COMPLAINT(
      withVertices("4x2:{0,0, 2,0, 2,1, 0,0}", "{base, right, top, left}").xml(),
      body + "Geometry", "first vertex");
  SceneText hole;
  hole.geometry += R"(<Parameter name="Hole 1 Vertices" type='TwoDArray(double)'
    value="3x2:{0.5,0.5, 1.5,0.5, 1,1}"/>)";
  TEST_COMPLAINT(hole.xml(), body + "Geometry->Hole 1 Edges", "missing");
  hole.geometry +=
      R"(<Parameter name="Hole 1 Edges" type='Array(string)' value="{h, h, h}"/>)";
  TEST_COMPLAINT(hole.xml(), body + "Geometry", "outer polygon", "hole 1");
}

TEUCHOS_UNIT_TEST(BadScenes, arcsFitTogether) {
  const auto with = [](const std::string& key, const std::string& values) {
    SceneText scene;
    scene.geometry +=
        "<Parameter name=\"" + key + "\" type='Array(double)' value=\"" + values + "\"/>";
    return scene.xml();
  };
  const std::string geometry = body + "Geometry";
  TEST_EQUALITY(complaintOf(with("Bulges", "{0, 0.1, 0, -0.2}")), "");
  TEST_COMPLAINT(with("Bulges", "{0, 0.1}"), geometry + "->Bulges", "4", "2");
  TEST_COMPLAINT(with("Bulges", "{0, 0.1, 0, -11}"), geometry + "->Bulges", "-11", "10");
  TEST_COMPLAINT(with("Bulges", "{0, 0.1, 0, inf}"), geometry + "->Bulges", "inf");
  TEST_COMPLAINT(with("Bulges", "{-1, 0, -1, 0}"), geometry, "touches or crosses");
  SceneText coarse;
  coarse.geometry +=
      R"(<Parameter name="Bulges" type='Array(double)' value="{0, 1.1, 0, 0}"/>)";
  coarse.discretization =
      R"(<Parameter name="Elements per Edge" type='Array(int)' value="{4, 1, 4, 2}"/>)";
  TEST_COMPLAINT(coarse.xml(), "Discretization->Elements per Edge", "'right'", "180");
  TEST_COMPLAINT(with("Bulges", "{0, 0.1x, 0, 0}"), geometry + "->Bulges", "0.1x");
  TEST_COMPLAINT(with("Hole 1 Bulges", "{0, 0, 0}"), geometry + "->Hole 1 Bulges");
}

TEUCHOS_UNIT_TEST(BadScenes, unnamedEdgesAndConditionsForNoEdgeAreRefused) {
  TEST_COMPLAINT(withVertices("4x2:{0,0, 2,0, 2,1, 0,1}", "{base, , top, left}").xml(),
                 body + "Geometry->Edges", "1", "''");
  SceneText scene;
  scene.conditions = R"(<ParameterList name="lefft">
    <Parameter name="Type" type="string" value="Neumann"/></ParameterList>)";
  TEST_COMPLAINT(scene.xml(), body + "Boundary Conditions->lefft", "'left'");
}

std::string withHistory(const std::string& content) {
  SceneText scene;
  scene.rest = "<ParameterList name=\"History\">" + content + "</ParameterList>";
  return scene.xml();
}

std::string times(const std::string& value) {
  return R"x(<Parameter name="Times" type="Array(double)" value=")x" + value + "\"/>";
}

std::string steps(const std::string& type, const std::string& value) {
  return "<Parameter name=\"Steps\" type=\"" + type + "\" value=\"" + value + "\"/>";
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

/// A used.xml of an earlier program holds all defaults of its time.
TEUCHOS_UNIT_TEST(BadScenes, removedKeysSayWhatTakesTheirPlace) {
  const auto withSolver = [](const std::string& key) {
    SceneText scene;
    scene.rest =
        "<ParameterList name=\"Solver\"><Parameter " + key + "/></ParameterList>";
    return scene;
  };
  const std::string steps = R"(name="Load Steps" type="int" value=)";
  TEST_COMPLAINT(withSolver(steps + R"("4")").xml(), "Solver->Load Steps", "History");
  TEST_NOTHROW(test::read(withSolver(steps + R"("1")")));
  const std::string function = R"(name="Complementarity" type="string" value=)";
  TEST_COMPLAINT(withSolver(function + R"("Fischer-Burmeister")").xml(),
                 "Solver->Complementarity", "merit");
  TEST_NOTHROW(test::read(withSolver(function + R"("Projection")")));
  const auto withReach = [](const std::string& reach) {
    SceneText scene;
    scene.rest = R"(<ParameterList name="Adaptivity"><ParameterList name="Grading">)"
                 R"(<Parameter name="Reach" type="double" value=")" +
                 reach + R"("/></ParameterList></ParameterList>)";
    return scene;
  };
  TEST_COMPLAINT(withReach("0.5").xml(), "Adaptivity->Grading->Reach", "nodes stay");
  TEST_NOTHROW(test::read(withReach("1.0")));
}

TEUCHOS_UNIT_TEST(BadScenes, theMeshFitsTheOutline) {
  SceneText scene;
  scene.discretization =
      R"(<Parameter name="Elements per Edge" type='Array(int)' value="{4, 2, 4}"/>)";
  TEST_COMPLAINT(scene.xml(), "Discretization->Elements per Edge", "3", "4");
  TEST_COMPLAINT(withDiscretization(real("Mesh Size", "0.5")).xml(),
                 "Discretization->Elements per Edge", "Mesh Size");
  scene.discretization = real("Mesh Size", "1e-9");
  TEST_COMPLAINT(scene.xml(), "Discretization->Mesh Size", "1e-09");
  TEST_COMPLAINT(withDiscretization(R"(<Parameter name="Hole 1 Elements per Edge"
    type='Array(int)' value="{1, 1, 1}"/>)")
                     .xml(),
                 "Discretization->Hole 1 Elements per Edge", "0");
}

TEUCHOS_UNIT_TEST(BadScenes, conditionsAreComplete) {
  SceneText scene;
  scene.top = R"(<Parameter name="Type" type="string" value="Dirichlet"/>)";
  TEST_COMPLAINT(scene.xml(), "Boundary Conditions->top", "Displacement");
  scene = SceneText();
  scene.base = R"(<Parameter name="Type" type="string" value="Contact"/>
    <ParameterList name="Friction">
      <Parameter name="Law" type="string" value="Tresca"/></ParameterList>)";
  TEST_COMPLAINT(scene.xml(), base + "Friction->Threshold", "missing");
  scene.base = R"(<Parameter name="Type" type="string" value="Contact"/>
    <ParameterList name="Friction">
      <Parameter name="Law" type="string" value="Columb"/></ParameterList>)";
  TEST_COMPLAINT(scene.xml(), base + "Friction->Law", "'Columb'", "'Coulomb'");
  scene = SceneText();
  scene.rigid = R"(<Parameter name="Fix" type='Array(string)' value="{X, Rotatoin}"/>)";
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
  scene.base = R"(<Parameter name="Type" type="string" value="Contact"/>
                  <Parameter name="Gap" type="bool" value="true"/>)";
  TEST_COMPLAINT(scene.xml(), base + "Gap", "bool");
}

TEUCHOS_UNIT_TEST(BadScenes, checkFindsThePointWhereAnExpressionIsNotFinite) {
  TEST_EQUALITY(complaintOfCheck(SceneText()), "");
  const std::string root = complaintOfCheck(withGap("sqrt(x - 1)"));
  TEST_ASSERT(contains(root, base + "Gap") && contains(root, "'sqrt(x - 1)'") &&
              contains(root, "(0.") && contains(root, "scene.xml: "));
  TEST_ASSERT(contains(complaintOfCheck(withGap("1/x")), "(0, 0)"));
  SceneText scene;
  scene.base = R"(<Parameter name="Type" type="string" value="Contact"/>
    <ParameterList name="Friction">
      <Parameter name="Law" type="string" value="Coulomb"/>
      <Parameter name="Coefficient" type="string" value="0.5 - x"/></ParameterList>)";
  TEST_ASSERT(contains(complaintOfCheck(scene), base + "Friction->Coefficient"));
}

TEUCHOS_UNIT_TEST(BadScenes, checkLooksWhereARunIntegratesLoads) {
  const auto withTraction = [](const std::string& traction) {
    SceneText scene;
    scene.rigid = R"(<Parameter name="Fix" type='Array(string)' value="{X, Rotation}"/>)";
    scene.top = R"(<Parameter name="Type" type="string" value="Neumann"/>
        <Parameter name="Traction Y" type="string" value=")" +
                traction + "\"/>";
    return scene;
  };
  TEST_ASSERT(
      contains(complaintOfCheck(withTraction("-1/(x &gt; 0.005)")), "is -inf at"));
  TEST_EQUALITY(complaintOfCheck(withTraction("-1/(x &gt; 0.003)")), "");
}

TEUCHOS_UNIT_TEST(BadScenes, interiorPointsLieInside) {
  SceneText scene;
  scene.rest = R"(<ParameterList name="Output"><Parameter name="Interior Points"
    type='TwoDArray(double)' value="2x2:{1, 0.5, 2, 0.5}"/></ParameterList>)";
  TEST_COMPLAINT(scene.xml(), "Output->Interior Points", "1", "(2, 0.5)");
}

}  // namespace epafi
