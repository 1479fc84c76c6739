// Texts that are no list of the right keys, types and values.
#include "drivers/commands/Command.hpp"
#include "drivers/commands/Commands.hpp"
#include "test/drivers/Complaints.hpp"

#include <Teuchos_UnitTestHarness.hpp>

namespace epafi {

namespace {

using namespace test;

const std::string body = "Bodies->block->";
const std::string base = body + "Boundary Conditions->base->";

SceneText withYoung(const std::string& value) {
  SceneText scene;
  scene.material = elastic(value, "0.3");
  return scene;
}

}  // namespace

TEUCHOS_UNIT_TEST(BadInput, theSceneThatTheTestsSpoilIsValid) {
  TEST_EQUALITY(complaintOf(SceneText().xml()), "");
}

TEUCHOS_UNIT_TEST(BadInput, anUnknownKeyNamesTheNearestOne) {
  TEST_COMPLAINT(withDiscretization(entry("Degre", "int", "2")).xml(),
                 "Discretization->Degre", "'Degree'");
  TEST_COMPLAINT(withRest(R"(<ParameterList name="Adaptivty"/>)").xml(), "Adaptivty",
                 "'Adaptivity'");
  const std::string method = list("Linear", parameter("Methd", "Dense"));
  TEST_COMPLAINT(withRest(list("Solver", method)).xml(), "Solver->Linear->Methd",
                 "'Method'");
}

TEUCHOS_UNIT_TEST(BadInput, aKeyOfAnotherTypeOfConditionSaysWhereItBelongs) {
  SceneText scene;
  scene.top += parameter("Gap", "1");
  TEST_COMPLAINT(scene.xml(), "Boundary Conditions->top->Gap", "'Contact'",
                 "'Dirichlet'");
}

TEUCHOS_UNIT_TEST(BadInput, aWrongTypeSaysWhatIsWanted) {
  TEST_COMPLAINT(withDiscretization(real("Degree", "2.0")).xml(),
                 "Discretization->Degree", "double", "int");
  TEST_COMPLAINT(withDiscretization(list("Degree", "")).xml(), "Discretization->Degree",
                 "sublist", "int");
  TEST_COMPLAINT(withRest(parameter("Solver", "Newton")).xml(), "Solver", "'Newton'",
                 "a list (ParameterList) with 'Coulomb Iteration'");
  TEST_COMPLAINT(withRest(list("Output", entry("Fields", "int", "1"))).xml(),
                 "Output->Fields", "int", "true");
}

TEUCHOS_UNIT_TEST(BadInput, aValueOutOfRangeSaysWhatIsAllowed) {
  TEST_COMPLAINT(withYoung("0").xml(), body + "Material->Young's Modulus", "> 0");
  TEST_COMPLAINT(withDiscretization(entry("Degree", "int", "26")).xml(),
                 "Discretization->Degree", "26", "1", "25");
  SceneText scene;
  scene.discretization = elements("{4, 2, 0, 2}");
  TEST_COMPLAINT(scene.xml(), "Discretization->Elements per Edge", "0", ">= 1");
  TEST_COMPLAINT(withDiscretization(parameter("Multiplier", "Bernstien")).xml(),
                 "Discretization->Multiplier", "'Bernstien'", "'Bernstein'");
  for (const char* nu : {"0.5", "-1", "0.7"}) {
    SceneText soft =
        withDiscretization(list("Stabilization", parameter("Form", "Projected")));
    soft.material = elastic("1", nu);
    TEST_COMPLAINT(soft.xml(), "Material->Poisson's Ratio",
                   nu == std::string("0.5") ? "Density" : nu);
  }
}

TEUCHOS_UNIT_TEST(BadInput, lettersHexDExponentsAndOverflowAreNoNumbers) {
  for (const char* text : {"abc", "1,5", "0x10", "1d-3", "1.0.0", "1e", "", "nan", "inf",
                           "-inf", "1 2", "--1", "1e999", "1e-400", "1e-320"})
    TEST_COMPLAINT(withYoung(text).xml(), body + "Material->Young's Modulus",
                   "'" + std::string(text));
  for (const char* text : {"3.7", "99999999999", "0x2", "two", "1e1", "+", "+-2"})
    TEST_COMPLAINT(withDiscretization(entry("Degree", "int", text)).xml(),
                   "Discretization->Degree", "'" + std::string(text));
  for (const char* text : {"2", "yes", "True", ""})
    TEST_COMPLAINT(withRest(list("Output", entry("Fields", "bool", text))).xml(),
                   "Output->Fields", "'" + std::string(text));
}

TEUCHOS_UNIT_TEST(BadInput, arraysAndTablesAreReadEntryByEntry) {
  for (const char* text :
       {"{4, x, 4, 2}", "{4, 2.5, 4, 2}", "{4, , 4, 2}", "{4, 2, 4, 2,}", "4, 2, 4, 2",
        "{4, 2, 4, 2", "{{4, 2, 4, 2}}", "{4 2 4 2}"}) {
    SceneText scene;
    scene.discretization = elements(text);
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
  TEST_COMPLAINT(withDiscretization(elements("{4, 2, 4, 2}")).xml(),
                 "Discretization->Elements per Edge", "twice");
  TEST_COMPLAINT(withRest(list("Solver", "") + entry("Solver", "int", "1")).xml(),
                 "Solver", "twice");
  TEST_COMPLAINT(withRest("<ParameterList/>").xml(), "ParameterList", "name");
  TEST_COMPLAINT(withDiscretization(R"(<Parameter type="int" value="1"/>)").xml(),
                 "Discretization", "Parameter", "name");
  TEST_COMPLAINT(withDiscretization(R"(<Parameter name="Degree" value="1"/>)").xml(),
                 "Discretization->Degree", "type");
  TEST_COMPLAINT(withDiscretization(R"(<Parameter name="Degree" type="int"/>)").xml(),
                 "Discretization->Degree", "value");
  TEST_COMPLAINT(withDiscretization(entry("Degree", "itn", "1")).xml(),
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
  for (const auto& [text, word] : std::vector<std::pair<const char*, const char*>>{
           {"", "empty"},
           {"a: 1\nb: 2\n", "YAML"},
           {"a:\n  b: [1, 2\n", "YAML"},
           {"a:\n\tb: 1\n", "not by tabs"},
           {"a:\n  Constants:\n    g: x > 0 ? 1 : 2\n", "line 3"},
           {"a:\n  Constants:\n    g: x > 0 ? 1 : 2\n", "quotes round"},
           {"a:\n  b: &b\n    c: *b\n", "too deep"},
           {"a:\n  b: &b {<<: *b}\n", "too deep"},
           {"a: {}\n---\nb: {}\n", "several documents"},
           {"a:\n  Vertices: [[1, 2], [3]]\n", "entry 1"},
           {"a:\n  B: {Gap: max(x, 0)}\n", "a comma"},
           {"a:\n  B: [max(x, 0), 1]\n", "a comma"},
           {"a:\n  B: [[1, 2], [max(x, 0), 1]]\n", "a comma"},
           {"a:\n  B: [[0, 0], {c: 1}]\n", "entry 1"},
           {"a:\n  B: [[], [1]]\n", "entry 1"},
           {"a:\n  B: [true, false]\n", "true and false"},
           {"a:\n  B: [1, ' ']\n", "entry 1"},
           {"a:\n  '': 1\n", "a key is empty"},
           {"a:\n  B: {C: [0, 1e999]}\n", "B->C (line 2, column 10): entry 1"},
           {",--\na: {}\n", "under one title"},
           {"Bodies: {a: {}}\n", "under one title"}}) {
    out << text << ": ";
    TEST_ASSERT(contains(complaintOf(text, "scene.yaml"), word));
  }
  std::string laughs = "a:\n  b0: &b0 [1, 2]\n";  // three times as many from key to key
  for (int i = 1; i < 30; ++i) {
    const std::string of = "*b" + std::to_string(i - 1);
    laughs += "  b" + std::to_string(i) + ": &b" + std::to_string(i) + " {p: " + of +
              ", q: " + of + ", r: " + of + "}\n";
  }
  TEST_ASSERT(contains(complaintOf(laughs, "scene.yaml"), "anchors"));
  const std::string twice = complaintOf("a:\n  Bodies: 1\n  Bodies: 2\n", "scene.yaml");
  out << twice << "\n";
  TEST_ASSERT(contains(twice, "Bodies") && !contains(twice, "packages"));
  for (const std::string file : {"/no/such/scene.xml", "/"})
    TEST_ASSERT(contains(messageOf([&] { drivers::readScene(file); }), file + ": "));
}

TEUCHOS_UNIT_TEST(BadInput, aSceneCutAtAnyByteIsRefused) {
  const std::string whole = SceneText().xml();
  const std::size_t end = whole.find_last_not_of('\n');
  for (std::size_t length = 0; length <= end; ++length)
    TEST_ASSERT(!complaintOf(whole.substr(0, length)).empty());
}

TEUCHOS_UNIT_TEST(BadInput, listsTooDeepAreRefusedAtOnce) {
  const auto times = [](int count, const std::string& text) {
    std::string all;
    for (int i = 0; i < count; ++i)
      all += text;
    return all;
  };
  for (const int depth : {1001, 20000}) {
    TEST_COMPLAINT(times(depth, "<ParameterList name='<a/>'>"), "1000 deep");
    TEST_COMPLAINT("<ParameterList name='a'>" + times(depth, "<_><!-- </_> -->"),
                   "1000 deep");
    for (const char* open : {"{a: ", "[", "{\"]\": ", "{']': "})
      TEST_ASSERT(
          contains(complaintOf("a: " + times(depth, open), "scene.yaml"), "too deep"));
  }
  std::string yaml;
  for (int column = 0; column < 3000; ++column)
    yaml += std::string(column, ' ') + "a:\n";
  TEST_ASSERT(contains(complaintOf(yaml, "scene.yaml"), "too deep"));
  // what is wide, not deep, is read on
  const std::string wide = times(2000,
                                 "<ParameterList name='a'/><ParameterList name='a'>"
                                 "</ParameterList><!-- <a> -->");
  TEST_COMPLAINT(
      "<?xml version='1.0'?><ParameterList name='x'>" + wide + "</ParameterList>", "a",
      "twice");
  TEST_ASSERT(
      contains(complaintOf("x:\n  Bodies: [" + times(2000, "[1, 2], ") + "[1, 2]]\n",
                           "scene.yaml"),
               "Bodies"));
}

TEUCHOS_UNIT_TEST(BadInput, aZeroByteIsNamedByItsPlace) {
  std::string xml = SceneText().xml();
  xml[50] = '\0';
  TEST_COMPLAINT(xml, "byte 50", "zero");
}

TEUCHOS_UNIT_TEST(BadInput, aSecondBodyIsWholeToo) {
  SceneText scene;
  scene.bodies = list("second", "");
  TEST_COMPLAINT(scene.xml(), "Bodies->second->Material", "missing");
}

TEUCHOS_UNIT_TEST(BadInput, whatABodyNeedsIsMissed) {
  SceneText scene;
  scene.material = real("Young's Modulus", "1");
  TEST_COMPLAINT(scene.xml(), body + "Material->Poisson's Ratio", "missing");
  scene = SceneText();
  scene.geometry = entry("Edges", "Array(string)", "{base}");
  TEST_COMPLAINT(scene.xml(), body + "Geometry->Vertices", "missing");
  scene = SceneText();
  scene.base = parameter("Gap", "0");
  TEST_COMPLAINT(scene.xml(), base + "Type", "missing");
}

TEUCHOS_UNIT_TEST(BadInput, overridesAreCheckedLikeTheScene) {
  const std::string xml = SceneText().xml();
  for (const auto& [assignment, word] : std::vector<std::pair<const char*, const char*>>{
           {"Discretization->Degre=2", "'Degree'"},
           {"Discretization->Degree=2.5", "--set Discretization->Degree: '2.5'"},
           {"Discretization->Degree", "A->B->Key=value"},
           {"Discretization=2", "sublist"},
           {"Discretization->Elements per Edge=[4,4,8,4]", "write {4,4,8,4}"},
           {"Solver={Tolerance=1e-9, Tolerance=1e-8}", "Solver->Tolerance: given twice"},
           {"Discretization->Elements per Edge={4, 4}", "Elements per Edge"},
           {"Bodies->blok->Material->Young's Modulus=2",
            "Bodies->blok->Geometry: missing"},
           {"Bodies->blok->Material->Young's Modulus=2", "did you mean Bodies->block?"}})
    TEST_ASSERT(contains(complaintOf(xml, "scene.xml", {assignment}), word));
}

TEUCHOS_UNIT_TEST(BadInput, commandsRefuseArgumentsTheyDoNotKnow) {
  const test::TemporaryFile file("scene.xml", SceneText().xml());
  const auto complaint = [](const std::string& name,
                            const std::vector<std::string>& arguments) {
    return messageOf([&] {
      std::ostringstream sink;
      for (const drivers::Command& command : drivers::commands())
        if (command.name == name) {
          const drivers::Given given = drivers::parseArguments(command, arguments);
          if (name == "check")
            drivers::checkCommand(given, sink);
          else
            drivers::parametersCommand(given, sink);
        }
      if (sink.str().empty())
        throw bem::InputError("said nothing");
    });
  };
  const std::string check = "check";
  TEST_EQUALITY(complaint(check, {file.path()}), "");
  TEST_INEQUALITY(complaint(check, {}), "");
  TEST_ASSERT(contains(complaint(check, {file.path(), "b.xml"}), "'b.xml'"));
  TEST_ASSERT(
      contains(complaint(check, {file.path(), "--picture", "b.png"}), "--picture"));
  TEST_ASSERT(contains(complaint(check, {file.path(), "--set"}), "--set"));
  const std::string list = "parameters";
  TEST_EQUALITY(complaint(list, {"--format", "text"}), "");
  TEST_ASSERT(contains(complaint(list, {"--format"}), "--format"));
  TEST_ASSERT(contains(complaint(list, {"--format", "json"}), "json"));
}

}  // namespace epafi
