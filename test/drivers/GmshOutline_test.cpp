#include "drivers/scene/GmshOutline.hpp"

#include "bem/base/Error.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <string>

namespace epafi {

namespace {

using bem::Loops;

const std::string header = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string names =
    "$PhysicalNames\n2\n1 1 \"under side\"\n1 2 \"rest\"\n$EndPhysicalNames\n";
const std::string nodes =
    "$Nodes\n5\n1 0 0 7\n2 1 0 7\n3 1 1 7\n4 0 1 7\n5 0.5 0 7\n$EndNodes\n";

std::string elements(const std::string& rows, int count) {
  return "$Elements\n" + std::to_string(count) + "\n" + rows + "$EndElements\n";
}

/// The unit square, its lines in no order and of both directions.
const std::string square = elements(
    "1 1 2 2 3 4 3\n2 1 2 1 1 5 1\n3 1 2 2 4 1 4\n4 1 2 1 1 5 2\n5 1 2 2 2 3 2\n"
    "6 2 2 9 1 1 2 3\n",
    6);

std::string complaintOf(const std::string& text) {
  try {
    drivers::readGmsh(text);
  } catch (const bem::InputError& error) {
    return error.what();
  }
  return "";
}

#define TEST_COMPLAINT(text, part)                          \
  {                                                         \
    const std::string complaint = complaintOf(text);        \
    out << complaint << "\n";                               \
    TEST_ASSERT(complaint.find(part) != std::string::npos); \
  }

TEUCHOS_UNIT_TEST(GmshOutline, chainsLinesCounterClockwiseAndMergesStraightOnes) {
  const Loops loops = drivers::readGmsh(header + names + nodes + square);
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
      "$Nodes\n8\n1 4 0 0\n2 3 1 0\n3 2 0 0\n4 3 -1 0\n"
      "5 3.70710678118654752 0.70710678118654752 0\n"
      "6 2.5 0.86602540378443865 0\n"
      "7 2.29289321881345248 -0.70710678118654752 0\n"
      "8 3.70710678118654752 -0.70710678118654752 0\n$EndNodes\n" +
      elements("1 8 2 1 1 1 2 5\n2 8 2 1 1 3 2 6\n3 8 2 1 1 3 4 7\n4 8 2 1 1 4 1 8\n", 4);
  const bem::Loop outer = drivers::readGmsh(header + names + circle).outer;
  TEST_EQUALITY(outer.vertices.size(), 2u);
  for (const double bulge : outer.bulges)
    TEST_FLOATING_EQUALITY(bulge, 1.0, 1e-14);
  TEST_EQUALITY(outer.vertices[0].x, 4);
  TEST_EQUALITY(outer.edges[1], "under side");
  TEST_NOTHROW(bem::Outline{outer});
}

TEUCHOS_UNIT_TEST(GmshOutline, aGroupWithoutANameIsCalledByItsNumber) {
  TEST_EQUALITY(drivers::readGmsh(header + nodes + square).outer.edges[0], "1");
}

TEUCHOS_UNIT_TEST(GmshOutline, aChangeOfNameIsACornerEvenOnAStraightSide) {
  std::string text = square;
  text.replace(text.find("2 1 2 1 1 5 1"), 13, "2 1 2 2 1 5 1");
  TEST_EQUALITY(drivers::readGmsh(header + names + nodes + text).outer.edges.size(), 5u);
}

TEUCHOS_UNIT_TEST(GmshOutline, namesTheLineOfWhatIsNoMesh) {
  TEST_COMPLAINT("", "line 1: $MeshFormat is missing");
  TEST_COMPLAINT("solid\n", "line 1: $MeshFormat is missing");
  TEST_COMPLAINT("$MeshFormat\n", "the file ends");
  TEST_COMPLAINT("$MeshFormat\n4.1 1 8\n", "line 2: the mesh is binary");
  TEST_COMPLAINT("$MeshFormat\n4.0 0 8\n", "line 2: format 4.0 is not read");
  TEST_COMPLAINT("$MeshFormat\n2.2 zero 8\n", "line 2: 'zero' is not a whole number");
  TEST_COMPLAINT(header + names + nodes, "no $Elements");
  TEST_COMPLAINT(header + "$Nodes\n1\n1 0 nan 0\n", "line 6: 'nan' is not a finite");
  TEST_COMPLAINT(header + "$Nodes\n1\n1 0 0\n", "line 6: the line ends where z");
  TEST_COMPLAINT(header + "$Nodes\n-1\n", "line 5: the number of nodes is -1");
  TEST_COMPLAINT(header + "$Nodes\n2\n1 0 0 0\n1 0 0 0\n",
                 "line 7: node 1 is given twice");
  TEST_COMPLAINT(header + "$PhysicalNames\n1\n1 1 \"open\n", "a quoted name has no end");
  TEST_COMPLAINT(header + nodes + elements("1 1 2 1 1 5\n", 1), "line 14: the line ends");
  TEST_COMPLAINT(header + nodes + "$Elements\n9\n1 1 2 1 1 5 1\n", "the file ends");
}

TEUCHOS_UNIT_TEST(GmshOutline, saysWhyAMeshIsNoOutline) {
  const std::string start = header + names + nodes;
  TEST_COMPLAINT(start + elements("1 1 2 0 1 1 2\n", 1), "Physical Curve");
  TEST_COMPLAINT(start + elements("1 1 2 1 1 1 2\n2 1 2 1 1 2 3\n", 2),
                 "at node 1 = (0, 0) the outline ends");
  TEST_COMPLAINT(start + elements("1 1 2 1 1 1 9\n", 1), "there is no node 9");
  TEST_COMPLAINT(start + elements("1 1 2 1 1 0 1\n", 1), "there is no node 0");
  TEST_COMPLAINT(start + elements("1 1 2 1 1 3 3\n", 1), "to itself");
  TEST_COMPLAINT(start + elements("1 1 2 1 1 1 2\n2 1 2 2 1 2 1\n", 2),
                 "a second element");
  TEST_COMPLAINT(start + elements("1 26 2 1 1 1 2 5 3\n", 1), "higher order");
  TEST_COMPLAINT(start + elements("1 8 2 1 1 1 2 3\n2 8 2 1 1 1 2 9\n", 2), "node 9");
  TEST_COMPLAINT(start + elements("1 1 2 1 1 1 5\n2 1 2 1 1 5 2\n3 1 2 1 1 1 2\n", 3),
                 "no area");
  std::string fork = square;
  fork.replace(fork.find("6 2 2 9 1 1 2 3"), 15, "6 1 2 1 1 1 3");
  TEST_COMPLAINT(start + fork, "3 lines meet");
  std::string tilted = nodes;
  tilted.replace(tilted.find("3 1 1 7"), 7, "3 1 1 8");
  TEST_COMPLAINT(header + names + tilted + square, "constant z");
}

}  // namespace

}  // namespace epafi
