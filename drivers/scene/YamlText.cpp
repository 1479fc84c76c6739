#include "drivers/scene/YamlText.hpp"

#include "bem/base/Error.hpp"
#include "drivers/scene/Text.hpp"

#include <Teuchos_XMLObject.hpp>

#include <algorithm>
#include <sstream>
#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/yaml.h>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::message;
using Teuchos::XMLObject;

constexpr int deepest = 250;  // limit of yaml-cpp, which recurses twice for each level
constexpr const char* tooDeep =
    "lists stand in lists too deep for YAML, some 250 of them";
constexpr long mostValues = 1000000;

std::string at(const YAML::Mark& mark) {
  return message("line ", mark.line + 1, ", column ", mark.column + 1);
}

/// Types from narrow to wide; Real includes Whole, and Text includes all.
enum class Type { Whole, Real, Flag, Text };

const char* nameOf(Type type) {
  constexpr const char* names[] = {"int", "double", "bool", "string"};
  return names[static_cast<int>(type)];
}

Type typeOf(const YAML::Node& scalar) {
  const std::string& text = scalar.Scalar();
  const bool plain = scalar.Tag() == "?";
  if (!plain)
    return Type::Text;
  const std::string unsignedText = text.substr(text.find_first_of("+-") == 0 ? 1 : 0);
  if (numberIn<int>(unsignedText))
    return Type::Whole;
  // includes numbers out of range, for which readValue has a better message
  if (unsignedText.find_first_of(".0123456789") == 0 &&
      text.find_first_not_of("0123456789+-.eE") == std::string::npos)
    return Type::Real;
  return text == "true" || text == "false" ? Type::Flag : Type::Text;
}

Type joined(Type a, Type b) {
  return a == b ? a : std::max(a, b) == Type::Real ? Type::Real : Type::Text;
}

/// Checks brackets: in a list YAML ends unquoted text at a comma, also in max(x, 0).
void checkWhole(const YAML::Node& scalar) {
  if (scalar.Tag() == "?" && !isBalanced(scalar.Scalar()))
    throw InputError(at(scalar.Mark()), ": '", scalar.Scalar(),
                     "' has brackets that are not in pairs; a text with a comma, as in "
                     "\"max(x, 0)\", needs quotes");
}

/// Converts one document to XML.
class Spelling {
 public:
  XMLObject list(const std::string& name, const YAML::Node& node, int depth = 0) {
    if (depth > deepest)  // an anchor may contain itself
      throw InputError(tooDeep);
    XMLObject result("ParameterList");
    result.addAttribute("name", name);
    for (const auto& [key, value] : entries(node))
      result.addChild(value.IsMap() || value.IsNull() ? list(key, value, depth + 1)
                                                      : parameter(key, value));
    return result;
  }

 private:
  using Entries = std::vector<std::pair<std::string, YAML::Node>>;

  /// The entries of a list; own keys come first and hide those that `<<` merges.
  Entries entries(const YAML::Node& map) {
    Entries own;
    Entries merged;
    for (const auto& item : map) {
      count(item.first);
      if (!item.first.IsScalar())
        throw InputError(at(item.first.Mark()), ": a key must be a word or a text");
      checkWhole(item.second.IsScalar() ? item.second : item.first);
      if (item.second.IsNull() &&
          item.first.Scalar().find_first_not_of("0123456789") == std::string::npos)
        throw InputError(at(item.first.Mark()), ": '", item.first.Scalar(),
                         "' behind a comma is no key; a number is written with a point, "
                         "0.002, and without separators of thousands");
      if (item.first.Scalar() != "<<") {
        own.emplace_back(item.first.Scalar(), item.second);
        continue;
      }
      if (!item.second.IsMap())
        throw InputError(at(item.first.Mark()), ": '<<' wants another list, *name");
      for (auto& entry : entries(item.second))
        merged.push_back(std::move(entry));
    }
    for (auto& entry : merged)
      if (std::none_of(own.begin(), own.end(),
                       [&](const auto& other) { return other.first == entry.first; }))
        own.push_back(std::move(entry));
    return own;
  }

  XMLObject parameter(const std::string& name, const YAML::Node& node) {
    XMLObject result("Parameter");
    result.addAttribute("name", name);
    within(message(name, " (", at(node.Mark()), "): "), [&] {
      const auto [type, text] = node.IsScalar() ? scalar(node)
                                : isTable(node) ? table(node)
                                                : array(node);
      result.addAttribute("type", type);
      result.addAttribute("value", text);
    });
    return result;
  }

  using Spelled = std::pair<std::string, std::string>;  // type and value

  Spelled scalar(const YAML::Node& node) {
    count(node);
    return {nameOf(typeOf(node)), node.Scalar()};
  }

  static bool isTable(const YAML::Node& node) {
    return node.size() > 0 && node.begin()->IsSequence();
  }

  /// The entries of an array, separated by commas; widens `type` to include theirs.
  std::string row(const YAML::Node& array, Type& type, bool& first) {
    std::string text;
    for (const YAML::Node& entry : array) {
      if (!entry.IsScalar())
        throw InputError("an array holds numbers or texts, or arrays of as many numbers");
      checkWhole(entry);
      count(entry);
      type = first ? typeOf(entry) : joined(type, typeOf(entry));
      first = false;
      text += (text.empty() ? "" : ", ") + hiddenEntry(entry.Scalar());
    }
    return text;
  }

  Spelled array(const YAML::Node& node) {
    Type type = Type::Text;
    bool first = true;
    const std::string text = row(node, type, first);
    return {message("Array(", nameOf(type), ")"), "{" + text + "}"};
  }

  Spelled table(const YAML::Node& node) {
    Type type = Type::Text;
    bool first = true;
    std::string text;
    const std::size_t columns = node.begin()->size();
    std::size_t rows = 0;
    for (const YAML::Node& entry : node) {
      if (entry.IsSequence())
        for (const YAML::Node& cell : entry)
          if (cell.IsScalar())
            checkWhole(cell);
      if (!entry.IsSequence() || entry.size() != columns)
        throw InputError(
            "entry ", rows, " is no array of ", columns,
            " numbers, as the first one is; a text with a comma needs quotes");
      text += (rows++ == 0 ? "" : ", ") + row(entry, type, first);
    }
    return {message("TwoDArray(", nameOf(type), ")"),
            message(rows, "x", columns, ":{", text, "}")};
  }

  void count(const YAML::Node& node) {
    if (++values_ > mostValues)
      throw InputError(at(node.Mark()), ": more than ", mostValues,
                       " values, those that anchors repeat included");
  }

  long values_ = 0;
};

/// Advice for an error of the parser.
std::string advice(const std::string& text, const YAML::Exception& error) {
  std::istringstream lines(text);
  std::string line;
  for (int i = 0; i <= error.mark.line; ++i)
    std::getline(lines, line);
  if (line.substr(0, line.find_first_not_of(" \t")).find('\t') != std::string::npos)
    return "; indent by blanks, not by tabs";
  const bool isUnfinished = error.msg.rfind("end of ", 0) == 0;
  return isUnfinished ? "; a bracket, a brace or a comma is missing, or a text in "
                        "brackets that has a comma needs quotes"
                      : "; put quotes round a text with ': ' or ' #' in it, or one that "
                        "begins with * & ! | > % @ ? - [ or {";
}

YAML::Node documentIn(const std::string& text) {
  try {
    // Not LoadAll: it does not return for a text that begins with a comma.
    YAML::Node document = YAML::Load(text);
    const std::size_t begin = document.IsMap() ? document.Mark().pos : 0;
    if (text.find("\n---", begin) != std::string::npos)
      throw InputError("malformed YAML: holds several documents (---); a scene is one");
    return document;
  } catch (const YAML::DeepRecursion&) {
    throw InputError(tooDeep);
  } catch (const YAML::Exception& error) {
    throw InputError("malformed YAML: ", at(error.mark), ": ", error.msg,
                     advice(text, error));
  }
}

}  // namespace

XMLObject xmlOfYaml(const std::string& text) {
  const YAML::Node document = documentIn(text);
  if (!document.IsMap() || document.size() != 1 || !document.begin()->first.IsScalar() ||
      !document.begin()->second.IsMap())
    throw InputError(
        "malformed YAML: everything must stand under one title, 'My scene:'");
  return Spelling().list(document.begin()->first.Scalar(), document.begin()->second);
}

}  // namespace epafi::drivers
