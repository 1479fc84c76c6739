#pragma once

#include "bem/base/Schema.hpp"
#include "bem/base/Suggestion.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>

namespace Teuchos {
class XMLObject;
}

namespace epafi::drivers {

using Parameter = bem::SchemaRow;
using bem::Kind;
using bem::textOf;

/// All parameters of a scene.  Only this table defines validation, defaults, --set and
/// `epafi parameters`; the tests use it, too.  It is made on first use, when all families
/// are complete.
const bem::SchemaRows& parameters();

/// A scene as in its file, not yet checked against the schema.
struct RawScene {
  std::string title;
  Teuchos::ParameterList list;
};

/// A text escaped for an attribute of XML.
std::string xmlText(std::string text);

/// \throws bem::InputError for a file that is missing, a folder, a device or not
///   readable; without the name of the file.
void checkReadable(const std::string& file);

/// The content of a file without a byte order mark.  \throws as checkReadable, and for UTF-16.
std::string readText(const std::string& file);

/// The path of a file that a scene names, relative to the scene's own.
/// \throws bem::InputError in the used.xml of a run, which may be somebody else's: all of
///   its scene stands in it.
std::string namedFile(const std::string& name, const std::string& scene);

/// Reads XML, or YAML if the name of the file ends in .yaml or .yml.  The title is the
/// name of the root list, by default the name of the file without extension.
/// \throws bem::InputError for an empty or malformed text and for values that do not fit
///   their type; without the name of the file.
RawScene rawScene(const std::string& text, const std::string& file);

/// The list in a YAML text, which may use anchors, `<<` and multi-line lists.
///
/// A value in quotes is a string.  Other values get the narrowest type that fits: int,
/// double, bool, string; an array has the type that fits all entries; an array of arrays
/// is a table.  A key without a value is an empty list.
/// \throws bem::InputError with line and column for invalid YAML, for a document that is
///   not a tree of lists under one title, and for a nesting deeper than about 250.
RawScene readYaml(const std::string& text);

/// Reads an XML list and checks tags, names (given, unique), types and values.
/// \throws bem::InputError with the path A->B->Key; without the file.
Teuchos::ParameterList readList(const Teuchos::XMLObject& root);

/// Converts a text to a value of a Teuchos type.  The whole text must be valid and in
/// range.
///
/// Types: int, double, bool, string; Array(T) as {a, b, c}; TwoDArray(T) as RxC:{row by
/// row}, T not bool.
/// \throws bem::InputError with the error and the valid form, without file and path.
Teuchos::ParameterEntry readValue(const std::string& type, const std::string& value);

/// Applies one "A->B->Key=value" of --set: the first '=' separates, with or without
/// blanks, and the schema declares the type of the value; in a list that is passed on unchecked
/// it is the narrowest one, as in YAML.
///
/// "{Key=value, Key=value}" replaces a whole list, lists in it likewise; an empty value
/// removes a key or a list.
/// \throws bem::InputError for an undeclared path, a removed key, a value of another
///   type, or if there is nothing to remove.
void applyOverride(Teuchos::ParameterList& list, const std::string& assignment);

/// The list as XML; reading it gives the same list, numbers to the last bit.
std::string toXml(const Teuchos::ParameterList& list, const std::string& title);
/// The same as JSON, which is YAML, too: every text in quotes, reals with a point or an exponent.
std::string toJson(const Teuchos::ParameterList& list, const std::string& title);
/// The same as YAML for readers.
std::string toYaml(const Teuchos::ParameterList& list, const std::string& title);

}  // namespace epafi::drivers
