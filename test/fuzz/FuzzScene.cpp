// The scene reader on any text, XML or YAML: it reads it or throws an InputError.
#include "bem/base/Error.hpp"
#include "drivers/scene/SceneReader.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace epafi {

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const bool xml = text.find('<') != std::string::npos;
  try {
    const drivers::Scene scene = drivers::sceneOf(text, xml ? "f.xml" : "f.yaml");
    // What is read can be written and read again, to the same bits.
    const std::string used = drivers::usedXml(scene);
    if (drivers::usedXml(drivers::sceneOf(used, "used.xml")) != used)
      std::abort();
  } catch (const bem::InputError& error) {
    if (std::string(error.what()).empty())
      std::abort();
  }
  return 0;
}

}  // namespace epafi
