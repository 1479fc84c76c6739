#include "SceneText.hpp"
#include "drivers/run/BodySpaces.hpp"
#include "drivers/scene/Interpolant.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

// What expressions of a scene know: constants, normals, forces.
namespace {

using namespace epafi;
using drivers::Interpolant;
using namespace test;

std::string constants(const std::string& content) { return list("Constants", content); }

std::string neumann(const std::string& boundary, const std::string& content) {
  return list(boundary, parameter("Type", "Neumann") + content);
}

const contact::Conditions::Neumann& loadOn(const drivers::Scene& scene,
                                           const std::string& boundary) {
  return scene.bodies[0].conditions.neumann.at(boundary);
}

TEUCHOS_UNIT_TEST(Constants, areKnownToAllExpressions) {
  SceneText text;
  text.rest = constants(parameter("mu", "0.2") + real("depth", "0.5") +
                        parameter("twice", "2*depth + 0*mu*pi"));
  text.base = parameter("Type", "Contact") + parameter("Gap", "twice*x") +
              friction("Coulomb", parameter("Coefficient", "mu"));
  text.conditions = neumann("right", parameter("Force X", "depth"));
  for (const double mu : {0.2, 0.7}) {
    const drivers::Scene scene = read(text, {"Constants->mu=" + std::to_string(mu)});
    const auto& base = scene.bodies[0].conditions.contact.at("base");
    TEST_EQUALITY(base.gap({3, 0}), 3.0);
    TEST_FLOATING_EQUALITY(base.friction.fieldsAt({1, 0}).front(), mu, 1e-15);
    TEST_FLOATING_EQUALITY(loadOn(scene, "right").x({2, 0.3}), 0.5, 1e-15);
  }
}

TEUCHOS_UNIT_TEST(Constants, thatCannotBeAreRefused) {
  const auto complaint = [](const std::string& list) {
    return complaintOf(withRest(constants(list)).xml());
  };
  for (const char* taken : {"x", "t", "ny", "pi"})
    TEST_ASSERT(contains(complaint(parameter(taken, "1")), "already"));
  TEST_ASSERT(
      contains(complaint(parameter("sin", "1")), "Constants->sin: is a function"));
  TEST_ASSERT(contains(complaint(parameter("2a", "1")), "a letter first"));
  TEST_ASSERT(
      contains(complaint(parameter("a b", "1")), "Constants->a b: is not a name"));
  TEST_ASSERT(contains(complaint(parameter("a", "b") + parameter("b", "1")),
                       "Constants->a = 'b' is not an expression in constants before it"));
  TEST_ASSERT(contains(complaint(parameter("a", "x")), "Constants->a = 'x'"));
  TEST_ASSERT(contains(complaint(parameter("a", "t")), "Constants->a = 't'"));
  TEST_ASSERT(contains(complaint(parameter("a", "1/0")), "one finite number is needed"));
  SceneText text = withRest(constants(parameter("load", "1")));
  text.conditions = neumann("right", parameter("Traction X", "laod"));
  TEST_ASSERT(
      contains(complaintOf(text.xml()), "x, y, t, nx and ny and the constants load"));
  TEST_ASSERT(contains(complaintOf(text.xml()), "did you mean 'load'?"));
  text.conditions = neumann("right", parameter("Traction X", "2*sqtr(x)"));
  TEST_ASSERT(contains(complaintOf(text.xml()), "did you mean 'sqrt'?"));
  text.conditions = neumann("right", parameter("Traction X", "2*sqrt (x)"));
  TEST_ASSERT(contains(complaintOf(text.xml()), "without a blank: sqrt(x)"));
  text.conditions = neumann("right", parameter("Traction X", "weight"));
  TEST_ASSERT(!contains(complaintOf(text.xml()), "did you mean"));
}

TEUCHOS_UNIT_TEST(Expressions, ofFieldsHaveFiniteSquares) {
  SceneText text;
  text.base = parameter("Type", "Contact") + parameter("Gap", "1e100*10^(100*x)");
  const bem::Function gap = read(text).bodies[0].conditions.contact.at("base").gap;
  TEST_FLOATING_EQUALITY(gap({0, 0}), 1e100, 1e-14);
  const std::string told = messageOf([&] { gap({1, 0}); });
  TEST_ASSERT(contains(told, "base->Gap") && contains(told, "square"));
}

std::string table(const std::string& name, const std::string& content) {
  return list("Tables", list(name, content));
}

std::string points(const std::string& value) {
  return entry("Points", "TwoDArray(double)", value);
}

bem::Function gapOf(const SceneText& text) {
  return read(text, {}).bodies[0].conditions.contact.at("base").gap;
}

TEUCHOS_UNIT_TEST(Tables, areFunctionsOfExpressions) {
  for (const std::string kind : {"Linear", "Cubic", "Spline"}) {
    SceneText text;
    text.rest = table("profile", points("7x2:{-3,9, -2,4, -1,1, 0,0, 1,1, 2,4, 3,9}") +
                                     parameter("Interpolation", kind));
    text.base = parameter("Type", "Contact") + parameter("Gap", "profile(x) + 1");
    const bem::Function gap = gapOf(text);
    for (const double x : {-3.0, -1.0, 0.0, 2.0, 3.0})
      TEST_FLOATING_EQUALITY(gap({x, 0}), x * x + 1, 1e-15);
    if (kind != "Cubic")
      TEST_FLOATING_EQUALITY(gap({0.75, 0}), kind == "Linear" ? 1.75 : 1.5625, 1e-15);
    constexpr double step = 1e-6;
    const double kink =
        (gap({1 + step, 0}) - 2 * gap({1, 0}) + gap({1 - step, 0})) / step;
    TEST_COMPARE(std::abs(kink - (kind == "Linear" ? 2 : 0)), <, 1e-4);
    TEST_THROW(gap({3.1, 0}), bem::InputError);
  }
}

TEUCHOS_UNIT_TEST(Expressions, haveNoSignWhereTheyAreNoNumber) {
  SceneText text;
  text.base = parameter("Type", "Contact") + parameter("Gap", "sin(1/x)");  // -nan at 0
  TEST_ASSERT(contains(messageOf([&] { gapOf(text)({0, 0}); }), "is nan at"));
}

// what is no number goes to the parser, as all in parentheses does
TEUCHOS_UNIT_TEST(Expressions, ofNumbersAloneAreWhatTheParserMakesOfThem) {
  const auto valueOf = [](const std::string& gap) {
    SceneText text;
    text.base = parameter("Type", "Contact") + parameter("Gap", gap);
    return gapOf(text)({0.5, 0});
  };
  for (const char* number :
       {"0", "7", "0.3", "-0.1", "+0.7", "1e-3", "2.5E+4", ".5", "1.", " 0.3 ", "-1-1",
        "2e1+1", "0.1234567890123456789", "-0"})
    TEST_EQUALITY_CONST(valueOf(number), valueOf("(" + std::string(number) + ")"));
  for (const char* wrong : {"1e", "1.2.3", "0x10+", "1e400", "1 2", "e5"})
    TEST_ASSERT(contains(messageOf([&] { valueOf(wrong); }), "base->Gap"));
}

TEUCHOS_UNIT_TEST(Tables, areReadFromFiles) {
  SceneText text;
  text.base = parameter("Type", "Contact") + parameter("Gap", "profile(x)");
  for (const char* good : {"x in mm, gap in mm\n# measured\n0, 1\n1; 2 # end\n\n2 4e0\n",
                           "\xEF\xBB\xBF\"0\", \"1\"\n1,2\n2,4\n"}) {
    const test::TemporaryFile file("profile.csv", good);
    text.rest = table("profile", parameter("File", file.path()));
    const bem::Function gap = gapOf(text);
    TEST_FLOATING_EQUALITY(gap({0.5, 0}), 1.5, 1e-15);
    TEST_FLOATING_EQUALITY(gap({1.5, 0}), 3.0, 1e-15);
  }
  for (const char* spoilt : {"O,5\n0, 1\n1, 2\n", "0, 1\nhigh\n1, 2\n", "0, 1\n1\n",
                             "0, 1, 2\n", "0, 1\n1, nan\n"}) {
    const test::TemporaryFile bad("spoilt.csv", spoilt);
    text.rest = table("profile", parameter("File", bad.path()));
    TEST_ASSERT(contains(complaintOf(text.xml()), "is not two numbers"));
  }
}

TEUCHOS_UNIT_TEST(Tables, thatCannotBeAreRefused) {
  const auto complaint = [](const std::string& list) {
    return complaintOf(withRest(list).xml());
  };
  const std::string good = points("2x2:{0,0, 1,1}");
  TEST_ASSERT(contains(complaint(table("sin", good)), "Tables->sin: is a function"));
  TEST_ASSERT(contains(complaint(table("a", good) + constants(parameter("a", "1"))),
                       "Constants->a: is the name of a table, too"));
  TEST_ASSERT(contains(complaint(table("a", points("1x2:{0,0}"))), "at least 2"));
  TEST_ASSERT(contains(complaint(table("a", points("2x2:{0,0, 0,1}"))), "must rise"));
  TEST_ASSERT(contains(complaint(table("a", points("2x3:{0,0,0, 1,1,1}"))), "Tables->a"));
  TEST_ASSERT(contains(complaint(table("a", good + parameter("Interpolation", "Cubic"))),
                       "at least 4"));
  TEST_ASSERT(contains(complaint(table("a", good + parameter("File", "a.csv"))),
                       "give Points or File"));
  TEST_ASSERT(
      contains(complaint(table("a", parameter("File", "a.csv"))), "no such file"));
}

TEUCHOS_UNIT_TEST(Tables, splinesAreExactForCubicsAndSmooth) {
  const std::vector<double> x = {-1, -0.9, -0.2, 0.1, 0.7, 1.5};
  const auto cubic = [](double t) { return 2 * t * t * t - t * t + 0.5; };
  std::vector<double> values;
  std::transform(x.begin(), x.end(), std::back_inserter(values), cubic);
  const Interpolant exact(x, values, Interpolant::Interpolation::Spline);
  for (const double t : {-1.0, -0.95, -0.5, 0.0, 0.3, 1.2, 1.5})
    TEST_COMPARE(std::abs(exact(t) - cubic(t)), <, 2e-15);

  values = {0, 1, -1, 2, 0.5, 3};
  const Interpolant wild(x, values, Interpolant::Interpolation::Spline);
  constexpr double h = 1e-5;
  const auto curvature = [&wild](double t) {
    return (wild(t - h) - 2 * wild(t) + wild(t + h)) / (h * h);
  };
  for (std::size_t i = 1; i + 1 < x.size(); ++i)
    TEST_COMPARE(std::abs(curvature(x[i] - h) - curvature(x[i] + h)), <, 1e-2);
}

TEUCHOS_UNIT_TEST(Normals, areThoseOfSegmentsAndArcs) {
  SceneText text;  // half a disc over the square's upper half, radius 1
  text.geometry = outline("4x2:{0,0, 2,0, 2,1, 0,1}", "{base, side, top, side}") +
                  entry("Bulges", "Array(double)", "{0, 0, 1, 0}");
  text.top = parameter("Type", "Neumann") + parameter("Traction X", "-3*nx") +
             parameter("Traction Y", "-3*ny");
  text.conditions =
      neumann("side", parameter("Traction X", "nx + y") + parameter("Traction Y", "ny"));
  const drivers::Scene scene = read(text);
  for (const double angle : {0.1, 1.0, 2.0, 3.0}) {
    const bem::Vec2 n{std::cos(angle), std::sin(angle)};
    const bem::Vec2 at = bem::Vec2{1, 1} + n;
    TEST_FLOATING_EQUALITY(loadOn(scene, "top").x({at.x, at.y, n}), -3 * n.x, 1e-14);
    TEST_FLOATING_EQUALITY(loadOn(scene, "top").y({at.x, at.y, n}), -3 * n.y, 1e-14);
  }
  const bem::Mesh mesh = drivers::firstMesh(scene.bodies[0]);
  for (int e = 0; e < mesh.size(); ++e)
    for (const double t : {-1.0, 0.0, 1.0}) {
      const bem::SurfacePoint x = mesh.physicalPoint(e, t);
      if (mesh.boundary(e) == "side")  // at corners, too
        TEST_EQUALITY(loadOn(scene, "side").x(x), (x.x > 1 ? 1 : -1) + x.y);
      if (mesh.boundary(e) == "top") {
        TEST_COMPARE(norm(x.normal - (x - bem::Vec2{1, 1})), <, 1e-14);
        TEST_EQUALITY(loadOn(scene, "top").y(x), -3 * x.normal.y);
      }
    }
}

TEUCHOS_UNIT_TEST(Forces, areTheUniformTractionTimesTheLength) {
  SceneText text;
  text.geometry = outline("4x2:{0,0, 2,0, 2,1, 0,1}", "{base, load, top, load}") +
                  entry("Bulges", "Array(double)", "{0, 1, 0, 0}");
  text.conditions =
      neumann("load", parameter("Force X", "6*t^2") + parameter("Force Y", "-1"));
  text.rest = list("History", entry("Times", "Array(double)", "{2}"));
  const drivers::Scene scene = read(text);
  const double length =
      std::acos(-1.0) / 2 + 1;  // half a circle of diameter 1, and a side
  TEST_FLOATING_EQUALITY(loadOn(scene, "load").x({0, 0.1}), 24 / length, 1e-14);
  const auto early = scene.conditionsAt(0.5).front().neumann.at("load");
  TEST_FLOATING_EQUALITY(early.x({0, 0.1}), 1.5 / length, 1e-14);
  TEST_FLOATING_EQUALITY(early.y({0, 0.1}), -1 / length, 1e-14);

  const auto complaint = [&](const std::string& content) {
    text.conditions = neumann("load", content);
    return complaintOf(text.xml());
  };
  TEST_ASSERT(contains(
      complaint(parameter("Force X", "1") + parameter("Traction X", "1")), "not both"));
  TEST_EQUALITY(complaint(parameter("Force X", "1") + parameter("Traction Y", "x")), "");
  for (const char* key : {"Force X", "Force Y"})
    for (const char* ofPlace : {"x", "y", "3*nx + 10", "ny"})
      TEST_ASSERT(contains(complaint(parameter(key, ofPlace)),
                           std::string("load->") + key + " = '" + ofPlace +
                               "' is not an expression in t: "));
  TEST_ASSERT(contains(complaint(parameter("Force Y", "1/(2-t)")),
                       "at t = 2; one finite number is needed"));
}

/// The resultant of the load at 24 Gauss points of each edge: no force, the moment about any
/// point; a bore of radius 1/4 takes it as shear M/(2πr²) alone.
TEUCHOS_UNIT_TEST(Forces, aMomentTurnsTheBoundaryAboutItsCentroid) {
  SceneText text;
  text.geometry =
      outline("4x2:{0,0, 2,0, 2,1, 0,1}", "{base, load, top, load}") +
      entry("Bulges", "Array(double)", "{0, 0.7, 0, 0}") +
      entry("Hole 1 Vertices", "TwoDArray(double)", "2x2:{0.75,0.5, 1.25,0.5}") +
      entry("Hole 1 Edges", "Array(string)", "{bore, bore}") +
      entry("Hole 1 Bulges", "Array(double)", "{1, 1}");
  text.discretization = real("Mesh Size", "0.25");
  text.conditions =
      neumann("load", parameter("Moment", "6*t") + parameter("Force Y", "2")) +
      neumann("bore", parameter("Moment", "-5"));
  const drivers::Scene scene = read(text);
  const bem::Outline& outline = *scene.bodies[0].outline;
  const bem::Rule& rule = bem::gaussLegendre(24);
  for (const std::string name : {"load", "bore"}) {
    bem::Vec2 force;
    double moment = 0;
    bem::Vec2 middle;
    double length = 0;
    for (const bem::Edge& edge : outline.edges())
      for (int q = 0; edge.boundary == name && q < rule.size(); ++q) {
        const bem::Vec2 at = outline.physical(edge.curve.point(rule.points[q]));
        const bem::SurfacePoint x{at.x, at.y, {}};
        const double w =
            rule.weights[q] * 0.5 * edge.curve.length() * outline.scaling().length;
        const bem::Vec2 traction{loadOn(scene, name).x(x), loadOn(scene, name).y(x)};
        force = force + w * traction;
        moment += w * cross(x, traction);
        middle = middle + w * x;
        length += w;
      }
    const double forceY = name == "load" ? 2 : 0;
    TEST_FLOATING_EQUALITY(1 + force.x, 1.0, 1e-13);
    TEST_FLOATING_EQUALITY(1 + force.y, 1 + forceY, 1e-13);
    TEST_FLOATING_EQUALITY(moment - forceY * middle.x / length,
                           name == "load" ? 6.0 : -5.0, 1e-13);
  }
  const double shear = 5 / (2 * std::acos(-1.0) * 0.0625);
  TEST_FLOATING_EQUALITY(loadOn(scene, "bore").y({0.75, 0.5}), shear, 1e-13);
  TEST_FLOATING_EQUALITY(loadOn(scene, "bore").x({1, 0.75}), shear, 1e-13);
  text.conditions = neumann("load", parameter("Moment", "x"));
  TEST_ASSERT(
      contains(complaintOf(text.xml()), "load->Moment = 'x' is not an expression in t"));
}

TEUCHOS_UNIT_TEST(Motions, areExpressionsInTimeAlone) {
  for (const char* key :
       {"Displacement X", "Displacement Y", "Rotation", "Force X", "Force Y", "Moment"})
    for (const char* text : {"t", "x", "y", "nx", "ny"}) {
      SceneText scene;
      scene.bodies = list(
          "punch", list("Material", entry("Rigid", "bool", "true")) +
                       list("Geometry", outline("3x2:{0,2, 1,2, 0,3}", "{a, b, c}")) +
                       list("Motion", parameter(key, text)));
      const std::string complaint = complaintOf(scene.xml());
      TEST_EQUALITY(complaint,
                    std::string(text) == "t"
                        ? ""
                        : bem::message("Bodies->punch->Motion->", key, " = '", text,
                                       "' is not an expression in t: Unexpected token \"",
                                       text, "\" found at position 0.",
                                       *text != 'n' ? "; it is one number, which does "
                                                      "not vary along x and y"
                                                    : ""));
    }
}

}  // namespace
