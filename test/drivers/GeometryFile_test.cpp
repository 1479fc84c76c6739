#include "drivers/scene/SceneFile.hpp"
#include "test/drivers/SceneText.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <filesystem>
#include <string>

namespace epafi {

namespace {

using test::complaintOf;
using test::contains;
using test::SceneText;

const std::string meshes = EPAFI_MESHES;

SceneText withFile(const std::string& name) {
  SceneText scene;
  scene.geometry = test::parameter("File", name);
  scene.discretization = test::real("Mesh Size", "0.25");
  return scene;
}

/// A plate [0,2]x[0,1] with a hole [0.8,1.2]x[0.4,0.6], as Gmsh writes it.
TEUCHOS_UNIT_TEST(GeometryFile, givesOutlineBoundariesAndLengths) {
  const drivers::Scene scene = test::read(withFile(meshes + "/plate.msh"));
  TEST_EQUALITY(scene.bodies[0].outline->loops(), 2);
  TEST_EQUALITY(scene.bodies[0].outline->edges().size(), 8u);
  const std::string expected[] = {"base", "right", "top", "left"};
  for (int e = 0; e < 4; ++e)
    TEST_EQUALITY(scene.bodies[0].outline->edge(e).boundary, expected[e]);
  TEST_ASSERT(scene.bodies[0].outline->contains({0.5, 0.5}));
  TEST_ASSERT(!scene.bodies[0].outline->contains({1, 0.5}));
  TEST_EQUALITY(scene.bodies[0].elementsPerEdge[0], 8);
  TEST_EQUALITY(scene.bodies[0].elementsPerEdge[1], 4);
  TEST_EQUALITY(scene.bodies[0].conditions.contact.count("base"), 1u);
}

TEUCHOS_UNIT_TEST(GeometryFile, theUsedSceneNeedsNoMeshAndHasTheSameOutline) {
  const drivers::Scene scene = test::read(withFile(meshes + "/plate.msh"));
  const std::string used = usedXml(scene);
  TEST_ASSERT(!contains(used, ".msh"));
  const test::TemporaryFile file("used.xml", used);
  const drivers::Scene again = drivers::readScene(file.path());
  TEST_EQUALITY(again.bodies[0].elementsPerEdge == scene.bodies[0].elementsPerEdge, true);
  for (std::size_t e = 0; e < scene.bodies[0].outline->edges().size(); ++e) {
    const bem::Edge& a = scene.bodies[0].outline->edges()[e];
    const bem::Edge& b = again.bodies[0].outline->edges()[e];
    TEST_EQUALITY(a.boundary, b.boundary);
    TEST_EQUALITY(a.curve.from().x, b.curve.from().x);
    TEST_EQUALITY(a.curve.from().y, b.curve.from().y);
  }
}

TEUCHOS_UNIT_TEST(GeometryFile, namesAreRelativeToTheScene) {
  const test::TemporaryFile mesh("plate.msh", drivers::readText(meshes + "/plate.msh"));
  const auto scene = std::filesystem::path(mesh.path()).parent_path() / "relative.xml";
  std::ofstream(scene) << withFile("plate.msh").xml();
  TEST_EQUALITY(drivers::readScene(scene.string()).bodies[0].outline->loops(), 2);
}

TEUCHOS_UNIT_TEST(GeometryFile, complaintsNameTheKeyAndTheFile) {
  const auto complains = [&](const SceneText& scene, const std::string& part) {
    const std::string complaint = complaintOf(scene.xml());
    out << complaint << "\n";
    TEST_ASSERT(contains(complaint, "Bodies->block->Geometry->"));
    TEST_ASSERT(contains(complaint, part));
  };
  complains(withFile("nowhere.msh"), "File = 'nowhere.msh'");
  complains(withFile(""), "folder");
  complains(withFile("/dev/zero"), "File = '/dev/zero': is a device");
  SceneText both = withFile("plate.msh");
  both.geometry += test::entry("Edges", "Array(string)", "{base}");
  complains(both, "Edges");
  SceneText neither;
  neither.geometry = "";
  complains(neither, "Vertices: missing");
}

}  // namespace

}  // namespace epafi
