#include "Message.hpp"
#include "drivers/scene/OutlineChain.hpp"
#include "drivers/scene/SceneFile.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace epafi {

namespace {

using bem::Loops;

/// Group codes and values of one entity: {"0", "LINE", "8", "base", ...}
using Entity = std::vector<std::string>;

std::string drawing(const std::vector<Entity>& entities) {
  std::string text = "  0\nSECTION\n  2\nENTITIES\n";
  for (const Entity& entity : entities)
    for (const std::string& word : entity)
      text += word + "\n";
  return text + "  0\nENDSEC\n  0\nEOF\n";
}

Entity line(const std::string& layer, const std::string& x0, const std::string& y0,
            const std::string& x1, const std::string& y1) {
  return {"0",  "LINE", "8",  layer, " 10", x0, " 20", y0,
          "30", "0",    "11", x1,    "21",  y1, "31",  "0"};
}

Entity arc(const std::string& x, const std::string& y, const std::string& radius,
           const std::string& from, const std::string& to) {
  return {"0", "ARC", "8", "arc", "10", x, "20", y, "40", radius, "50", from, "51", to};
}

/// A square with a half circle of radius 1 to the right, its corners off by 1e-8.
TEUCHOS_UNIT_TEST(DxfOutline, chainsLinesAndArcsOfAllLayers) {
  const Loops loops = drivers::readDxf(
      drawing({line("left", "0", "2", "0", "0"),
               arc("2", "1", "1", "270", "90"),
               line("base", "0", "1e-8", "2", "0"),
               line("top", "2", "2", "0", "2"),
               {"0", "TEXT", "8", "notes", "10", "5", "20", "5", "1", "a plate"}}));
  TEST_EQUALITY(loops.holes.size(), 0u);
  TEST_EQUALITY(loops.outer.vertices.size(), 4u);
  TEST_ASSERT(loops.outer.edges ==
              (std::vector<std::string>{"left", "base", "arc", "top"}));
  TEST_FLOATING_EQUALITY(loops.outer.bulges[2], 1.0, 1e-15);
  for (const int straight : {0, 1, 3})
    TEST_EQUALITY(loops.outer.bulges[straight], 0.0);
  TEST_NOTHROW(bem::Outline(loops.outer, loops.holes));
}

TEUCHOS_UNIT_TEST(DxfOutline, aCircleIsTwoHalvesAndAHoleInWhatSurroundsIt) {
  const Loops loops = drivers::readDxf(
      drawing({{"0", "CIRCLE", "8", "bore", "10", "1", "20", "1", "40", "0.5"},
               {"0",  "LWPOLYLINE", "8",  "side",  "90", "4",  "70", "1",  "10",
                "0",  "20",         "0",  "10",    "2",  "20", "0",  "10", "2",
                "20", "2",          "42", "-0.25", "10", "0",  "20", "2"}}));
  TEST_EQUALITY(loops.outer.vertices.size(), 4u);
  TEST_EQUALITY(loops.outer.bulges[2], -0.25);
  TEST_EQUALITY(loops.holes.size(), 1u);
  TEST_EQUALITY(loops.holes[0].vertices.size(), 2u);
  for (const double bulge : loops.holes[0].bulges)
    TEST_FLOATING_EQUALITY(bulge, 1.0, 1e-15);
}

/// A view from behind: x to the left, an arc's sense with it.
TEUCHOS_UNIT_TEST(DxfOutline, turnsWhatIsSeenFromBehind) {
  Entity mirrored = arc("-2", "1", "1", "90", "270");
  mirrored.insert(mirrored.end(), {"230", "-1.0"});
  const Loops loops =
      drivers::readDxf(drawing({mirrored, line("x", "2", "2", "2", "0")}));
  TEST_EQUALITY(loops.outer.vertices.size(), 2u);
  TEST_FLOATING_EQUALITY(
      *std::max_element(loops.outer.bulges.begin(), loops.outer.bulges.end()), 1.0,
      1e-15);
  TEST_ASSERT(bem::Outline(loops.outer).contains({2.5, 1}));
}

/// The same plate as a program of 1992 and one of 2010 wrote it: a polyline with bulges and
/// a bore.
TEUCHOS_UNIT_TEST(DxfOutline, readsOldAndNewFormats) {
  std::vector<Loops> read;
  for (const char* name : {"/plate_r12.dxf", "/plate_2010.dxf"})
    read.push_back(drivers::readDxf(drivers::readText(std::string(EPAFI_MESHES) + name)));
  for (const Loops& loops : read) {
    TEST_EQUALITY(loops.outer.vertices.size(), 5u);
    TEST_EQUALITY(loops.holes.size(), 1u);
    TEST_NOTHROW(bem::Outline(loops.outer, loops.holes));
  }
  TEST_ASSERT(read[0].outer.edges == read[1].outer.edges);
  TEST_ASSERT(read[0].outer.bulges == read[1].outer.bulges);
}

TEUCHOS_UNIT_TEST(DxfOutline, saysWhatIsNoOutline) {
  const auto complains = [&](const std::string& text, const std::string& part) {
    const std::string complaint = test::messageOf([&] { drivers::readDxf(text); });
    out << complaint << "\n";
    TEST_ASSERT(test::contains(complaint, part));
  };
  complains("", "no section ENTITIES");
  complains("AutoCAD Binary DXF", "not a drawing in ASCII DXF");
  complains("0\nSECTION\n2", "line 3: the file ends");
  complains(drawing({}), "no lines, arcs");
  complains(drawing({line("a", "0", "0", "one", "0")}), "line 16: 'one'");
  complains(drawing({line("a", "0", "0", "1", "0")}),
            "the outline ends with 'a'; lines, arcs");
  const auto triangle = [](const std::string& left, const std::string& gap) {
    const std::string right = left + "1";  // 1 or 21
    return std::vector<Entity>{line("a", left, "0", right, "0"),
                               line("b", right, gap, left, "1"),
                               line("c", left, "1", left, "0")};
  };
  complains(drawing(triangle("0", "0.01")),
            "with 'a'; the nearest other end, of 'b', is 0.01 away; lines, arcs");
  std::vector<Entity> all = triangle("0", "0");
  all.push_back(line("axis", "0", "1", "1", "1"));
  complains(drawing(all), "3 lines meet, 'b', 'c', 'axis'; an outline has two");
  all = triangle("0", "0");
  for (const Entity& other : triangle("2", "0"))
    all.push_back(other);
  complains(drawing(all),
            "'a' and 'a' are not one inside the other; of several bodies in a file "
            "Geometry->Boundaries");
  complains(drawing({line("Grundfl\xe4"
                          "che",
                          "0", "0", "1", "0")}),
            "line 8: the name 'Grundfl?che' is not encoded in UTF-8");
  complains(drawing({line("a\tb", "0", "0", "1", "0")}),
            "line 8: the name 'a?b' has a control character");
  complains(drawing({{"0", "LINE", "8", "a", "10", "0"}}), "LINE has no group");
  complains(drawing({{"0", "SPLINE", "8", "a"}}), "SPLINE is not read");
  complains(drawing({arc("0", "0", "-1", "0", "90")}), "radius -1");
  complains(drawing({{"0", "LWPOLYLINE", "8", "a", "70", "1", "10", "1", "20", "0"}}),
            "no length");
}

}  // namespace

}  // namespace epafi
