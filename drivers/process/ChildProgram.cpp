#include "drivers/process/ChildProgram.hpp"

#include "bem/base/Error.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace epafi::drivers {

namespace {

namespace fs = std::filesystem;

constexpr const char* remedyOfPython =
    "install python3, or name one with numpy and matplotlib in the variable EPAFI_PYTHON";

/// That of the variable EPAFI_PYTHON, else Debian's, which has numpy and matplotlib; PATH may begin
/// with another one.
std::string python() {
  const char* chosen = std::getenv("EPAFI_PYTHON");
  return chosen != nullptr && *chosen != '\0' ? chosen : "/usr/bin/python3";
}

std::string self() {
  std::error_code ignored;
  return fs::read_symlink("/proc/self/exe", ignored).string();
}

/// What main of a program gets.
std::vector<char*> wordsOf(std::vector<std::string>& arguments) {
  std::vector<char*> words;
  words.reserve(arguments.size() + 1);
  for (std::string& argument : arguments)
    words.push_back(argument.data());
  words.push_back(nullptr);
  return words;
}

[[noreturn]] void refuse(const std::string& what, const std::string& program, int cause,
                         const std::string& remedy) {
  throw bem::InputError(what, ": '", program,
                        "' cannot be started: ", std::strerror(cause), "; ", remedy);
}

/// Its path in the package, which starts this program by the variable EPAFI.
std::string inPackage(const std::string& program, const std::string& what) {
  const std::string path = besideProgram(EPAFI_PYTHON "/epafi/" + program);
  if (!fs::exists(path))
    throw bem::InputError(
        what, ": '", path,
        "' is missing; it is built and installed along with this program");
  setenv("EPAFI", self().c_str(), 1);
  std::cout << std::flush;
  return path;
}

}  // namespace

bool runChild(const std::string& program, std::vector<std::string> arguments,
              const std::string& what, const std::string& remedy) {
  arguments.insert(arguments.begin(), program);
  const std::vector<char*> words = wordsOf(arguments);
  pid_t child = 0;
  const int failed =
      posix_spawn(&child, program.c_str(), nullptr, nullptr, words.data(), environ);
  if (failed != 0)
    refuse(what, program, failed, remedy);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

bool runPackage(const std::string& program, std::vector<std::string> arguments,
                const std::string& what) {
  arguments.insert(arguments.begin(), inPackage(program, what));
  return runChild(python(), std::move(arguments), what, remedyOfPython);
}

void becomePackage(const std::string& program, std::vector<std::string> arguments,
                   const std::string& what) {
  arguments.insert(arguments.begin(), {python(), inPackage(program, what)});
  execv(python().c_str(), wordsOf(arguments).data());
  refuse(what, python(), errno, remedyOfPython);
}

std::string besideProgram(const std::string& path) {
  return (fs::path(self()).parent_path().parent_path() / path).string();
}

}  // namespace epafi::drivers
