#pragma once

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace epafi::drivers {

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

/// Reads XML, or YAML if the name of the file ends in .yaml or .yml.  The title is the
/// name of the root list, by default the name of the file without extension.
/// \throws bem::InputError for an empty or malformed text and for values that do not fit
///   their type; without the name of the file.
RawScene rawScene(const std::string& text, const std::string& file);

/// The list as XML; reading it gives the same list, numbers to the last bit.
std::string toXml(const Teuchos::ParameterList& list, const std::string& title);

}  // namespace epafi::drivers
