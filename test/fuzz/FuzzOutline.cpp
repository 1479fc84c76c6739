// The Gmsh reader on any text: it reads loops that Outline judges, or throws.
#include "bem/base/Error.hpp"
#include "drivers/scene/GmshOutline.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace epafi {

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const bem::Loops loops =
        drivers::readGmsh(std::string(reinterpret_cast<const char*>(data), size));
    bem::Outline(loops.outer, loops.holes);
  } catch (const bem::InputError&) {
    // what a bad mesh gets
  }
  return 0;
}

}  // namespace epafi
