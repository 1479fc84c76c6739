#pragma once

#include "bem/base/SchemaRow.hpp"
#include "drivers/scene/Expression.hpp"

#include <Teuchos_ParameterList.hpp>

namespace epafi::drivers {

/// A validated list of a scene, its place, and the names that its expressions may use.
struct Part {
  std::shared_ptr<const Teuchos::ParameterList> list;
  Place place;
  Names names;

  Part sub(const std::string& name) const {
    return {{list, &list->sublist(name)}, at(name), names};
  }
  /// The same at another time.
  Part then(double t) const {
    Part part = *this;
    part.names.t = t;
    return part;
  }
  Place at(const std::string& key) const { return {place.file, path(key)}; }
  std::string path(const std::string& key) const { return bem::join(place.path, key); }

  bool has(const std::string& key) const { return list->isParameter(key); }
  /// Does it contain a value that is not a default?
  bool isGiven() const;
  /// The expression under a key; empty if the key is missing.
  bem::Function function(const std::string& key) const;
  /// The same function; it throws bem::InputError where its value is negative, or zero.
  bem::Function nonNegative(const std::string& key, bool orZero = true) const;
  /// The function under an existing key if it uses `pressure`, else empty; it throws
  /// bem::InputError where its value is negative.
  contact::PressureCoefficient ofPressure(const std::string& key) const;
  /// The value of the expression under an existing key, at this time or at t.
  double number(const std::string& key) const { return number(key, names.t); }
  double number(const std::string& key, double t) const;
  /// The point under an existing key.  \throws bem::InputError unless it has two numbers
  bem::Vec2 point(const std::string& key) const;
};

}  // namespace epafi::drivers
