// The readers of outlines on any bytes: they read loops that Outline judges, or throw.
#include "bem/base/Error.hpp"
#include "drivers/scene/OutlineChain.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace epafi {

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  for (const auto read : {drivers::readGmsh, drivers::readDxf})
    try {
      const bem::Loops loops = read(text, {});
      bem::Outline(loops.outer, loops.holes);
    } catch (const bem::InputError&) {
      // what a bad file gets
    }
  return 0;
}

}  // namespace epafi
