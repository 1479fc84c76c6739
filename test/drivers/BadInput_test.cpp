#include "drivers/commands/CommandTable.hpp"
#include "drivers/commands/Commands.hpp"
#include "test/drivers/SceneText.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cctype>

// Every kind of bad input ends with an InputError that names the file, the path A->B->Key
// and what is allowed; complaintOf() checks the file, the tests the path and the names and
// numbers, in whatever sentence.

namespace epafi {

namespace {

using test::complaintOf;
using test::contains;
using test::SceneText;

const std::string body = "Bodies->block->";
const std::string base = body + "Boundary Conditions->base->";

/// Does the complaint about a scene name the place, a path behind what is common to all,
/// and the words?
#define TEST_COMPLAINT(text, place, ...)                                  \
  {                                                                       \
    const std::string complaint = complaintOf(text);                      \
    out << complaint << "\n";                                             \
    TEST_ASSERT(isAt(complaint, place));                                  \
    for (const std::string& word : std::vector<std::string>{__VA_ARGS__}) \
      TEST_ASSERT(contains(complaint, word));                             \
  }

/// A path ends where no letter follows: 'Degree' is not at 'Degre'.
bool isAt(const std::string& complaint, const std::string& place) {
  const std::size_t at = complaint.find(place);
  const std::size_t end = at + place.size();
  return at != std::string::npos && !complaint.empty() &&
         (end == complaint.size() ||
          std::isalnum(static_cast<unsigned char>(complaint[end])) == 0);
}

std::string real(const std::string& key, const std::string& value) {
  return "<Parameter name=\"" + key + R"(" type="double" value=")" + value + "\"/>";
}

SceneText withYoung(const std::string& value) {
  SceneText scene;
  scene.material = real("Young's Modulus", value) + real("Poisson's Ratio", "0.3");
  return scene;
}

SceneText withDiscretization(const std::string& content) {
  SceneText scene;
  scene.discretization += content;
  return scene;
}

SceneText withGap(const std::string& gap) {
  SceneText scene;
  scene.base =
      R"(<Parameter name="Type" type="string" value="Contact"/>
         <Parameter name="Gap" type="string" value=")" +
      gap + "\"/>";
  return scene;
}

SceneText withVertices(const std::string& table, const std::string& edges) {
  SceneText scene;
  scene.geometry = R"(<Parameter name="Vertices" type='TwoDArray(double)' value =
      ")" + table + R"("/><Parameter name="Edges" type='Array(string)' value =
          ")" + edges +
                   "\"/>";
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

TEUCHOS_UNIT_TEST(BadInput, theSceneThatTheTestsSpoilIsValid) {
  TEST_EQUALITY(complaintOf(SceneText().xml()), "");
}

TEUCHOS_UNIT_TEST(BadInput, anUnknownKeyNamesTheNearestOne) {
  TEST_COMPLAINT(
      withDiscretization(R"(<Parameter name="Degre" type="int" value="2"/>)").xml(),
      "Discretization->Degre", "'Degree'");
  SceneText scene;
  scene.rest = R"(<ParameterList name="Adaptivty"/>)";
  TEST_COMPLAINT(scene.xml(), "Adaptivty", "'Adaptivity'");
  scene.rest = R"(<ParameterList name="Solver"><ParameterList name="Linear">
    <Parameter name="Methd" type="string" value="Dense"/></ParameterList></ParameterList>)";
  TEST_COMPLAINT(scene.xml(), "Solver->Linear->Methd", "'Method'");
}

TEUCHOS_UNIT_TEST(BadInput, aKeyOfAnotherTypeOfConditionSaysWhereItBelongs) {
  SceneText scene;
  scene.top += R"(<Parameter name="Traction X" type="string" value="1"/>)";
  TEST_COMPLAINT(scene.xml(), "Boundary Conditions->top->Traction X", "'Neumann'",
                 "'Dirichlet'");
}

TEUCHOS_UNIT_TEST(BadInput, aWrongTypeSaysWhatIsWanted) {
  TEST_COMPLAINT(
      withDiscretization(R"(<Parameter name="Degree" type="double" value="2.0"/>)").xml(),
      "Discretization->Degree", "double", "int");
  TEST_COMPLAINT(withDiscretization(R"(<ParameterList name="Degree"/>)").xml(),
                 "Discretization->Degree", "sublist", "int");
  SceneText scene;
  scene.rest = R"(<Parameter name="Solver" type="string" value="Newton"/>)";
  TEST_COMPLAINT(scene.xml(), "Solver", "'Newton'", "sublist");
  scene.rest = R"(<ParameterList name="Output">
                    <Parameter name="Fields" type="int" value="1"/></ParameterList>)";
  TEST_COMPLAINT(scene.xml(), "Output->Fields", "int", "true");
}

TEUCHOS_UNIT_TEST(BadInput, aValueOutOfRangeSaysWhatIsAllowed) {
  TEST_COMPLAINT(withYoung("0").xml(), body + "Material->Young's Modulus", "> 0");
  TEST_COMPLAINT(
      withDiscretization(R"(<Parameter name="Degree" type="int" value="26"/>)").xml(),
      "Discretization->Degree", "26", "1", "25");
  SceneText scene;
  scene.discretization =
      R"(<Parameter name="Elements per Edge" type='Array(int)' value="{4, 2, 0, 2}"/>)";
  TEST_COMPLAINT(scene.xml(), "Discretization->Elements per Edge", "0", ">= 1");
  TEST_COMPLAINT(withDiscretization(
                     R"(<Parameter name="Multiplier" type="string" value="Bernstien"/>)")
                     .xml(),
                 "Discretization->Multiplier", "'Bernstien'", "'Bernstein'");
  for (const char* nu : {"0.5", "-1", "0.7"}) {
    SceneText soft = withDiscretization(
        R"(<ParameterList name="Stabilization"><Parameter name="Form" type="string"
             value="Projected"/></ParameterList>)");
    soft.material = real("Young's Modulus", "1") + real("Poisson's Ratio", nu);
    TEST_COMPLAINT(soft.xml(), "Material->Poisson's Ratio",
                   nu == std::string("0.5") ? "Density" : nu);
  }
}

TEUCHOS_UNIT_TEST(BadInput, lettersHexDExponentsAndOverflowAreNoNumbers) {
  for (const char* text : {"abc", "1,5", "0x10", "1d-3", "1.0.0", "1e", "", "nan", "inf",
                           "-inf", "1 2", "--1", "1e999", "1e-400"})
    TEST_COMPLAINT(withYoung(text).xml(), body + "Material->Young's Modulus",
                   "'" + std::string(text));
  for (const char* text : {"3.7", "99999999999", "0x2", "two", "1e1", "+", "+-2"})
    TEST_COMPLAINT(withDiscretization("<Parameter name=\"Degree\" type=\"int\" value=\"" +
                                      std::string(text) + "\"/>")
                       .xml(),
                   "Discretization->Degree", "'" + std::string(text));
  for (const char* text : {"2", "yes", "True", ""}) {
    SceneText scene;
    scene.rest =
        "<ParameterList name=\"Output\"><Parameter name=\"Fields\" type=\"bool\" "
        "value=\"" +
        std::string(text) + "\"/></ParameterList>";
    TEST_COMPLAINT(scene.xml(), "Output->Fields", "'" + std::string(text));
  }
}

TEUCHOS_UNIT_TEST(BadInput, arraysAndTablesAreReadEntryByEntry) {
  for (const char* text :
       {"{4, x, 4, 2}", "{4, 2.5, 4, 2}", "{4, , 4, 2}", "{4, 2, 4, 2,}", "4, 2, 4, 2",
        "{4, 2, 4, 2", "{{4, 2, 4, 2}}", "{4 2 4 2}"}) {
    SceneText scene;
    scene.discretization =
        "<Parameter name=\"Elements per Edge\" type=\"Array(int)\" value=\"" +
        std::string(text) + "\"/>";
    TEST_COMPLAINT(scene.xml(), "Discretization->Elements per Edge");
  }
  const std::string edges = "{base, right, top, left}";
  for (const char* text : {"4x2:{0,0, 2,0, 2,1, 0}", "4x2:{0,0, 2,0, 2,1, 0,1, 3}",
                           "4x2:{0,0, 2,0, 2,l, 0,1}", "{0,0, 2,0, 2,1, 0,1}", "4x:{0}",
                           "x2:{0}", "4x2{0,0, 2,0, 2,1, 0,1}", "-4x2:{0}"})
    TEST_COMPLAINT(withVertices(text, edges).xml(), body + "Geometry->Vertices");
  TEST_COMPLAINT(withVertices("2x4:{0,0, 2,0, 2,1, 0,1}", edges).xml(),
                 "Geometry->Vertices", "2", "4");
}

TEUCHOS_UNIT_TEST(BadInput, duplicatesAndMissingAttributesAreRefused) {
  const std::string elements =
      R"(<Parameter name="Elements per Edge" type='Array(int)' value="{4, 2, 4, 2}"/>)";
  TEST_COMPLAINT(withDiscretization(elements).xml(), "Discretization->Elements per Edge",
                 "twice");
  SceneText scene;
  scene.rest =
      R"(<ParameterList name="Solver"/><Parameter name="Solver" type="int" value="1"/>)";
  TEST_COMPLAINT(scene.xml(), "Solver", "twice");
  scene.rest = R"(<ParameterList/>)";
  TEST_COMPLAINT(scene.xml(), "ParameterList", "name");
  TEST_COMPLAINT(withDiscretization(R"(<Parameter type="int" value="1"/>)").xml(),
                 "Discretization", "Parameter", "name");
  TEST_COMPLAINT(withDiscretization(R"(<Parameter name="Degree" value="1"/>)").xml(),
                 "Discretization->Degree", "type");
  TEST_COMPLAINT(withDiscretization(R"(<Parameter name="Degree" type="int"/>)").xml(),
                 "Discretization->Degree", "value");
  TEST_COMPLAINT(
      withDiscretization(R"(<Parameter name="Degree" type="itn" value="1"/>)").xml(),
      "Discretization->Degree", "'itn'", "'int'");
  TEST_COMPLAINT(
      withDiscretization("<Paramter name=\"Degree\" type=\"int\" value=\"1\"/>").xml(),
      "Discretization", "<Paramter>", "'Parameter'");
  TEST_COMPLAINT(withDiscretization("Degree 2").xml(), "Discretization", "'Degree 2'");
}

TEUCHOS_UNIT_TEST(BadInput, aFileThatIsNoSceneSaysSo) {
  TEST_COMPLAINT("", "empty");
  TEST_COMPLAINT(" \n ", "empty");
  TEST_COMPLAINT("hello", "XML");
  TEST_COMPLAINT("<Scene name='x'/>", "<Scene>");
  TEST_COMPLAINT("<ParameterList name='x'/>", "Bodies", "missing");
  TEST_ASSERT(contains(complaintOf("", "scene.yaml"), "empty"));
  TEST_ASSERT(contains(complaintOf("a: 1\nb: 2\n", "scene.yaml"), "YAML"));
  TEST_ASSERT(contains(complaintOf("a:\n  b: [1, 2\n", "scene.yaml"), "YAML"));
  TEST_ASSERT(
      contains(complaintOf("a:\n  b:\n    - - 1.0\n", "scene.yaml"), "in brackets"));
  const std::string twice = complaintOf("a:\n  Bodies: 1\n  Bodies: 2\n", "scene.yaml");
  out << twice << "\n";
  TEST_ASSERT(contains(twice, "Bodies") && !contains(twice, "packages"));
  for (const char* file : {"/no/such/scene.xml", "/"})
    try {
      drivers::readScene(file);
      TEST_ASSERT(false);
    } catch (const bem::InputError& error) {
      TEST_ASSERT(contains(error.what(), std::string(file) + ": "));
    }
}

TEUCHOS_UNIT_TEST(BadInput, aSceneCutAtAnyByteIsRefused) {
  const std::string whole = SceneText().xml();
  const std::size_t end = whole.find_last_not_of('\n');
  for (std::size_t length = 0; length <= end; ++length)
    TEST_ASSERT(!complaintOf(whole.substr(0, length)).empty());
}

TEUCHOS_UNIT_TEST(BadInput, aSecondBodyIsWholeToo) {
  SceneText scene;
  scene.bodies = R"(<ParameterList name="second"/>)";
  TEST_COMPLAINT(scene.xml(), "Bodies->second->Material", "missing");
}

TEUCHOS_UNIT_TEST(BadInput, whatABodyNeedsIsMissed) {
  SceneText scene;
  scene.material = real("Young's Modulus", "1");
  TEST_COMPLAINT(scene.xml(), body + "Material->Poisson's Ratio", "missing");
  scene = SceneText();
  scene.geometry = R"(<Parameter name="Edges" type='Array(string)' value="{base}"/>)";
  TEST_COMPLAINT(scene.xml(), body + "Geometry->Vertices", "missing");
  scene = SceneText();
  scene.discretization = "";
  TEST_COMPLAINT(scene.xml(), "Discretization->Elements per Edge", "missing", "4");
  scene = SceneText();
  scene.base = R"(<Parameter name="Gap" type="string" value="0"/>)";
  TEST_COMPLAINT(scene.xml(), base + "Type", "missing");
}

TEUCHOS_UNIT_TEST(BadInput, openCrossingAndClockwisePolygonsAreRefused) {
  TEST_COMPLAINT(withVertices("4x2:{0,0, 2,0, 2,1, 0,1}", "{base, right, top}").xml(),
                 body + "Geometry->Edges", "4", "3");
  TEST_COMPLAINT(
      withVertices("4x2:{0,0, 2,1, 2,0, 0,1}", "{base, right, top, left}").xml(),
      body + "Geometry", "outer polygon", "crosses");
  TEST_COMPLAINT(
      withVertices("4x2:{0,0, 0,1, 2,1, 2,0}", "{base, right, top, left}").xml(),
      body + "Geometry", "outer polygon", "clockwise");
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

TEUCHOS_UNIT_TEST(BadInput, arcsFitTogether) {
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

TEUCHOS_UNIT_TEST(BadInput, unnamedEdgesAndConditionsForNoEdgeAreRefused) {
  TEST_COMPLAINT(withVertices("4x2:{0,0, 2,0, 2,1, 0,1}", "{base, , top, left}").xml(),
                 body + "Geometry->Edges", "1", "''");
  SceneText scene;
  scene.conditions = R"(<ParameterList name="lefft">
    <Parameter name="Type" type="string" value="Neumann"/></ParameterList>)";
  TEST_COMPLAINT(scene.xml(), body + "Boundary Conditions->lefft", "'left'");
}

/// A scene with a History of this content.
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

TEUCHOS_UNIT_TEST(BadInput, aPathGoesForward) {
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
  TEST_COMPLAINT(withHistory(times("{1}") + real("Step", "1")), "History->Step", "Steps");
  SceneText scene;
  scene.rest = "<ParameterList name=\"History\">" + times("{1}") +
               "</ParameterList><ParameterList name=\"Solver\"><Parameter name=\"Load "
               "Steps\" type=\"int\" value=\"4\"/></ParameterList>";
  TEST_COMPLAINT(scene.xml(), "Solver->Load Steps", "4", "History");
}

TEUCHOS_UNIT_TEST(BadInput, theMeshFitsTheOutline) {
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

TEUCHOS_UNIT_TEST(BadInput, conditionsAreComplete) {
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

TEUCHOS_UNIT_TEST(BadInput, expressionsAreOneNumberAndAssignNothing) {
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

TEUCHOS_UNIT_TEST(BadInput, checkFindsThePointWhereAnExpressionIsNotFinite) {
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

// 0.0040 from the corner is the last of the points where a run integrates the load on an
// element of length 0.5; nothing looks at the corner itself.
TEUCHOS_UNIT_TEST(BadInput, checkLooksWhereARunIntegratesLoads) {
  const auto withTraction = [](const std::string& traction) {
    SceneText scene;
    scene.rigid = R"(<Parameter name="Fix" type='Array(string)' value="{X, Rotation}"/>)";
    scene.top = R"(<Parameter name="Type" type="string" value="Neumann"/>
        <Parameter name="Traction Y" type="string" value=")" +
                traction + "\"/>";
    return scene;
  };
  TEST_ASSERT(contains(complaintOfCheck(withTraction("1/(x &gt; 0.005)")), "is inf at"));
  TEST_EQUALITY(complaintOfCheck(withTraction("1/(x &gt; 0.003)")), "");
}

TEUCHOS_UNIT_TEST(BadInput, interiorPointsLieInside) {
  SceneText scene;
  scene.rest = R"(<ParameterList name="Output"><Parameter name="Interior Points"
    type='TwoDArray(double)' value="2x2:{1, 0.5, 2, 0.5}"/></ParameterList>)";
  TEST_COMPLAINT(scene.xml(), "Output->Interior Points", "1", "(2, 0.5)");
}

TEUCHOS_UNIT_TEST(BadInput, overridesAreCheckedLikeTheScene) {
  const std::string xml = SceneText().xml();
  const auto complaint = [&xml](const std::string& assignment) {
    return complaintOf(xml, "scene.xml", {assignment});
  };
  TEST_ASSERT(contains(complaint("Discretization->Degre=2"), "'Degree'"));
  TEST_ASSERT(contains(complaint("Discretization->Degree=2.5"),
                       "--set Discretization->Degree: '2.5'"));
  TEST_ASSERT(contains(complaint("Discretization->Degree"), "A->B->Key=value"));
  TEST_ASSERT(contains(complaint("Discretization=2"), "sublist"));
  TEST_ASSERT(contains(complaint("Solver->NOX->Anything=2"), "Solver->NOX->Anything"));
  TEST_ASSERT(contains(complaint("Discretization->Elements per Edge={4, 4}"),
                       "Elements per Edge"));
  TEST_ASSERT(contains(complaint("Bodies->blok->Material->Young's Modulus=2"),
                       "Bodies->blok->Geometry: missing"));
}

/// Behind a scene that is solved with, so that nothing but the argument can be refused.
TEUCHOS_UNIT_TEST(BadInput, commandsRefuseArgumentsTheyDoNotKnow) {
  const test::TemporaryFile file("scene.xml", SceneText().xml());
  const auto complaint = [](const std::string& name,
                            const std::vector<std::string>& arguments) {
    std::ostringstream sink;
    try {
      for (const drivers::Command& command : drivers::commands())
        if (command.name == name) {
          const drivers::Given given = drivers::parseArguments(command, arguments);
          if (name == "check")
            drivers::checkCommand(given, sink);
          else
            drivers::parametersCommand(given, sink);
        }
    } catch (const bem::InputError& error) {
      return std::string(error.what());
    }
    return std::string(sink.str().empty() ? "said nothing" : "");
  };
  const std::string check = "check";
  TEST_EQUALITY(complaint(check, {file.path()}), "");
  TEST_INEQUALITY(complaint(check, {}), "");
  TEST_ASSERT(contains(complaint(check, {file.path(), "b.xml"}), "'b.xml'"));
  TEST_ASSERT(contains(complaint(check, {file.path(), "--plot", "b.png"}), "--plot"));
  TEST_ASSERT(contains(complaint(check, {file.path(), "--set"}), "--set"));
  const std::string list = "parameters";
  TEST_EQUALITY(complaint(list, {"--format", "xml"}), "");
  TEST_ASSERT(contains(complaint(list, {"--format"}), "--format"));
  TEST_ASSERT(contains(complaint(list, {"--format", "json"}), "json"));
}

}  // namespace epafi
