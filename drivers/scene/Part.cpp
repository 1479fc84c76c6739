#include "drivers/scene/Part.hpp"

#include "bem/base/Error.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>

namespace epafi::drivers {

using bem::InputError;

bool Part::isGiven() const {
  return std::any_of(list->begin(), list->end(),
                     [](const auto& item) { return !item.second.isDefault(); });
}

bem::Function Part::function(const std::string& key) const {
  return has(key) ? makeExpression(list->get<std::string>(key), at(key), names)
                  : bem::Function();
}

bem::Function Part::nonNegative(const std::string& key, bool orZero) const {
  return [function = function(key), place = at(key), t = names.t,
          orZero](const bem::SurfacePoint& x) {
    const double value = function(x);
    if (value < 0 || (value == 0 && !orZero))
      throw InputError(place.file, ": ", place.path, " is ", value, " at (x, y) = (", x.x,
                       ", ", x.y, ")", t == 1 ? "" : bem::message(", t = ", t),
                       "; it must be ", orZero ? ">=" : ">", " 0 there");
    return value;
  };
}

double Part::number(const std::string& key, double t) const {
  return makeExpression(list->get<std::string>(key), at(key), then(t).names,
                        Form::OfTime)({});
}

bem::Vec2 Part::point(const std::string& key) const {
  const auto& numbers = list->get<Teuchos::Array<double>>(key);
  if (numbers.size() != 2)
    throw InputError(path(key), ": has ", numbers.size(), " numbers; a point has two");
  return {numbers[0], numbers[1]};
}

}  // namespace epafi::drivers
