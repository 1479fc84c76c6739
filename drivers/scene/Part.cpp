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

namespace {

/// \throws InputError for a value < 0; `depends`: what it depends on besides x, y and t, asked for only
/// then, since values are asked for at every point and time
template <class Depends>
double checked(double value, const Place& place, const bem::SurfacePoint& x, double t,
               bool orZero, const Depends& depends) {
  if (value < 0 || (value == 0 && !orZero))
    throw InputError(place.file, ": ", place.path, " is ", value, " at (x, y) = (", x.x,
                     ", ", x.y, ")", t == 1 ? "" : bem::message(", t = ", t), depends(),
                     "; it must be ", orZero ? ">=" : ">", " 0 there");
  return value;
}

}  // namespace

bem::Function Part::nonNegative(const std::string& key, bool orZero) const {
  return [function = function(key), place = at(key), t = names.t,
          orZero](const bem::SurfacePoint& x) {
    return checked(function(x), place, x, t, orZero, [] { return ""; });
  };
}

contact::PressureCoefficient Part::ofPressure(const std::string& key) const {
  const auto function =
      makeExpressionOfPressure(list->get<std::string>(key), at(key), names);
  if (!function)
    return {};
  return [function, place = at(key), t = names.t](const bem::SurfacePoint& x,
                                                  double pressure) {
    return checked(function(x, pressure), place, x, t, true,
                   [&] { return bem::message(", pressure = ", pressure); });
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
