#include "drivers/commands/Commands.hpp"
#include "drivers/scene/Expression.hpp"
#include "drivers/scene/SceneFile.hpp"
#include "test/drivers/SceneText.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <thread>

namespace epafi {

namespace {

using namespace test;

const char* const yaml = R"(A test:
  Bodies:
    block:
      Material: {Young's Modulus: 200, Poisson's Ratio: 0.25}
      Geometry:
        Vertices: [[0, 0], [2, 0], [2, 1], [0, 1]]
        Edges: [base, right, top, left]
      Boundary Conditions:
        base:
          Type: Contact
          Gap: '0.1*x^2'
          Friction: {Law: Coulomb, Coefficient: 0.3}
        top:
          Type: Dirichlet
          Displacement Y: -0.01
      Rigid Motions:
        Fix: [X]
  Discretization:
    Elements per Edge: [4, 2, 4, 2]
)";

/// The same in other forms that YAML has: anchors, merged lists, arrays over lines and in blocks,
/// colons and signs within words, a text in quotes.
const char* const otherYaml = R"(--- # one document
A test:
  Bodies:
    block:
      Material:
        <<: &steel
          Young's Modulus: 200
          Poisson's Ratio: 0.3
        Poisson's Ratio: 0.25
      Geometry:
        Vertices:
          - [0, 0]
          - [2,
             0]
          - - 2
            - 1
          - [0, 1]
        Edges: [base, "right",
                top,
                left]
      Boundary Conditions:
        base:
          Type: Contact
          Gap: 0.1*x^2
          Friction: {Law: Coulomb, Coefficient: 0.3}
        top: &top
          Type: Dirichlet
          Displacement Y: -0.01
      Rigid Motions:
        Fix:
        - X
  Discretization:
    Elements per Edge: [4, 2, 4, 2]
...
)";

drivers::Scene readYaml(const std::string& text) {
  const test::TemporaryFile file("scene.yaml", text);
  return drivers::readScene(file.path());
}

/// \pre a occurs in the text.
std::string with(std::string text, const std::string& a, const std::string& b) {
  return text.replace(text.find(a), a.size(), b);
}

}  // namespace

TEUCHOS_UNIT_TEST(Scene, saysWhatTheFileSays) {
  const drivers::Scene scene = read(SceneText());
  TEST_EQUALITY(scene.title, "A test");
  TEST_EQUALITY(scene.bodies[0].name, "block");
  TEST_EQUALITY(scene.bodies[0].material.youngsModulus, 200);
  TEST_EQUALITY(scene.bodies[0].material.poissonsRatio, 0.25);
  TEST_ASSERT(!scene.bodies[0].material.planeStress);
  TEST_EQUALITY(scene.bodies[0].outline->edges().size(), 4u);
  TEST_ASSERT((scene.bodies[0].elementsPerEdge == std::vector<int>{4, 2, 4, 2}));
  const contact::Conditions::Contact& base =
      scene.bodies[0].conditions.contact.at("base");
  TEST_EQUALITY(base.friction.at({0.5, 0}, 1).bound(2), 0.6);
  TEST_FLOATING_EQUALITY(base.gap({2, 0}), 0.4, 1e-15);
  const contact::Conditions::Dirichlet& top =
      scene.bodies[0].conditions.dirichlet.at("top");
  TEST_ASSERT(!top.x);
  TEST_EQUALITY(top.y({0, 1}), -0.01);
  TEST_ASSERT(scene.bodies[0].conditions.neumann.empty());
  TEST_ASSERT(scene.bodies[0].conditions.fix.x && !scene.bodies[0].conditions.fix.y);
}

TEUCHOS_UNIT_TEST(Scene, defaultsAreThoseOfTheOptions) {
  const drivers::Scene scene = read(SceneText());
  const drivers::SolverOptions solver;
  TEST_EQUALITY(scene.solver.coulomb.iteration, solver.coulomb.iteration);
  TEST_EQUALITY(scene.solver.contact.tolerance, solver.contact.tolerance);
  TEST_EQUALITY(scene.solver.contact.maximumIterations, solver.contact.maximumIterations);
  TEST_EQUALITY(scene.solver.coulomb.tolerance, solver.coulomb.tolerance);
  TEST_EQUALITY(scene.solver.coulomb.maximumIterations, solver.coulomb.maximumIterations);
  TEST_ASSERT(scene.solver.nox == nullptr);
  const contact::Stabilization stabilization;
  TEST_ASSERT(scene.stabilization.form == stabilization.form);
  TEST_ASSERT(scene.stabilization.scaling == stabilization.scaling);
  TEST_ASSERT(!scene.stabilization.gamma0);
  TEST_EQUALITY(scene.used->sublist("Discretization")
                    .sublist("Stabilization")
                    .get<double>("Gamma0"),
                stabilization.firstGamma0());
  TEST_EQUALITY(scene.bodies[0].degree, 1);
  TEST_EQUALITY(scene.multiplier, "Gauss-Legendre-Lagrange");
  TEST_EQUALITY(scene.adaptivity.strategy.name, "None");
  TEST_EQUALITY(scene.adaptivity.limits.levels, 1);
  TEST_EQUALITY(scene.output.contactSamples, 8);
  TEST_ASSERT(scene.output.fields);
}

/// What reading a scene finds once holds on all of its path.
TEUCHOS_UNIT_TEST(Scene, pinsIncompressibleBodiesAtAllTimes) {
  SceneText text;
  text.material = elastic("200", "0.5");
  text.base = parameter("Type", "Neumann") + parameter("Traction Y", "t");
  text.rigid = "";
  text.discretization += list("Stabilization", parameter("Form", "Density"));
  const drivers::Scene once = read(text);
  TEST_ASSERT((once.bodies[0].conditions.pins == std::vector<int>{1}));
  const drivers::Scene path = read(text, {"History->Times={1, 2}"});
  TEST_ASSERT(path.bodies[0].conditions.pins == once.bodies[0].conditions.pins);
  for (const double t : {0.0, 0.5, 2.0})
    TEST_ASSERT(path.conditionsAt(t)[0].pins == once.bodies[0].conditions.pins);
}

TEUCHOS_UNIT_TEST(Scene, isTheSameFromXmlAndYaml) {
  const drivers::Scene fromYaml = readYaml(yaml);
  const drivers::Scene fromXml = read(SceneText());
  TEST_EQUALITY(drivers::usedXml(fromYaml), drivers::usedXml(fromXml));
  TEST_EQUALITY(fromYaml.bodies[0].conditions.contact.at("base").gap({2, 0}),
                fromXml.bodies[0].conditions.contact.at("base").gap({2, 0}));
  TEST_EQUALITY(drivers::usedXml(readYaml(otherYaml)), drivers::usedXml(fromXml));
}

TEUCHOS_UNIT_TEST(Scene, yamlTakesExpressionsAndArraysWithoutQuotes) {
  const auto gapAt = [](const std::string& gap, const bem::SurfacePoint& x) {
    return readYaml(with(yaml, "'0.1*x^2'", gap))
        .bodies[0]
        .conditions.contact.at("base")
        .gap(x);
  };
  TEST_EQUALITY(gapAt("0.1*(x > 1)", {2, 0}), 0.1);
  TEST_EQUALITY(gapAt("\"x > 1 ? 0.1 : 0\"", {2, 0}), 0.1);
  TEST_EQUALITY(gapAt("max(0.1, -x)", {2, 0}), 0.1);
  const auto printed = [](const std::string& output) {
    const std::string used = drivers::usedXml(readYaml(yaml + output));
    return used.substr(used.find("Interior Points"), 70);
  };
  TEST_EQUALITY(
      printed("  Output: {Interior Points: [[1, 0.5], [1, 1e-1]]}\n"),
      printed("  Output:\n    Interior Points:\n    - [1, 0.5]\n    - [1, .1]\n"));
}

/// Wherever a number is wanted, an expression in constants may stand; used.xml keeps it, so that
/// it repeats the run and still follows its constants.
TEUCHOS_UNIT_TEST(Scene, numbersAreExpressionsInConstants) {
  std::string text = with(yaml, "[2, 0], [2, 1]", "[L, 0], [2*H, \"max(H, 0)\"]");
  text = with(text, "Modulus: 200", "Modulus: 100*L");
  text = with(text, "[4, 2, 4, 2]", "[2*L, L, 2*L, L]") + "  Constants: {L: 2, H: L/2}\n";
  const drivers::Scene scene = readYaml(text);
  const drivers::Scene plain = readYaml(yaml);
  TEST_ASSERT(scene.bodies[0].outline->diameter() == plain.bodies[0].outline->diameter());
  TEST_EQUALITY(scene.bodies[0].material.youngsModulus, 200);
  TEST_ASSERT(scene.bodies[0].elementsPerEdge == plain.bodies[0].elementsPerEdge);
  const test::TemporaryFile used("used.xml", drivers::usedXml(scene));
  TEST_EQUALITY(drivers::usedXml(drivers::readScene(used.path())),
                drivers::usedXml(scene));
  const drivers::Scene set = drivers::readScene(
      used.path(), {"Bodies->block->Material->Young's Modulus=25*L",
                    "Discretization->Elements per Edge={L, 1, L*L, 1}"});
  TEST_EQUALITY(set.bodies[0].material.youngsModulus, 50);
  TEST_EQUALITY(set.bodies[0].elementsPerEdge[2], 4);
  const drivers::Scene longer = drivers::readScene(used.path(), {"Constants->L=4"});
  TEST_EQUALITY(longer.bodies[0].material.youngsModulus, 400);
  TEST_ASSERT(longer.bodies[0].outline->diameter() > scene.bodies[0].outline->diameter());
}

TEUCHOS_UNIT_TEST(Scene, usedXmlGivesTheSameSceneBitByBit) {
  SceneText text;
  text.material = elastic("0.30000000000000004", "0.33333333333333331");
  text.base = parameter("Type", "Contact") +
              parameter("Gap", "x &lt; 1 ? 0 : x - 1 &amp;&amp;\n 1");
  const std::string search =
      parameter("Method", "Full Step") + real("Step", "0.1000000000000000055") +
      entry("Steps", "Array(double)", "{0.1, 1e-300, 3.3333333333333335}");
  text.rest =
      list("Solver", list("NOX", list("Line Search", search))) +
      list("Output", entry("Interior Points", "TwoDArray(double)",
                           "2x2:{0.1, 0.70000000000000007, 0.033333333333333347, 0.5}"));
  const std::vector<std::string> overrides = {
      "Discretization->Degree=3", "Discretization->Stabilization->Gamma0=7.1e-3"};
  const drivers::Scene first = read(text, overrides);
  const std::string used = drivers::usedXml(first);
  const test::TemporaryFile file("used.xml", used);
  const drivers::Scene second = drivers::readScene(file.path());
  TEST_EQUALITY(drivers::usedXml(second), used);
  TEST_ASSERT(*first.used == [&] {
    Teuchos::ParameterList list(*second.used);
    list.remove("Versions");
    return list;
  }());
  TEST_EQUALITY(second.title, "A test");
  TEST_EQUALITY(second.bodies[0].degree, 3);
  TEST_EQUALITY(second.stabilization.firstGamma0(), 7.1e-3);
  TEST_EQUALITY(second.bodies[0].material.youngsModulus, 0.30000000000000004);
  TEST_EQUALITY(second.output.interiorPoints[1].x, 0.033333333333333347);
  TEST_EQUALITY(second.bodies[0].conditions.contact.at("base").gap({0.5, 0}),
                first.bodies[0].conditions.contact.at("base").gap({0.5, 0}));
}

/// Only what the user wrote can be wrong: used.xml must not turn a default into that.
TEUCHOS_UNIT_TEST(Scene, usedXmlTellsDefaultsFromWhatWasWritten) {
  const std::string used = drivers::usedXml(read(SceneText()));
  TEST_ASSERT(!drivers::sceneOf(used, "used.xml", {}).stabilization.gamma0);
  const std::string standard = R"("Gamma0" type="double" value="0.5" isDefault="true")";
  const auto at = used.find(standard);
  TEST_ASSERT(at != std::string::npos);
  const auto with = [&](const char* entry) {
    std::string text = used;
    text.replace(at, standard.size(), entry);
    return drivers::sceneOf(text, "edited.xml", {}).stabilization.gamma0.value_or(0);
  };
  TEST_EQUALITY(with(R"("Gamma0" type="double" value="0.1")"), 0.1);
  TEST_EQUALITY(with(R"("Gamma0" type="double" value="0.2" isDefault="true")"), 0.2);
}

TEUCHOS_UNIT_TEST(Scene, overridesReadTheDeclaredType) {
  const drivers::Scene scene = read(
      SceneText(), {"Discretization->Elements per Edge={1, 2, 3, 4}",
                    "Bodies->block->Boundary Conditions->base->Gap=x == 1 ? 2 : 3",
                    "Bodies->block->Material->Young's Modulus=7", "Output->Fields=false",
                    "Bodies->block->Geometry->Vertices=4x2:{0,0, 4,0, 4,1, 0,1}",
                    "Adaptivity->Strategy=Uniform h", "Adaptivity->Maximum Levels=4",
                    "Bodies->block->Rigid Motions->Fix={X, Rotation}",
                    "Discretization->Degree=2", "Discretization->Degree=5"});
  TEST_ASSERT((scene.bodies[0].elementsPerEdge == std::vector<int>{1, 2, 3, 4}));
  TEST_EQUALITY(scene.bodies[0].conditions.contact.at("base").gap({1, 0}), 2.0);
  TEST_EQUALITY(scene.bodies[0].conditions.contact.at("base").gap({0, 0}), 3.0);
  TEST_EQUALITY(scene.bodies[0].material.youngsModulus, 7.0);
  TEST_ASSERT(!scene.output.fields);
  TEST_FLOATING_EQUALITY(scene.bodies[0].outline->diameter(), std::sqrt(17.0), 1e-15);
  TEST_EQUALITY(scene.adaptivity.limits.levels, 4);
  TEST_ASSERT(scene.bodies[0].conditions.fix.rotation);
  TEST_EQUALITY(scene.bodies[0].degree, 5);  // the last one counts
}

TEUCHOS_UNIT_TEST(Scene, wholeNumbersAndNumbersStandForDoublesAndExpressions) {
  SceneText text;
  text.material =
      entry("Young's Modulus", "int", "200") + entry("Poisson's Ratio", "int", "0");
  text.base = parameter("Type", "Contact") + real("Gap", "0.1");
  text.top = parameter("Type", "Neumann") + entry("Traction Y", "int", "-3");
  const drivers::Scene scene = read(text);
  TEST_EQUALITY(scene.bodies[0].material.youngsModulus, 200.0);
  TEST_EQUALITY(scene.bodies[0].conditions.contact.at("base").gap({7, 7}), 0.1);
  TEST_EQUALITY(scene.bodies[0].conditions.neumann.at("top").y({7, 7}), -3.0);
  TEST_ASSERT(!scene.bodies[0].conditions.contact.at("base").friction);
}

TEUCHOS_UNIT_TEST(Scene, meshSizeGivesTheFewestElementsThatAreNotLarger) {
  for (const auto& [size, wanted] :
       std::vector<std::pair<double, std::vector<int>>>{{0.25, {8, 4, 8, 4}},
                                                        {0.3, {7, 4, 7, 4}},
                                                        {0.1, {20, 10, 20, 10}},
                                                        {9, {1, 1, 1, 1}}}) {
    SceneText text;
    text.discretization = real("Mesh Size", std::to_string(size));
    TEST_ASSERT(read(text).bodies[0].elementsPerEdge == wanted);
  }
}

TEUCHOS_UNIT_TEST(Scene, elementsOfAHoleFollowItsEdges) {
  SceneText text;
  text.geometry +=
      entry("Hole 1 Vertices", "TwoDArray(double)", "3x2:{0.5,0.2, 1.5,0.2, 1,0.8}") +
      entry("Hole 1 Edges", "Array(string)", "{h0, h1, h2}");
  text.discretization += entry("Hole 1 Elements per Edge", "Array(int)", "{10, 11, 12}");
  const drivers::Scene scene = read(text);
  for (std::size_t e = 4; e < 7; ++e) {
    const std::string& name = scene.bodies[0].outline->edges()[e].boundary;
    TEST_EQUALITY(scene.bodies[0].elementsPerEdge[e], 10 + (name[1] - '0'));
  }
}

TEUCHOS_UNIT_TEST(Scene, expressionsKnowWhatTheManualLists) {
  const auto value = [](const std::string& text) {
    return drivers::makeExpression(text, {"f", "p"})({0.3, -0.7});
  };
  TEST_EQUALITY(value("pi"), std::acos(-1.0));
  TEST_EQUALITY(value("x < y ? 1 : 2"), 2.0);
  TEST_EQUALITY(value("x > y && x != y || 0"), 1.0);
  TEST_EQUALITY(value("x >= y"), 1.0);
  TEST_EQUALITY(value("sign(y)"), -1.0);
  TEST_EQUALITY(value("log(exp(2)) + ln(1)"), 2.0);
  TEST_FLOATING_EQUALITY(value("atan2(y, x)"), std::atan2(-0.7, 0.3), 1e-15);
  TEST_EQUALITY(value("min(x, y) + max(x, y) + abs(y)"), -0.7 + 0.3 + 0.7);
}

TEUCHOS_UNIT_TEST(Scene, expressionsMayBeEvaluatedByManyThreads) {
  const bem::Function f = drivers::makeExpression("x + 1000*y", {"f", "p"});
  std::vector<int> wrong(4, 0);
  std::vector<std::thread> threads;
  threads.reserve(wrong.size());
  for (int k = 0; k < 4; ++k)
    threads.emplace_back([&, k] {
      for (int i = 0; i < 20000; ++i) {
        const double x = i;
        const double y = k;
        wrong[k] += f({x, y}) != x + 1000 * y;
      }
    });
  for (std::thread& thread : threads)
    thread.join();
  for (int count : wrong)
    TEST_EQUALITY(count, 0);
}

TEUCHOS_UNIT_TEST(Schema, everyDefaultIsValidAndEveryListStandsBeforeItsKeys) {
  for (const drivers::Parameter& row : drivers::parameters()) {
    TEST_ASSERT(!row.meaning.empty());
    TEST_ASSERT(!(row.required && !row.defaultValue.empty()));
    if (!row.allowed.empty() && !row.defaultValue.empty())
      TEST_ASSERT(std::find(row.allowed.begin(), row.allowed.end(), row.defaultValue) !=
                  row.allowed.end());
    if (row.kind == drivers::Kind::Real && !row.defaultValue.empty())
      TEST_ASSERT(row.interval.contains(std::stod(row.defaultValue)));
    if (!row.parent().empty())
      TEST_EQUALITY(bem::declared(drivers::parameters(), row.parent()).path,
                    row.parent());
  }
}

TEUCHOS_UNIT_TEST(Schema, everyParameterIsPrinted) {
  std::ostringstream text;
  drivers::parametersCommand({}, text);
  for (const drivers::Parameter& row : drivers::parameters())
    TEST_ASSERT(test::contains(text.str(), row.path));
}

// With friction the image would slide the other way, also at steps between the times that are listed.
TEUCHOS_UNIT_TEST(Scene, aRollerThatMovesWithFrictionHasNoImage) {
  const auto images = [](const std::string& motion) {
    SceneText text;
    text.rigid = "";
    text.conditions = list(
        "left", parameter("Type", "Dirichlet") + parameter("Displacement X", motion));
    text.rest = list("History", entry("Times", "Array(double)", "{1, 2}") +
                                    entry("Steps", "Array(int)", "{4, 4}"));
    return test::read(text).bodies.front().conditions.images;
  };
  const int corner = 0;  // where the base begins
  TEST_EQUALITY(images("0").count(corner), 1u);
  TEST_EQUALITY(images("0.001*t").count(corner), 0u);
  TEST_EQUALITY(images("0.001*t*(1 - t)*(2 - t)").count(corner), 0u);
}

}  // namespace epafi
