#include "drivers/scene/SceneFile.hpp"

#include "bem/base/Error.hpp"
#include "drivers/scene/LexicalCheck.hpp"
#include "drivers/scene/NestingCheck.hpp"
#include "drivers/scene/Schema.hpp"
#include "drivers/scene/Text.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterEntryXMLConverterDB.hpp>
#include <Teuchos_StringInputSource.hpp>
#include <Teuchos_TwoDArray.hpp>
#include <Teuchos_XMLObject.hpp>
#include <Teuchos_XMLParameterListReader.hpp>
#include <Teuchos_YamlParameterListCoreHelpers.hpp>

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <boost/locale/utf.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::message;
using bem::shortest;

/// What Teuchos complains about, without where in its sources it did.
std::string complaint(const std::exception& error) {
  std::istringstream lines(error.what());
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    const bool noise =
        line.empty() || line.find("packages/teuchos") != std::string::npos ||
        line.rfind("Throw ", 0) == 0 || line == "Error!" || line == "\"" ||
        line.rfind("Lexer text", 0) == 0 || line.rfind("Parser was in state", 0) == 0;
    if (!noise)
      text += (text.empty() ? "" : " ") + line;
  }
  return text;
}

/// Arrays of texts for Teuchos, and back.
void hideNesting(const Teuchos::XMLObject& object) {
  for (int i = 0; i < object.numChildren(); ++i) {
    Teuchos::XMLObject child = object.getChild(i);
    if (child.getTag() == "ParameterList")
      hideNesting(child);
    else if (child.getRequired("type") == "Array(string)")
      child.addAttribute("value", hidden(child.getRequired("value")));
  }
}

void showNesting(Teuchos::ParameterList& list) {
  using Texts = Teuchos::Array<std::string>;
  for (const auto& item : list) {
    Teuchos::ParameterEntry& entry = *list.getEntryPtr(item.first);
    if (entry.isList())
      showNesting(Teuchos::getValue<Teuchos::ParameterList>(entry));
    else if (entry.isType<Texts>())
      for (std::string& text : Teuchos::getValue<Texts>(entry))
        text = shown(text);
  }
}

RawScene readXml(const std::string& text, const std::string& standardTitle) {
  checkNestingOfXml(text);
  Teuchos::XMLObject root;
  try {
    root = Teuchos::StringInputSource(text).getObject();
  } catch (const std::exception& error) {
    throw InputError("malformed XML: " + complaint(error));
  }
  if (root.isEmpty())
    throw InputError("malformed XML: no root element");
  checkLexically(root);
  hideNesting(root);
  try {
    RawScene scene{standardTitle,
                   Teuchos::XMLParameterListReader().toParameterList(root)};
    showNesting(scene.list);
    if (root.hasAttribute("name") && !root.getRequired("name").empty())
      scene.title = root.getRequired("name");
    return scene;
  } catch (const std::exception& error) {
    throw InputError("cannot be read as a list of parameters: " + complaint(error));
  }
}

RawScene readYaml(const std::string& text, const std::string& standardTitle) {
  checkNestingOfYaml(text);
  try {
    const auto list = Teuchos::getParametersFromYamlString(text);
    const std::string name = list->name();
    return {name.empty() || name == "ANONYMOUS" ? standardTitle : name, *list};
  } catch (const std::exception& error) {
    // Two keys at the root end in an assertion about the parser's stack.
    if (std::string(error.what()).find("rhs.at") != std::string::npos)
      throw InputError(
          "malformed YAML: everything must stand under one title, 'My scene:'");
    const bool nested =
        text.find("- [") != std::string::npos || text.find("- - ") != std::string::npos;
    throw InputError(
        "malformed YAML: " + complaint(error) +
        (nested ? "; arrays of arrays stand in brackets, [[0, 0], [1, 0]]" : ""));
  }
}

/// An entry through Teuchos' own reader, so that --set reads what a file would.
Teuchos::ParameterEntry entryOf(const std::string& type, const std::string& value) {
  if (type == "string")
    return Teuchos::ParameterEntry(value);
  Teuchos::XMLObject parameter("Parameter");
  parameter.addAttribute("name", std::string("value"));
  parameter.addAttribute("type", type);
  parameter.addAttribute("value", value);
  Teuchos::XMLObject root("ParameterList");
  root.addChild(parameter);
  return Teuchos::XMLParameterListReader().toParameterList(root).getEntry("value");
}

/// The type and value that an entry has in XML.  Teuchos writes doubles with 18
/// significant digits, alone and in arrays, which is enough to give back every bit.
struct Spelling {
  std::string type;
  std::string value;
};

Spelling spell(const Teuchos::ParameterEntry& entry, const std::string& name) {
  if (entry.isType<double>())
    return {"double", shortest(Teuchos::getValue<double>(entry))};
  if (entry.isType<Teuchos::Array<double>>()) {
    std::string text;
    for (const double x : Teuchos::getValue<Teuchos::Array<double>>(entry))
      text += (text.empty() ? "{" : ", ") + shortest(x);
    return {"Array(double)", text.empty() ? "{}" : text + "}"};
  }
  if (entry.isType<Teuchos::TwoDArray<double>>()) {
    const auto& table = Teuchos::getValue<Teuchos::TwoDArray<double>>(entry);
    std::string text = message(table.getNumRows(), "x", table.getNumCols(), ":{");
    for (int i = 0; i < table.getNumRows(); ++i)
      for (int j = 0; j < table.getNumCols(); ++j)
        text += (i + j == 0 ? "" : ", ") + shortest(table(i, j));
    return {"TwoDArray(double)", text + "}"};
  }
  const auto whole = Teuchos::rcp(new Teuchos::ParameterEntry(entry));
  const Teuchos::XMLObject xml = Teuchos::ParameterEntryXMLConverterDB::convertEntry(
      whole, name, 0, Teuchos::ValidatortoIDMap());
  return {xml.getRequired("type"), xml.getRequired("value")};
}

void collect(const Teuchos::ParameterList& list, const std::string& prefix,
             std::vector<std::string>& result) {
  for (const auto& item : list)
    if (item.second.isList())
      collect(Teuchos::getValue<Teuchos::ParameterList>(item.second),
              prefix + item.first + "->", result);
    else
      result.push_back(prefix + item.first + "=" + spell(item.second, item.first).value);
}

void write(const Teuchos::ParameterList& list, const std::string& name,
           const std::string& indent, std::ostream& out) {
  out << indent << "<ParameterList name=\"" << xmlText(name) << "\">\n";
  const std::string inner = indent + "  ";
  for (const auto& item : list) {
    if (item.second.isList()) {
      write(Teuchos::getValue<Teuchos::ParameterList>(item.second), item.first, inner,
            out);
      continue;
    }
    const Spelling spelling = spell(item.second, item.first);
    out << inner << "<Parameter name=\"" << xmlText(item.first) << "\" type=\""
        << spelling.type << "\" value=\"" << xmlText(spelling.value)
        << (item.second.isDefault() ? "\" isDefault=\"true\"/>\n" : "\"/>\n");
  }
  out << indent << "</ParameterList>\n";
}

}  // namespace

std::string xmlText(std::string text) {
  constexpr std::pair<const char*, const char*> entities[] = {
      {"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}, {"\n", "&#10;"}};
  for (const auto& [sign, entity] : entities)
    boost::algorithm::replace_all(text, sign, entity);
  return text;
}

std::string readText(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (!fs::exists(file, ignored))
    throw InputError("there is no such file");
  if (fs::is_directory(file, ignored))
    throw InputError("is a folder, not a file");
  if (fs::is_character_file(file, ignored) || fs::is_block_file(file, ignored))
    throw InputError("is a device, not a file");  // /dev/zero never ends
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw InputError("cannot be read: ", std::strerror(errno));
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

namespace {

/// \throws bem::InputError at the first byte that is no UTF-8, with its line.
void checkEncoding(const std::string& text) {
  for (auto at = text.begin(); at != text.end();) {
    const auto start = at;
    if (boost::locale::utf::utf_traits<char>::decode(at, text.end()) >
        boost::locale::utf::code_point{0x10FFFF})
      throw InputError("line ", 1 + std::count(text.begin(), start, '\n'),
                       " is not encoded in UTF-8; save the file with the encoding UTF-8");
  }
}

/// Editors of Windows begin files with a mark of the encoding.
std::string withoutMark(const std::string& text) {
  const auto begins = [&](const char* mark) { return text.rfind(mark, 0) == 0; };
  const bool zeros = text.substr(0, 4).find('\0') != std::string::npos;
  if (begins("\xFF\xFE") || begins("\xFE\xFF") || zeros)
    throw InputError(
        "its encoding is UTF-16 or UTF-32; save the file with the encoding UTF-8");
  if (const std::size_t zero = text.find('\0'); zero != std::string::npos)
    throw InputError("byte ", zero, " is zero; a scene is text");
  checkEncoding(text);
  return begins("\xEF\xBB\xBF") ? text.substr(3) : text;
}

}  // namespace

RawScene rawScene(const std::string& marked, const std::string& file) {
  const std::string text = withoutMark(marked);
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    throw InputError("the file is empty");
  const std::filesystem::path path(file);
  const std::string extension =
      boost::algorithm::to_lower_copy(path.extension().string());
  const bool yaml = extension == ".yaml" || extension == ".yml";
  return yaml ? readYaml(text, path.stem().string())
              : readXml(text, path.stem().string());
}

RawScene readSceneText(const std::string& xml) { return readXml(xml, ""); }

RawScene readRawScene(const std::string& file) { return rawScene(readText(file), file); }

namespace {

/// The list that a path stands in; `missing(list, name, path)` where it has no such sublist.
template <class Missing>
Teuchos::ParameterList& parentOf(Teuchos::ParameterList& list, const std::string& path,
                                 const Missing& missing) {
  Teuchos::ParameterList* target = &list;
  std::size_t at = 0;
  for (auto end = path.find("->"); end != std::string::npos; end = path.find("->", at)) {
    const std::string name = path.substr(at, end - at);
    if (!target->isSublist(name))
      missing(*target, name, path.substr(0, end));
    target = &target->sublist(name);
    at = end + 2;
  }
  return *target;
}

/// The same, made if it is not there.
Teuchos::ParameterList& madeParentOf(Teuchos::ParameterList& list,
                                     const std::string& path) {
  return parentOf(list, path, [](const auto& parent, const auto& name, const auto& at) {
    if (parent.isParameter(name))
      throw InputError(at + ": is no sublist in the scene");
  });
}

std::string lastOf(const std::string& path) {
  const auto at = path.rfind("->");
  return at == std::string::npos ? path : path.substr(at + 2);
}

void removeAt(Teuchos::ParameterList& list, const std::string& path) {
  const auto refuse = [&path](const auto&...) {
    throw InputError(path +
                     ": is not in the scene, so it cannot be removed; a value is written "
                     "behind the =");
  };
  Teuchos::ParameterList& parent = parentOf(list, path, refuse);
  if (!parent.isParameter(lastOf(path)))
    refuse();
  parent.remove(lastOf(path));
}

void setAt(Teuchos::ParameterList& list, const std::string& path,
           const std::string& value);

/// "{Key=value, Key=value}" in place of what the list held.
void setList(Teuchos::ParameterList& list, const std::string& path,
             const std::string& value) {
  if (value.front() != '{' || value.back() != '}')
    throw InputError(path +
                     ": is a sublist; name a key in it, or replace the whole by "
                     "{Key=value, Key=value}");
  Teuchos::ParameterList& parent = madeParentOf(list, path);
  parent.remove(lastOf(path), false);
  parent.sublist(lastOf(path));
  for (const std::string& piece : pieces(value.substr(1, value.size() - 2))) {
    if (trimmed(piece).empty())
      continue;
    const auto equal = piece.find('=');
    if (equal == std::string::npos)
      throw InputError(path, ": '", trimmed(piece), "' is no Key=value");
    setAt(list, path + "->" + trimmed(piece.substr(0, equal)), piece.substr(equal + 1));
  }
}

void setAt(Teuchos::ParameterList& list, const std::string& path,
           const std::string& value) {
  const Parameter& row = declared(path);
  if (trimmed(value).empty())
    return removeAt(list, path);
  if (row.kind == Kind::List)
    return setList(list, path, trimmed(value));
  if (row.kind == Kind::Free)
    throw InputError(path + ": is a sublist that --set can only remove");
  const bool alone = value.find('{') == std::string::npos;
  const std::string type = alone && row.kind == Kind::Counts  ? "int"
                           : alone && row.kind == Kind::Reals ? "double"
                                                              : textOf(row.kind).type;
  const std::string text = type == "string" ? value : trimmed(value);
  try {
    checkValue(type, text);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
  madeParentOf(list, path).setEntry(lastOf(path), entryOf(type, text));
}

}  // namespace

void applyOverride(Teuchos::ParameterList& list, const std::string& assignment) {
  const auto equal = assignment.find('=');
  if (equal == std::string::npos)
    throw InputError("--set '", assignment, "': write 'A->B->Key=value'");
  const std::string path = assignment.substr(0, equal);
  const std::string value = assignment.substr(equal + 1);
  try {
    setAt(list, path, value);
  } catch (const InputError& error) {
    throw InputError("--set ", error.what());
  }
}

std::vector<std::string> assignments(const Teuchos::ParameterList& list) {
  std::vector<std::string> result;
  collect(list, "", result);
  return result;
}

std::string toXml(const Teuchos::ParameterList& list, const std::string& title) {
  std::ostringstream out;
  write(list, title, "", out);
  return out.str();
}

}  // namespace epafi::drivers
