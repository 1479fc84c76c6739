#include "drivers/commands/PlotCommand.hpp"

#include "bem/base/Error.hpp"
#include "drivers/commands/FieldsCommand.hpp"
#include "drivers/commands/FirstRank.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace epafi::drivers {

namespace {

namespace fs = std::filesystem;

// Debian's own: matplotlib belongs to it, whatever else PATH may offer first.
constexpr const char* python = "/usr/bin/python3";

std::string plotProgram() {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  const fs::path program =
      self.parent_path().parent_path() / EPAFI_PYTHON / "epafi" / "plot" / "__main__.py";
  if (!fs::exists(program, error))
    throw bem::InputError(bem::message("plot: '", program.string(),
                                       "' is missing; it is built and installed along "
                                       "with this program"));
  return program.string();
}

}  // namespace

int drawPictures(const std::string& folder, Words words, const std::string& field) {
  std::vector<std::string> texts = {python, plotProgram(), folder};
  if (words == Words::Errors)
    texts.emplace_back("--quiet");
  if (!field.empty())
    texts.insert(texts.end(), {"--field", field});
  std::vector<char*> arguments;
  arguments.reserve(texts.size() + 1);
  for (std::string& text : texts)
    arguments.push_back(text.data());
  arguments.push_back(nullptr);
  std::cout << std::flush;
  pid_t child = 0;
  const int failed =
      posix_spawn(&child, python, nullptr, nullptr, arguments.data(), environ);
  if (failed != 0)
    throw bem::InputError(bem::message("plot: ", python, " cannot be started: ",
                                       std::strerror(failed), "; install python3"));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? 0 : 1;
}

int plotCommand(const Given& given, std::ostream&, const Ranks& ranks) {
  return onFirstRank(ranks, [&] {
    if (given.has("--field"))
      writeInside(given.argument);
    return drawPictures(given.argument, Words::All, given.value("--field"));
  });
}

}  // namespace epafi::drivers
