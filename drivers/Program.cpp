#include "drivers/Program.hpp"

#include "drivers/commands/CommandTable.hpp"
#include "drivers/process/Ranks.hpp"
#include "drivers/process/Resources.hpp"
#include "drivers/process/Threads.hpp"

namespace epafi {

int program(int argc, char* argv[]) {
  drivers::keepFreedMemory();
  drivers::tuneBlas();
  const drivers::Ranks ranks;
  int code = 0;
  const auto failure = ranks.attempt([&] {
    code = drivers::dispatch({argv + 1, argv + argc}, ranks);
  });
  if (!failure)
    return code;
  if (ranks.isFirst())
    drivers::tell(*failure);
  return failure->code;
}

}  // namespace epafi
