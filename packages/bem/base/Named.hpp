#pragma once

#include "bem/base/Error.hpp"

#include <string>
#include <vector>

namespace epafi::bem {

/// A row of a table of names of the values of an enumeration.
template <class Enum>
struct Named {
  const char* name;
  Enum value;
};

template <class Enum, std::size_t N>
std::vector<std::string> namesOf(const Named<Enum> (&table)[N]) {
  std::vector<std::string> names;
  for (const Named<Enum>& row : table)
    names.push_back(row.name);
  return names;
}

template <class Enum, std::size_t N>
std::string nameOf(const Named<Enum> (&table)[N], Enum value) {
  for (const Named<Enum>& row : table)
    if (value == row.value)
      return row.name;
  return "";
}

/// The value of a name.  \throws InputError if the table has no such name
template <class Enum, std::size_t N>
Enum named(const Named<Enum> (&table)[N], const std::string& name) {
  for (const Named<Enum>& row : table)
    if (name == row.name)
      return row.value;
  throw InputError("'", name, "' is none of the words for it");
}

}  // namespace epafi::bem
