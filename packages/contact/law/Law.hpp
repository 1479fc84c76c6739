#pragma once

#include "bem/base/Family.hpp"
#include "bem/base/Function.hpp"
#include "bem/base/Matrix.hpp"
#include "bem/base/SchemaRow.hpp"

#include <algorithm>
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
  Vector fieldsAt(const bem::SurfacePoint& place) const {
    Vector values;
    for (const bem::Function& field : fields)
      values.push_back(field(place));
    return values;
  }
};

/// The function of a point that the value of a key stands for.
using FieldOf = std::function<bem::Function(const std::string& key)>;

// Common functions of the tables of laws.

inline bool isField(const bem::SchemaRow& row) {
  return row.kind == bem::Kind::Expression;
}

/// Table entry of a law whose parameters are all fields.
template <class Law, class Own>
LawMember<Law> lawOfFields(const char* name) {
  return {name, Own::rows(),
          [](const Teuchos::ParameterList&) { return std::make_shared<const Own>(); }};
}

/// Rows: Law, and the keys of each law.
template <class Law>
bem::SchemaRows lawRows(const bem::Family<LawMember<Law>>& laws, const char* meaning) {
  bem::SchemaRows table = {bem::Row("Law", bem::Kind::Text, meaning)
                               .defaultValue(laws.front().name)
                               .allowed(laws.names())};
  for (const LawMember<Law>& law : laws) {
    bem::SchemaRows rows = law.rows;
    for (bem::SchemaRow& row : rows)
      row.only = {law.name};
    append(table, rows);
  }
  return table;
}

/// `none`: a list without keys.
template <class Law>
LawOnBoundary<Law> makeLaw(const bem::Family<LawMember<Law>>& laws, const char* kind,
                           const std::string& name, std::vector<bem::Function> fields,
                           const Teuchos::ParameterList& none) {
  const LawMember<Law>& entry = laws.at(name);
  const auto wanted = std::count_if(entry.rows.begin(), entry.rows.end(), isField);
  if (static_cast<std::size_t>(wanted) != fields.size() ||
      entry.rows.size() != fields.size())
    throw bem::InputError(kind, " '", name, "' has ", wanted, " fields and ",
                          entry.rows.size() - static_cast<std::size_t>(wanted),
                          " other keys; ", fields.size(), " fields are given");
  return {entry.make ? entry.make(none) : nullptr, std::move(fields)};
}

/// `name`: what the list has under Law.
template <class Law>
LawOnBoundary<Law> parseLaw(const bem::Family<LawMember<Law>>& laws,
                            const std::string& name, const Teuchos::ParameterList& list,
                            const FieldOf& field) {
  const LawMember<Law>& entry = laws.at(name);
  LawOnBoundary<Law> result;
  if (!entry.make)
    return result;
  result.law = entry.make(list);
  for (const bem::SchemaRow& row : entry.rows)
    if (isField(row))
      result.fields.push_back(field(row.name()));
  return result;
}

}  // namespace epafi::contact
