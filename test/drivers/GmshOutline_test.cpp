#include "Message.hpp"
#include "drivers/scene/OutlineChain.hpp"
#include "drivers/scene/SceneFile.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <string>
#include <vector>

namespace epafi {

namespace {

using bem::Loops;

const std::string header = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
const std::string names =
    "$PhysicalNames\n2\n1 1 \"under side\"\n1 2 \"rest\"\n$EndPhysicalNames\n";
/// Curves 1 and 2 in the groups of these numbers, curve 3 in none.
const std::string entities =
    "$Entities\n0 3 0 0\n1 0 0 0 1 0 0 1 1 0\n2 0 0 0 1 1 0 1 -2 0\n3 0 0 0 1 1 0 0 0\n"
    "$EndEntities\n";
const std::string nodes =
    "$Nodes\n2 5 1 5\n1 1 0 4\n1\n2\n3\n4\n0 0 7\n1 0 7\n1 1 7\n0 1 7\n1 1 0 1\n5\n"
    "0.5 0 7\n$EndNodes\n";

struct Element {
  int dimension;
  int entity;
  int type;
  std::string nodes;
};

/// Each in a block of its own.
std::string elements(const std::vector<Element>& all) {
  std::string text = "$Elements\n" + std::to_string(all.size()) + " 0 0 0\n";
  for (const Element& one : all)
    text += std::to_string(one.dimension) + " " + std::to_string(one.entity) + " " +
            std::to_string(one.type) + " 1\n1 " + one.nodes + "\n";
  return text + "$EndElements\n";
}

/// A line of first order.
Element line(int curve, const std::string& ends) { return {1, curve, 1, ends}; }

/// The unit square, its lines in no order and of both directions.
const std::vector<Element> square = {line(2, "4 3"), line(1, "1 5"), line(2, "4 1"),
                                     line(1, "5 2"), line(2, "2 3"), {2, 9, 2, "1 2 3"}};

#define TEST_COMPLAINT(text, part)                                                   \
  {                                                                                  \
    const std::string complaint = test::messageOf([&] { drivers::readGmsh(text); }); \
    out << complaint << "\n";                                                        \
    TEST_ASSERT(test::contains(complaint, part));                                    \
  }

TEUCHOS_UNIT_TEST(GmshOutline, chainsLinesCounterClockwiseAndMergesStraightOnes) {
  const Loops loops =
      drivers::readGmsh(header + names + entities + nodes + elements(square));
  TEST_EQUALITY(loops.holes.size(), 0u);
  const bem::Loop& outer = loops.outer;
  TEST_EQUALITY(outer.vertices.size(), 4u);
  const double x[] = {0, 1, 1, 0};
  const double y[] = {0, 0, 1, 1};
  for (std::size_t i = 0; i < 4; ++i) {
    TEST_EQUALITY(outer.vertices[i].x, x[i]);
    TEST_EQUALITY(outer.vertices[i].y, y[i]);
    TEST_EQUALITY(outer.edges[i], i == 0 ? "under side" : "rest");
  }
  TEST_NOTHROW(bem::Outline(outer, loops.holes));
}

// A circle of radius 1 about (3, 0) as four lines of second order, one written backwards:
// two half circles from the first point on, as far as one edge goes.
TEUCHOS_UNIT_TEST(GmshOutline, takesLinesOfSecondOrderForArcs) {
  const std::string circle =
      "$Nodes\n1 8 1 8\n1 1 0 8\n1\n2\n3\n4\n5\n6\n7\n8\n4 0 0\n3 1 0\n2 0 0\n3 -1 0\n"
      "3.70710678118654752 0.70710678118654752 0\n"
      "2.5 0.86602540378443865 0\n"
      "2.29289321881345248 -0.70710678118654752 0\n"
      "3.70710678118654752 -0.70710678118654752 0\n$EndNodes\n" +
      elements({{1, 1, 8, "1 2 5"},
                {1, 1, 8, "3 2 6"},
                {1, 1, 8, "3 4 7"},
                {1, 1, 8, "4 1 8"}});
  const bem::Loop outer = drivers::readGmsh(header + names + entities + circle).outer;
  TEST_EQUALITY(outer.vertices.size(), 2u);
  for (const double bulge : outer.bulges)
    TEST_FLOATING_EQUALITY(bulge, 1.0, 1e-14);
  TEST_EQUALITY(outer.vertices[0].x, 4);
  TEST_EQUALITY(outer.edges[1], "under side");
  TEST_NOTHROW(bem::Outline{outer});
}

TEUCHOS_UNIT_TEST(GmshOutline, aGroupWithoutANameIsCalledByItsNumber) {
  TEST_EQUALITY(
      drivers::readGmsh(header + entities + nodes + elements(square)).outer.edges[0],
      "1");
}

TEUCHOS_UNIT_TEST(GmshOutline, aChangeOfNameIsACornerEvenOnAStraightSide) {
  std::vector<Element> changed = square;
  changed[1].entity = 2;
  TEST_EQUALITY(drivers::readGmsh(header + names + entities + nodes + elements(changed))
                    .outer.edges.size(),
                5u);
}

TEUCHOS_UNIT_TEST(GmshOutline, namesTheLineOfWhatIsNoMesh) {
  TEST_COMPLAINT("", "line 1: $MeshFormat is missing");
  TEST_COMPLAINT("solid\n",
                 "line 1: $MeshFormat is missing; a geometry is a Gmsh mesh (.msh)");
  TEST_COMPLAINT(header +
                     "$PhysicalNames\n1\n1 1 \"Grundfl\xe4"
                     "che\"\n$EndPhysicalNames\n",
                 "line 6: the name 'Grundfl?che' is not encoded in UTF-8");
  TEST_COMPLAINT("$MeshFormat\n", "the file ends");
  TEST_COMPLAINT("$MeshFormat\n4.1 2 8\n", "line 2: file type 2 is unknown");
  TEST_COMPLAINT("$MeshFormat\n4.1 zero 8\n", "line 2: 'zero' is not a whole number");
  TEST_COMPLAINT(header + names + nodes, "no $Elements");
  const std::string one = header + "$Nodes\n1 1 1 1\n1 1 0 1\n1\n";
  TEST_COMPLAINT(one + "0 nan 0\n", "line 8: 'nan' is not a finite");
  TEST_COMPLAINT(one + "0 0\n", "line 8: the line ends where z");
  TEST_COMPLAINT(header + "$Nodes\n-1\n", "line 5: the number of blocks is -1");
  TEST_COMPLAINT(header + "$Nodes\n1 2 1 1\n1 1 0 2\n1\n1\n0 0 0\n0 0 0\n",
                 "line 10: node 1 is given twice");
  TEST_COMPLAINT(header + "$PhysicalNames\n1\n1 1 \"open\n", "a quoted name has no end");
  const std::string start = header + entities + nodes;
  TEST_COMPLAINT(start + elements({line(1, "5")}), "line 28: the line ends");
  TEST_COMPLAINT(start + "$Elements\n9 0 0 0\n1 1 1 1\n1 5 1\n", "the file ends");
}

/// A plate with a bore, lines of second order, in the plane filled with triangles.
TEUCHOS_UNIT_TEST(GmshOutline, aBinaryMeshIsTheSameOutline) {
  const std::string folder = EPAFI_MESHES;
  const std::string bytes = drivers::readText(folder + "/bore_binary.msh");
  const Loops loops = drivers::readGmsh(bytes);
  const Loops same = drivers::readGmsh(drivers::readText(folder + "/bore.msh"));
  TEST_EQUALITY(loops.holes.size(), 1u);
  TEST_ASSERT(loops.outer.edges == same.outer.edges);
  TEST_COMPARE_FLOATING_ARRAYS(loops.holes[0].bulges, same.holes[0].bulges, 1e-14);
  for (std::size_t i = 0; i < 4; ++i)
    TEST_EQUALITY(norm(loops.outer.vertices[i] - same.outer.vertices[i]), 0);
  for (const std::size_t size : {bytes.size() / 4, bytes.size() / 2})
    TEST_COMPLAINT(bytes.substr(0, size), "the file ends where");
  TEST_COMPLAINT("$MeshFormat\n4.1 1 8\n" + std::string("\0\0\0\1", 4), "order of bytes");
  TEST_COMPLAINT("$MeshFormat\n4.1 1 8", "the file ends where");
}

TEUCHOS_UNIT_TEST(GmshOutline, saysHowAnotherFormatIsExportedAgain) {
  for (const char* format : {"2.2 0", "2.2 1", "2 0", "4 0", "4.0 0", "3 0", "5 0"})
    TEST_COMPLAINT("$MeshFormat\n" + std::string(format) + " 8\n",
                   "is not read, only 4.1; export it again by gmsh OLD.msh -save");
  TEST_COMPLAINT("$MeshFormat\n2.2 0 8\n", "line 2: format 2.2 is not read");
}

TEUCHOS_UNIT_TEST(GmshOutline, saysWhyAMeshIsNoOutline) {
  const std::string start = header + names + entities + nodes;
  TEST_COMPLAINT(start + elements({line(3, "1 2")}), "Physical Curve");
  TEST_COMPLAINT(start + elements({line(1, "1 2"), line(1, "2 3")}),
                 "at node 1 = (0, 0) the outline ends");
  TEST_COMPLAINT(start + elements({line(1, "1 9")}), "there is no node 9");
  TEST_COMPLAINT(start + elements({line(1, "0 1")}), "there is no node 0");
  TEST_COMPLAINT(start + elements({line(1, "3 3")}), "to itself");
  TEST_COMPLAINT(start + elements({line(1, "1 2"), line(2, "2 1")}), "a second element");
  TEST_COMPLAINT(start + elements({{1, 1, 26, "1 2 5 3"}}), "higher order");
  TEST_COMPLAINT(start + elements({{1, 1, 8, "1 2 3"}, {1, 1, 8, "1 2 9"}}), "node 9");
  TEST_COMPLAINT(start + elements({line(1, "1 5"), line(1, "5 2"), line(1, "1 2")}),
                 "no area");
  std::vector<Element> fork = square;
  fork.push_back(line(1, "1 3"));
  TEST_COMPLAINT(start + elements(fork), "3 lines meet");
  std::string tilted = nodes;
  tilted.replace(tilted.find("1 1 7"), 5, "1 1 8");
  TEST_COMPLAINT(header + names + entities + tilted + elements(square), "constant z");
  std::string twice = entities;
  twice.replace(twice.find("1 1 0\n"), 6, "2 1 2 0\n");
  TEST_COMPLAINT(header + twice + nodes + elements(square),
                 "curve 1 belongs to 2 physical groups");
}

}  // namespace

}  // namespace epafi
