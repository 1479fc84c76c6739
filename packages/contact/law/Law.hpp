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

/// Entry of a registry of laws.
template <class Law>
struct LawMember {
  std::string name;
  /// Its keys; those of kind Expression are fields, see LawOnBoundary.
  bem::SchemaRows rows;
  /// Makes the law from the values of the other keys; empty: no law.
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

/// The function of a point that the value of a key stands for.
using FieldOf = std::function<bem::Function(const std::string& key)>;

}  // namespace epafi::contact
