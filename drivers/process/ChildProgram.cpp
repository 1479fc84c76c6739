#include "drivers/process/ChildProgram.hpp"

#include "bem/base/Error.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace epafi::drivers {

bool runChild(const std::string& program, std::vector<std::string> arguments,
              const std::string& what, const std::string& remedy) {
  arguments.insert(arguments.begin(), program);
  std::vector<char*> words;
  words.reserve(arguments.size() + 1);
  for (std::string& argument : arguments)
    words.push_back(argument.data());
  words.push_back(nullptr);
  pid_t child = 0;
  const int failed =
      posix_spawn(&child, program.c_str(), nullptr, nullptr, words.data(), environ);
  if (failed != 0)
    throw bem::InputError(what, ": '", program,
                          "' cannot be started: ", std::strerror(failed), "; ", remedy);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string besideProgram(const std::string& path) {
  std::error_code ignored;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", ignored);
  return (self.parent_path().parent_path() / path).string();
}

}  // namespace epafi::drivers
