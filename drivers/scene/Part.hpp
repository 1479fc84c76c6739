#pragma once

#include "bem/base/SchemaRow.hpp"
#include "drivers/scene/Expression.hpp"

#include <Teuchos_ParameterList.hpp>

namespace epafi::drivers {

/// A validated list of a scene: where it stands, and what its expressions know.
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
  /// Does it say anything that is no default?
  bool isGiven() const;
  /// The expression under a key; an empty function if it is not given.
  bem::Function function(const std::string& key) const;
  /// The same, which throws bem::InputError where it is negative.
  bem::Function nonNegative(const std::string& key) const;
  /// The value at this time, or another one, of the expression under a key that is given.
  double number(const std::string& key) const { return number(key, names.t); }
  double number(const std::string& key, double t) const;
  /// The two numbers under a key that is given.  \throws bem::InputError if they are not two
  bem::Vec2 point(const std::string& key) const;
};

}  // namespace epafi::drivers
