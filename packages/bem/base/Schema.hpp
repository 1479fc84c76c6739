#pragma once

#include "bem/base/SchemaRow.hpp"
#include "bem/base/Vec2.hpp"

#include <functional>

namespace epafi::bem {

/// The row of a concrete path A->B->Key; in a list that is passed on unchecked, that list's.
/// \throws InputError for an unknown path, naming the nearest known key
const SchemaRow& declared(const SchemaRows& table, const std::string& path);

/// The value of a text that stands for a number at a place.  \throws InputError if it has none
using Constant = std::function<double(const std::string& text, const std::string& place)>;

/// Checks a list and returns it in the order of the table, values converted to the declared
/// type, with all defaults; texts in place of numbers are refused without `constant`.
/// \throws InputError with the path for an unknown or missing key, a wrong type or a value
/// out of range
Teuchos::ParameterList complete(const SchemaRows& table,
                                const Teuchos::ParameterList& given,
                                const std::string& title, const Constant& constant = {});

/// Likewise, in place; the path begins with the list's name.
void complete(const SchemaRows& table, Teuchos::ParameterList& list);

/// The rows as valid parameters of Teuchos, with validators; without those that have no default.
void addValidParameters(const SchemaRows& table, Teuchos::ParameterList& list);

/// The rows of a table of coordinates in a list as points, and the contrary.
std::vector<Vec2> pointsIn(const Teuchos::ParameterList& list, const std::string& key);
void setPoints(Teuchos::ParameterList& list, const std::string& key,
               const std::vector<Vec2>& points);

}  // namespace epafi::bem
