#pragma once

#include <string>
#include <vector>

namespace epafi::drivers {

/// The arguments of `epafi run` and `epafi study`.
struct RunOptions {
  std::string scene;    ///< or the study
  std::string output;   ///< empty: defaultOutputFolder
  std::string restart;  ///< folder of the run to go on from; empty: begin anew
  std::vector<std::string> overrides;
  int threads = 0;  ///< 0: all cores, or what the environment says
  bool force = false;
  bool quiet = false;
};

/// Options may stand before or after the scene; values as `--key value` or `--key=value`.
/// \throws bem::InputError for an unknown option, naming the nearest, a missing or
///   superfluous value, and anything but one scene.
RunOptions parseRunOptions(const std::vector<std::string>& arguments);
/// The same without what changes the scene: a study's file says that.
RunOptions parseStudyOptions(const std::vector<std::string>& arguments);

/// What `epafi --help` prints.
std::string usage();

/// \throws bem::InputError always, naming the nearest command.
[[noreturn]] void refuseCommand(const std::string& name);

}  // namespace epafi::drivers
