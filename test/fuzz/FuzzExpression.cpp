// Expressions of any text: a finite number at every point, or an InputError.
#include "bem/base/Error.hpp"
#include "drivers/scene/Expression.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace epafi {

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const bem::Function function = drivers::makeExpression(text, {"f.xml", "A->B"});
    for (const bem::Vec2 point : {bem::Vec2{0, 0}, bem::Vec2{-0.5, 2}, bem::Vec2{1e3, 7}})
      if (!std::isfinite(function({point.x, point.y, {}})))
        std::abort();
  } catch (const bem::InputError&) {
    // what a bad expression gets
  }
  return 0;
}

}  // namespace epafi
