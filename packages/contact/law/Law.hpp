#pragma once

#include "bem/base/Family.hpp"
#include "bem/base/Function.hpp"
#include "bem/base/Matrix.hpp"
#include "bem/base/SchemaRow.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace epafi::contact {

using bem::Vector;

/// A law in the table of its family.
template <class Law>
struct LawMember {
  std::string name;
  /// Its keys; those of kind Expression are its fields.
  bem::SchemaRows rows;
  /// The law with the other keys' values; an empty function stands for no law.
  std::function<std::shared_ptr<const Law>(const Teuchos::ParameterList&)> make;
};

/// A law on a boundary and its fields as functions of a point, both in the user's units;
/// null: no law.
template <class Law>
struct LawOnBoundary {
  std::shared_ptr<const Law> law;
  std::vector<bem::Function> fields;

  explicit operator bool() const { return law != nullptr; }
  Vector fieldsAt(bem::Vec2 place) const {
    Vector values;
    for (const bem::Function& field : fields)
      values.push_back(field(place));
    return values;
  }
};

/// Makes the function of a key.
using FieldOf = std::function<bem::Function(const std::string& key)>;

}  // namespace epafi::contact
