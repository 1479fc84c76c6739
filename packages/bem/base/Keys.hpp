#pragma once

#include "bem/base/Family.hpp"
#include "bem/base/Named.hpp"
#include "bem/base/Schema.hpp"
#include "bem/base/Vec2.hpp"

#include <optional>
#include <variant>

namespace epafi::bem {

/// Visitor of the keys of a list, each of which sets a member of a struct of options:
///
///   void Options::keys(Keys& keys) { keys.add(&size, "Size", "length", above(0), "of a part"); }
///
/// is all there is to say of a key: rowsOf<Options>() and parsed<Options>(list) follow from it.
/// The default is what the member holds before.
class Keys {
 public:
  /// Collects rows and, with a list that they have completed, reads it.
  explicit Keys(const Teuchos::ParameterList* list = nullptr) : list_(list) {}

  /// An optional number has no default, and stays empty where one is told that depends on others.
  using Value = std::variant<double*, int*, bool*, std::optional<double>*,
                             std::optional<int>*, std::vector<Vec2>*>;
  void add(Value value, const std::string& name, const std::string& unit,
           const Interval& range, const std::string& meaning,
           const std::string& told = "");
  void add(std::string* value, const std::string& name,
           const std::vector<std::string>& allowed, const std::string& meaning);
  /// The name of a member of a family, whose meanings follow that of the key.
  template <class Member>
  void add(std::string* value, const std::string& name, const Family<Member>& family,
           const std::string& meaning) {
    add(value, name, family.names(), meaning + meanings(family));
  }
  /// A value that has a name.
  template <class Enum, std::size_t N>
  void add(Enum* value, const std::string& name, const Named<Enum> (&table)[N],
           const std::string& meaning) {
    std::string text = nameOf(table, *value);
    add(&text, name, namesOf(table), meaning);
    *value = named(table, text);
  }
  /// A list of its own.
  template <class Options>
  void add(Options* options, const SchemaRow& list) {
    Keys inner(sublist(list.path));
    options->keys(inner);
    append(rows, {list});
    append(rows, inner.rows, list.path);
  }

  SchemaRows rows;

 private:
  const Teuchos::ParameterList* sublist(const std::string& name) const;

  const Teuchos::ParameterList* list_;
};

template <class Options>
SchemaRows rowsOf() {
  Options options;
  Keys keys;
  options.keys(keys);
  return std::move(keys.rows);
}

/// What a list that rowsOf<Options>() have completed says.
template <class Options>
Options parsed(const Teuchos::ParameterList& list) {
  Options options;
  Keys keys(&list);
  options.keys(keys);
  return options;
}

/// Sets options as a list says, and completes it by what they were.
/// \throws InputError as complete(); the path begins with the list's name
template <class Options>
void accept(Options& options, Teuchos::ParameterList& list) {
  Keys declared;
  options.keys(declared);
  complete(declared.rows, list);
  Keys keys(&list);
  options.keys(keys);
}

}  // namespace epafi::bem
