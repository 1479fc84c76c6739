#include "drivers/commands/PlotCommand.hpp"

#include "bem/base/Error.hpp"
#include "drivers/process/Ranks.hpp"

#include <cerrno>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace epafi::drivers {

namespace {

namespace fs = std::filesystem;

// Debian's own: matplotlib belongs to it, whatever else PATH may offer first.
constexpr const char* python = "/usr/bin/python3";

std::string plotProgram() {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  const fs::path program = self.parent_path().parent_path() / "share" / "epafi" / "plot";
  if (!fs::exists(program / "__main__.py", error))
    throw bem::InputError(bem::message("plot: '", program.string(),
                                       "' is missing; it is built and installed along "
                                       "with this program"));
  return program.string();
}

}  // namespace

int drawPictures(const std::string& folder, Words words) {
  std::string interpreter = python;
  std::string program = plotProgram();
  std::string argument = folder;
  std::string quiet = "--quiet";
  char* arguments[] = {interpreter.data(), program.data(), argument.data(),
                       words == Words::Errors ? quiet.data() : nullptr, nullptr};
  std::cout << std::flush;
  pid_t child = 0;
  const int failed = posix_spawn(&child, python, nullptr, nullptr, arguments, environ);
  if (failed != 0)
    throw bem::InputError(bem::message("plot: ", python, " cannot be started: ",
                                       std::strerror(failed), "; install python3"));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? 0 : 1;
}

int plotCommand(const Given& given, std::ostream&, const Ranks& ranks) {
  int code = 0;
  std::exception_ptr problem;
  if (ranks.isFirst()) {
    try {
      code = drawPictures(given.argument, Words::All);
    } catch (...) {
      problem = std::current_exception();
    }
  }
  // the others end as the first does
  code = static_cast<int>(ranks.algebra().broadcast({static_cast<double>(code)}).front());
  if (problem)
    std::rethrow_exception(problem);
  return code;
}

}  // namespace epafi::drivers
