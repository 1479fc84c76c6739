#pragma once

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace epafi::drivers {

/// A scene as it stands in its file: names and types as written, nothing checked against
/// the schema.
struct RawScene {
  std::string title;
  Teuchos::ParameterList list;
};

/// A text as XML has it between quotes.
std::string xmlText(std::string text);

/// \throws bem::InputError for a file that is missing, a folder, a device or not
///   readable; without the file's name.
void checkReadable(const std::string& file);

/// A whole file.  \throws what checkReadable throws.
std::string readText(const std::string& file);

/// Reads XML, or YAML if the file's name ends in .yaml or .yml.  The title is the root
/// list's name, or the file's name without extension if it has none.
/// \throws bem::InputError for a text that is empty or malformed, and for values that do
///   not spell their type; without the file's name.
RawScene rawScene(const std::string& text, const std::string& file);

/// A piece of a scene as the "A->B->Key=value" that would set the same.
std::vector<std::string> assignments(const Teuchos::ParameterList& list);

/// The list as XML that reads back to the same list: numbers keep every bit.
std::string toXml(const Teuchos::ParameterList& list, const std::string& title);

}  // namespace epafi::drivers
