#include "bem/base/Error.hpp"
#include "bem/base/Written.hpp"
#include "drivers/scene/SceneFile.hpp"
#include "drivers/scene/Text.hpp"

#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <optional>
#include <sstream>
#include <utility>

namespace epafi::drivers {

namespace {

/// May a text stand as it is, and is it read as the text that it is?
bool isPlain(const std::string& text, bool inArray) {
  static const std::string signs = " _-+*/^().<>=&|?!'";
  static const std::string first = "_(+.";
  const auto isWordSign = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0;
  };
  const bool allowed = std::all_of(text.begin(), text.end(), [&](char c) {
    return isWordSign(c) || signs.find(c) != std::string::npos;
  });
  const bool isMinus = text.size() > 1 && text[0] == '-' && text[1] != ' ';
  if (text.empty() || !allowed || text.front() == ' ' || text.back() == ' ' ||
      !(isWordSign(text[0]) || first.find(text[0]) != std::string::npos || isMinus))
    return false;
  for (const char* other : {"true", "false", "yes", "no", "on", "off", "null"})
    if (std::equal(text.begin(), text.end(), other, other + std::string(other).size(),
                   [](char a, char b) {
                     return std::tolower(static_cast<unsigned char>(a)) == b;
                   }))
      return false;
  // a number is read as an expression where one is wanted, but not as a name in an array
  return !inArray || !numberIn<double>(text);
}

std::string wordOf(const bem::Written& written, const std::string& text, bool inArray) {
  if (!written.isText() || isPlain(text, inArray))
    return text;
  return jsonText(text);
}

/// The same in JSON, where reals show that they are.
std::string jsonWordOf(const bem::Written& written, const std::string& text, bool) {
  if (written.isText())
    return jsonText(text);
  const bool isReal = written.type == "double" && numberIn<long long>(text);
  return isReal ? text + ".0" : text;
}

template <class WordOf>
std::string valueOf(const bem::Written& written, const WordOf& wordOf) {
  using Shape = bem::Written::Shape;
  if (written.shape == Shape::One)
    return wordOf(written, written.texts.front(), false);
  std::ostringstream text;
  const bool isTable = written.shape == Shape::Table;
  const std::size_t columns =
      isTable ? static_cast<std::size_t>(written.columns) : written.texts.size();
  text << (isTable ? "[[" : "[");
  for (std::size_t k = 0; k < written.texts.size(); ++k)
    text << (k == 0             ? ""
             : k % columns == 0 ? "], ["
                                : ", ")
         << wordOf(written, written.texts[k], true);
  text << (isTable ? "]]" : "]");
  return text.str();
}

void write(const Teuchos::ParameterList& list, std::size_t indent, std::ostream& out) {
  const bem::Written name{"string", bem::Written::Shape::One, {}};
  for (const auto& item : list) {
    out << std::string(indent, ' ') << wordOf(name, item.first, true) << ":";
    if (item.second.isList()) {
      const Teuchos::ParameterList& inner = list.sublist(item.first);
      out << (inner.numParams() == 0 ? " {}\n" : "\n");
      write(inner, indent + 2, out);
    } else if (const auto written = bem::writtenIn(item.second)) {
      out << " " << valueOf(*written, wordOf) << "\n";
    }
  }
}

void writeJson(const Teuchos::ParameterList& list, std::ostream& out) {
  const char* before = "{";
  for (const auto& item : list) {
    out << std::exchange(before, ", ") << jsonText(item.first) << ": ";
    if (item.second.isList())
      writeJson(list.sublist(item.first), out);
    else
      out << valueOf(bem::writtenIn(item.second).value(), jsonWordOf);
  }
  out << (list.numParams() == 0 ? "{}" : "}");
}

}  // namespace

std::string toJson(const Teuchos::ParameterList& list, const std::string& title) {
  std::ostringstream out;
  out << "{" << jsonText(title) << ": ";
  writeJson(list, out);
  out << "}\n";
  return out.str();
}

std::string toYaml(const Teuchos::ParameterList& list, const std::string& title) {
  std::ostringstream out;
  out << wordOf({"string", bem::Written::Shape::One, {}}, title, true) << ":\n";
  write(list, 2, out);
  return out.str();
}

}  // namespace epafi::drivers
