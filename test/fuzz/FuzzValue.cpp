// The reading of values.  The first byte chooses a type.  What passes as a number
// is the number that the C library reads, all of it and finite.
#include "bem/base/Error.hpp"
#include "drivers/scene/SceneFile.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace epafi {

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const char* const types[] = {
      "int",          "double",           "bool",          "string",
      "long long",    "Array(int)",       "Array(double)", "Array(string)",
      "unsigned int", "TwoDArray(int)",   "float",         "TwoDArray(double)",
      "Array(bool)",  "TwoDArray(float)", "no such type(", "Array("};
  if (size == 0)
    return 0;
  const std::string type = types[data[0] % (sizeof types / sizeof *types)];
  const std::string value(reinterpret_cast<const char*>(data + 1), size - 1);
  try {
    drivers::readValue(type, value);
  } catch (const bem::InputError&) {
    return 0;
  }
  if (type == "int" || type == "double") {
    char* end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    if (end == value.c_str() || !std::isfinite(number))
      std::abort();
    while (*end == ' ' || *end == '\t' || *end == '\r' || *end == '\n')
      ++end;
    if (end != value.c_str() + value.size())
      std::abort();
  }
  return 0;
}

}  // namespace epafi
