// What the scenes start from that fuzzing changes.
#include "drivers/scene/SceneFile.hpp"
#include "drivers/scene/SceneReader.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <filesystem>
#include <set>

namespace epafi {

namespace {

/// The schema's paths that a list uses.
std::set<std::string> pathsOf(const Teuchos::ParameterList& list,
                              const std::string& prefix) {
  std::set<std::string> paths;
  for (const auto& item : list) {
    const std::string path = prefix + item.first;
    const drivers::Parameter& row = bem::declared(drivers::parameters(), path);
    paths.insert(row.path);
    if (row.kind == drivers::Kind::List)
      paths.merge(pathsOf(list.sublist(item.first), path + "->"));
  }
  return paths;
}

TEUCHOS_UNIT_TEST(FuzzCorpus, isOfScenesThatUseEveryKey) {
  std::set<std::string> used;
  for (const auto& entry : std::filesystem::directory_iterator(EPAFI_FUZZ_SCENES)) {
    const std::string file = entry.path().string();
    out << file << "\n";
    TEST_NOTHROW(drivers::readScene(file));
    used.merge(pathsOf(drivers::rawScene(drivers::readText(file), file).list, ""));
  }
  for (const drivers::Parameter& row : drivers::parameters()) {
    out << row.path << "\n";
    TEST_ASSERT(used.count(row.path) == 1);
  }
}

}  // namespace

}  // namespace epafi
