#include "drivers/process/Resources.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <filesystem>
#include <fstream>
#include <unistd.h>

// What is free, from the files in which Linux says so.
namespace epafi {

namespace {

namespace fs = std::filesystem;

/// A tree of files below a folder of its own.
class Tree {
 public:
  Tree()
      : root_(fs::temp_directory_path() /
              ("epafi_memory_test_" + std::to_string(::getpid()))) {
    write("proc/meminfo", "MemTotal: 9000000 kB\nMemAvailable: 4096000 kB\n");
  }
  ~Tree() { fs::remove_all(root_); }
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;

  void write(const std::string& file, const std::string& text) const {
    fs::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }
  double free() const { return drivers::freeMemory(root_.string()); }

 private:
  fs::path root_;
};

constexpr const char* mega100 = "104857600\n";

TEUCHOS_UNIT_TEST(Memory, isThatOfTheMachineWithoutGroups) {
  const Tree tree;
  TEST_EQUALITY(tree.free(), 4000.0);
  tree.write("proc/self/cgroup", "0::/\n");
  TEST_EQUALITY(tree.free(), 4000.0);
}

TEUCHOS_UNIT_TEST(Memory, ofGroupsIsTheLeastOfAllAbove) {
  const Tree tree;
  tree.write("proc/self/cgroup", "0::/user/run\n");
  tree.write("sys/fs/cgroup/user/run/memory.max", "max\n");
  tree.write("sys/fs/cgroup/user/memory.max", "1073741824\n");  // 1 GiB
  tree.write("sys/fs/cgroup/user/memory.current", mega100);
  TEST_EQUALITY(tree.free(), 924.0);
  tree.write("sys/fs/cgroup/user/memory.stat", "anon 1\ninactive_file 52428800\n");
  TEST_EQUALITY(tree.free(), 974.0);
  tree.write("sys/fs/cgroup/user/run/memory.max", "536870912\n");
  TEST_EQUALITY(tree.free(), 512.0);
}

TEUCHOS_UNIT_TEST(Memory, ofOldGroupsToo) {
  const Tree tree;
  tree.write("proc/self/cgroup", "9:cpu,cpuacct:/a\n4:memory:/job\n");
  tree.write("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "209715200\n");
  tree.write("sys/fs/cgroup/memory/job/memory.usage_in_bytes", mega100);
  TEST_EQUALITY(tree.free(), 100.0);
  tree.write("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "9223372036854771712\n");
  TEST_EQUALITY(tree.free(), 4000.0);
}

TEUCHOS_UNIT_TEST(Memory, ofThisMachineIsSomething) {
  TEST_COMPARE(drivers::freeMemory(), >, 1.0);
  TEST_COMPARE(drivers::ownMemory(), >, 1.0);
}

}  // namespace

}  // namespace epafi
