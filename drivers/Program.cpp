#include "drivers/Program.hpp"

#include "bem/base/Error.hpp"
#include "drivers/commands/Command.hpp"
#include "drivers/process/ExitCode.hpp"
#include "drivers/process/Ranks.hpp"
#include "drivers/process/Resources.hpp"
#include "drivers/process/Threads.hpp"

#include <iostream>

namespace epafi {

int program(int argc, char* argv[]) {
  drivers::keepFreedMemory();
  drivers::tuneBlas();
  const drivers::Ranks ranks;
  int code = 0;
  const auto failure = ranks.attempt([&] {
    code = drivers::dispatch({argv + 1, argv + argc}, ranks);
    // A full disk behind > must not pass for a whole text.
    if (ranks.isFirst() && code == drivers::Solved && !std::cout.flush())
      throw bem::InputError(
          "what is printed cannot be written: is the disk full, or the output closed?");
  });
  if (!failure)
    return code;
  if (ranks.isFirst())
    drivers::tell(*failure);
  return failure->code;
}

}  // namespace epafi
