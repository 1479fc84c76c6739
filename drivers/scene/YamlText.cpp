#include "bem/base/Error.hpp"
#include "bem/base/SchemaRow.hpp"
#include "bem/base/Written.hpp"
#include "drivers/scene/SceneFile.hpp"
#include "drivers/scene/Text.hpp"

#include <algorithm>
#include <sstream>
#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/yaml.h>

namespace epafi::drivers {

namespace {

using bem::entryOf;
using bem::InputError;
using bem::message;
using bem::Written;
using Teuchos::ParameterList;

constexpr int deepest = 250;  // limit of yaml-cpp, which recurses twice for each level
constexpr const char* tooDeep =
    "lists stand in lists too deep for YAML, some 250 of them";
constexpr long mostValues = 1000000;

std::string at(const YAML::Mark& mark) {
  return message("line ", mark.line + 1, ", column ", mark.column + 1);
}

std::string typeOf(const YAML::Node& scalar) {
  const bool plain = scalar.Tag() == "?";
  return plain ? narrowestType(scalar.Scalar()) : "string";
}

/// The narrowest type of two values together.
std::string joined(const Written& value, const std::string& type) {
  if (value.texts.empty() || value.type == type)
    return type;
  return value.isNumber() && (type == "int" || type == "double") ? "double" : "string";
}

/// Checks brackets: in a list YAML ends unquoted text at a comma, also in max(x, 0).
void checkWhole(const YAML::Node& scalar) {
  if (scalar.Tag() == "?" && !isBalanced(scalar.Scalar()))
    throw InputError(at(scalar.Mark()), ": '", scalar.Scalar(),
                     "' has brackets that are not in pairs; a text with a comma, as in "
                     "\"max(x, 0)\", needs quotes");
}

/// Converts the lists of one document.
class Reader {
 public:
  void read(const YAML::Node& map, const std::string& path, ParameterList& list,
            int depth = 0) {
    for (const auto& [key, value] : entries(map, depth)) {
      const std::string inner = bem::join(path, key);
      if (list.isParameter(key))
        throw InputError(inner + ": given twice; keep one");
      if (value.IsMap() || value.IsNull())
        read(value, inner, list.sublist(key), depth + 1);
      else
        list.setEntry(key, within(message(inner, " (", at(value.Mark()), "): "),
                                  [&, &node = value] { return valueOf(node); }));
    }
  }

 private:
  using Entries = std::vector<std::pair<std::string, YAML::Node>>;

  /// The entries of a list; own keys come first and hide those that `<<` merges.
  Entries entries(const YAML::Node& map, int depth) {
    if (depth > deepest)  // an anchor may contain itself
      throw InputError(tooDeep);
    Entries own;
    Entries merged;
    for (const auto& item : map) {
      count(item.first);
      if (!item.first.IsScalar())
        throw InputError(at(item.first.Mark()), ": a key must be a word or a text");
      if (item.first.Scalar().empty())
        throw InputError(at(item.first.Mark()), ": a key is empty; it must be a word");
      checkWhole(item.second.IsScalar() ? item.second : item.first);
      if (item.second.IsNull() &&
          item.first.Scalar().find_first_not_of("0123456789") == std::string::npos)
        throw InputError(
            at(item.first.Mark()), ": '", item.first.Scalar(),
            "' after a comma is not a key; a number is written with a point, "
            "0.002, and without separators of thousands");
      if (item.first.Scalar() != "<<") {
        own.emplace_back(item.first.Scalar(), item.second);
        continue;
      }
      if (!item.second.IsMap())
        throw InputError(at(item.first.Mark()), ": '<<' wants another list, *name");
      for (auto& entry : entries(item.second, depth + 1))
        merged.push_back(std::move(entry));
    }
    for (auto& entry : merged)
      if (std::none_of(own.begin(), own.end(),
                       [&](const auto& other) { return other.first == entry.first; }))
        own.push_back(std::move(entry));
    return own;
  }

  Teuchos::ParameterEntry valueOf(const YAML::Node& node) {
    using Shape = Written::Shape;
    if (node.IsScalar()) {
      count(node);
      return entryOf({typeOf(node), Shape::One, {node.Scalar()}});
    }
    Written written{"string", Shape::Array, {}, 0, 0};
    if (node.size() == 0 || !node.begin()->IsSequence()) {
      addRow(node, written);
    } else {
      written.shape = Shape::Table;
      written.columns = static_cast<int>(node.begin()->size());
      for (const YAML::Node& row : node)
        addRow(row, written);
    }
    return entryOf(written);
  }

  /// Adds the entries of an array or a row, and widens the type to include theirs.
  void addRow(const YAML::Node& array, Written& written) {
    if (array.IsSequence())
      for (const YAML::Node& entry : array)
        if (entry.IsScalar())
          checkWhole(entry);
    const bool isRow = written.shape == Written::Shape::Table;
    if (isRow && (!array.IsSequence() ||
                  array.size() != static_cast<std::size_t>(written.columns)))
      throw InputError("entry ", written.rows, " is not an array of ", written.columns,
                       " numbers, as the first one is; a text with a comma needs quotes");
    ++written.rows;
    for (const YAML::Node& entry : array) {
      if (!entry.IsScalar())
        throw InputError("an array holds numbers or texts, or arrays of as many numbers",
                         entry.IsMap() ? "; a text with ': ' in it needs quotes" : "");
      count(entry);
      written.type = joined(written, typeOf(entry));
      written.texts.push_back(trimmed(entry.Scalar()));
      if (written.texts.back().empty())
        throw InputError("entry ", written.texts.size() - 1, " of the array is empty");
    }
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
  if (error.msg == "end of map not found" || error.msg == "end of sequence not found")
    return "; what belongs to one list begins in one column, with as many blanks before "
           "it";
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

RawScene readYaml(const std::string& text) {
  const YAML::Node document = documentIn(text);
  if (!document.IsMap() || document.size() != 1 || !document.begin()->first.IsScalar() ||
      !document.begin()->second.IsMap() || document.begin()->first.Scalar() == "Bodies")
    throw InputError(
        "malformed YAML: everything must stand under one title, 'My scene:'");
  RawScene scene{document.begin()->first.Scalar(), {}};
  Reader().read(document.begin()->second, "", scene.list);
  return scene;
}

}  // namespace epafi::drivers
