#include "drivers/process/Resources.hpp"

#include <algorithm>
#include <ctime>
#include <fstream>
#include <limits>
#include <malloc.h>
#include <sstream>
#include <sys/resource.h>
#include <unistd.h>

namespace epafi::drivers {

namespace {

constexpr double mebi = 1024.0 * 1024.0;
constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The number in a file; `otherwise` if there is no file or no number ("max").
double numberIn(const std::string& file, double otherwise) {
  double value = 0;
  return std::ifstream(file) >> value ? value : otherwise;
}

/// The number after `word` at the start of a line; `otherwise` if there is none.
double numberBehind(const std::string& file, const std::string& word, double otherwise) {
  std::ifstream lines(file);
  std::string first;
  double value = 0;
  for (std::string line; std::getline(lines, line);)
    if (line.rfind(word, 0) == 0 && std::istringstream(line) >> first >> value &&
        first == word)
      return value;
  return otherwise;
}

/// Names of the files of a control group.
struct Names {
  const char* limit;
  const char* used;
  const char* cache;  ///< in memory.stat
};

/// The least that a group and its parents leave [bytes]; limits from 1e18 on mean none.
double leftIn(const std::string& hierarchy, std::string group, const Names& names) {
  double left = unlimited;
  for (;;) {
    const std::string folder = hierarchy + group + "/";
    const double limit = numberIn(folder + names.limit, unlimited);
    if (limit < 1e18)
      left = std::min(left, limit - numberIn(folder + names.used, 0) +
                                numberBehind(folder + "memory.stat", names.cache, 0));
    if (group.empty())
      return left;
    group.erase(group.rfind('/'));
  }
}

double leftInGroups(const std::string& root) {
  double left = unlimited;
  std::ifstream groups(root + "/proc/self/cgroup");  // <number>:<controllers>:<group>
  for (std::string line; std::getline(groups, line);) {
    const auto first = line.find(':');
    const auto second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos)
      continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    std::string group = line.substr(second + 1);
    if (group == "/")
      group.clear();
    if (controllers.empty())
      left = std::min(left, leftIn(root + "/sys/fs/cgroup", group,
                                   {"memory.max", "memory.current", "inactive_file"}));
    else if (("," + controllers + ",").find(",memory,") != std::string::npos)
      left = std::min(left, leftIn(root + "/sys/fs/cgroup/memory", group,
                                   {"memory.limit_in_bytes", "memory.usage_in_bytes",
                                    "total_inactive_file"}));
  }
  return left;
}

double leftOfAddresses() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return unlimited;
  const double pages = numberIn("/proc/self/statm", 0);
  return static_cast<double>(limit.rlim_cur) -
         pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace

double freeMemory(const std::string& root) {
  const double machine =
      1024 * numberBehind(root + "/proc/meminfo", "MemAvailable:", unlimited);
  const double left = std::min({machine, leftInGroups(root), leftOfAddresses()});
  return std::max(left, 0.0) / mebi;
}

void keepFreedMemory() {
  mallopt(M_MMAP_THRESHOLD, 4 << 20);
  mallopt(M_TRIM_THRESHOLD, 16 << 20);
}

double ownMemory() {
  double pages = 0;
  double resident = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / mebi;
}

double cpuSeconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double secondsSinceStart() {
  std::string line;
  std::getline(std::ifstream("/proc/self/stat"), line);
  // the start time is field 22; field 2 is a name in parentheses and may contain blanks
  std::istringstream numbers(line.substr(line.rfind(')') + 1));
  std::string skipped;
  for (int k = 3; k < 22; ++k)
    numbers >> skipped;
  double ticks = 0;
  timespec now{};
  if (!(numbers >> ticks) || clock_gettime(CLOCK_BOOTTIME, &now) != 0)
    return 0;
  const double start = ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec) -
         start;
}

double peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;  // Linux counts in KiB
}

}  // namespace epafi::drivers
