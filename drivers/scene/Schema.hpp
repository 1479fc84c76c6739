#pragma once

#include "bem/base/Parameters.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace epafi::drivers {

/// What may stand under a key of a scene.
enum class Kind {
  Real,        ///< double; an int is fine
  Whole,       ///< int
  Flag,        ///< bool
  Text,        ///< string
  Expression,  ///< string in x and y; a number is fine
  Names,       ///< Array(string)
  Counts,      ///< Array(int)
  Points,      ///< TwoDArray(double), n x 2; ints are fine
  List,        ///< a sublist with keys of its own
  Free         ///< a sublist that is handed on unread
};

/// The Teuchos type that a kind is kept as: "double", "Array(int)", "ParameterList", ...
std::string typeName(Kind kind);

/// One row of the schema.
///
/// The names in `path` are literal except for <body>, <boundary>, which stand for any
/// name, and <k>, which stands for 1, 2, ...
struct Parameter {
  std::string path;  ///< A->B->Key
  Kind kind = Kind::Text;
  std::string meaning;
  std::string unit;      ///< empty for names and lists
  std::string standard;  ///< the default as one would write it; empty if there is none
  bool required = false;
  /// The key exists only where the sibling key "Type" or "Law" has this value.
  std::string only;
  bem::Interval interval;            ///< of numbers
  std::vector<std::string> allowed;  ///< of strings; empty: any

  std::string parent() const;
  std::string name() const;
  /// "> 0", "'A' or 'B'"; empty if everything of the type is allowed.
  std::string range() const;
};

/// All parameters of a scene.  This table alone feeds validation, defaults, --set, `epafi
/// parameters` and the tests; a new parameter is one line here and its use in
/// SceneReader.
const std::vector<Parameter>& parameters();

/// The row that a concrete path A->B->Key belongs to.
/// \throws bem::InputError for an unknown path, naming the nearest known key.
const Parameter& declared(const std::string& path);

/// The list in the order of the table: checked, numbers turned into the declared type,
/// every default filled in. \throws bem::InputError with the path for an unknown or
/// missing key, a wrong type, a value
///   out of range.
Teuchos::ParameterList complete(const std::vector<Parameter>& table,
                                const Teuchos::ParameterList& given,
                                const std::string& title);
/// The same by the table of scenes.
Teuchos::ParameterList complete(const Teuchos::ParameterList& given,
                                const std::string& title);

}  // namespace epafi::drivers
