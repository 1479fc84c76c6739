#include "drivers/scene/SceneFile.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/SchemaRow.hpp"
#include "bem/base/Suggestion.hpp"
#include "bem/base/Written.hpp"
#include "drivers/scene/Text.hpp"

#include <Teuchos_StringInputSource.hpp>
#include <Teuchos_XMLObject.hpp>

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace epafi::drivers {

namespace {

using bem::entryOf;
using bem::InputError;
using bem::Written;
using Teuchos::ParameterEntry;
using Teuchos::ParameterList;
using Teuchos::XMLObject;

/// {a, b, c}
Written arrayIn(const std::string& text, const std::string& type) {
  if (text.size() < 2 || text.front() != '{' || text.back() != '}')
    throw InputError("'", text, "' is not an array; write {a, b, c}");
  const std::string inner = trimmed(text.substr(1, text.size() - 2));
  Written array{type, Written::Shape::Array, {}};
  if (inner.empty())
    return array;
  for (const std::string& piece : pieces(inner)) {
    const std::string entry = trimmed(piece);
    const bool brace = entry.find_first_of("{}") != std::string::npos;
    if (entry.empty() || (brace && !(array.isText() && isBalanced(entry))))  // A={4, 4}
      throw InputError("entry ", array.texts.size(), " = '", entry,
                       "' of the array is empty or holds a brace; write {a, b, c}");
    array.texts.push_back(entry);
  }
  return array;
}

/// RxC:{a, b, ...}
Written tableIn(const std::string& text, const std::string& type) {
  const std::string size = text.substr(0, text.find(':'));
  const std::string rows = size.substr(0, size.find('x'));
  const std::string columns = size.substr(std::min(rows.size() + 1, size.size()));
  for (const std::string& count : {rows, columns})
    if (count.empty() || count.find_first_not_of("0123456789") != std::string::npos ||
        size.size() == text.size())
      throw InputError("'", text, "' is not a table; write 4x2:{a, b, ...}, row by row");
  Written table = arrayIn(trimmed(text.substr(size.size() + 1)), type);
  table.shape = Written::Shape::Table;
  table.rows = bem::wholeIn(rows);
  table.columns = bem::wholeIn(columns);
  const std::size_t wanted = static_cast<std::size_t>(table.rows) * table.columns;
  if (table.texts.size() != wanted)
    throw InputError("a table ", size, " has ", wanted, " entries; ", table.texts.size(),
                     " are given");
  return table;
}

std::string nameOf(const XMLObject& object, const std::string& path) {
  if (!object.hasAttribute("name") || object.getRequired("name").empty())
    throw InputError(path.empty() ? "" : path + ": ", "a ", object.getTag(),
                     " has no name; write <", object.getTag(), " name=\"...\"");
  return object.getRequired("name");
}

ParameterEntry parameterOf(const XMLObject& object) {
  if (!object.hasAttribute("type"))
    throw InputError("has no type; write type=\"double\" or what fits");
  if (!object.hasAttribute("value"))
    throw InputError("has no value; write value=\"...\"");
  if (object.numChildren() > 0)
    throw InputError("is a Parameter and cannot hold others; use ParameterList");
  ParameterEntry entry =
      readValue(object.getRequired("type"), object.getRequired("value"));
  if (object.hasAttribute("isDefault"))
    entry.setAnyValue(
        Teuchos::any(entry.getAny(false)),
        Teuchos::getValue<bool>(readValue("bool", object.getRequired("isDefault"))));
  return entry;
}

void readInto(ParameterList& result, const XMLObject& list, const std::string& path) {
  const std::string start = path.empty() ? "" : path + ": ";
  for (int i = 0; i < list.numContentLines(); ++i)
    if (!trimmed(list.getContentLine(i)).empty())
      throw InputError(start, "stray text '", trimmed(list.getContentLine(i)), "'");
  for (int i = 0; i < list.numChildren(); ++i) {
    const XMLObject& child = list.getChild(i);
    const std::string& tag = child.getTag();
    if (tag != "Parameter" && tag != "ParameterList")
      throw InputError(start, "unknown tag <", tag, ">",
                       bem::suggestion(tag, {"Parameter", "ParameterList"}));
    const std::string name = nameOf(child, path);
    const std::string inner = bem::join(path, name);
    if (result.isParameter(name))
      throw InputError(inner + ": given twice; keep one");
    if (tag == "ParameterList")
      readInto(result.sublist(name), child, inner);
    else
      result.setEntry(name, within(inner + ": ", [&] { return parameterOf(child); }));
  }
}

}  // namespace

ParameterEntry readValue(const std::string& type, const std::string& value) {
  std::vector<std::string> names;
  const std::string text = trimmed(value);
  for (const std::string one : {"int", "double", "string", "bool"}) {
    const std::string array = "Array(" + one + ")";
    names.push_back(one);
    if (type == one)
      return entryOf({one, Written::Shape::One, {one == "string" ? value : text}});
    if (one == "bool")
      continue;
    if (type == array)
      return entryOf(arrayIn(text, one));
    if (type == "TwoD" + array)
      return entryOf(tableIn(text, one));
    names.insert(names.end(), {array, "TwoD" + array});
  }
  throw InputError("unknown type '", type, "'", bem::suggestion(type, names));
}

ParameterList readList(const XMLObject& root) {
  if (root.getTag() != "ParameterList")
    throw InputError("the root is <", root.getTag(), ">; it must be <ParameterList>");
  ParameterList list;
  readInto(list, root, "");
  return list;
}

namespace {

using bem::message;

/// The message of a Teuchos exception without source positions.
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

/// Position of the '>' that ends a tag, outside of quotes; text.size() if missing.
std::size_t endOfTag(const std::string& text, std::size_t at) {
  for (char quote = 0; at < text.size() && (quote != 0 || text[at] != '>'); ++at)
    if (quote == 0 && (text[at] == '"' || text[at] == '\''))
      quote = text[at];
    else if (text[at] == quote)
      quote = 0;
  return at;
}

/// Checks the depth of nesting: the parsers are recursive and the stack is limited.
void checkNesting(const std::string& text) {
  constexpr int deepest = 1000;
  int depth = 0;
  for (std::size_t at = text.find('<'); at < text.size(); at = text.find('<', at)) {
    if (text.compare(at, 4, "<!--") == 0) {
      at = text.find("-->", at);
      continue;
    }
    const std::size_t end = endOfTag(text, at + 1);
    const char first = text[at + 1];
    const bool opens = first != '!' && first != '?' && text[end - 1] != '/';
    depth += first == '/' ? -1 : opens ? 1 : 0;
    if (depth > deepest)
      throw InputError("lists stand in lists more than ", deepest, " deep");
    at = end;
  }
}

XMLObject parsedXml(const std::string& text) {
  checkNesting(text);
  XMLObject root;
  try {
    root = Teuchos::StringInputSource(text).getObject();
  } catch (const std::exception& error) {
    throw InputError("malformed XML: " + complaint(error));
  }
  if (root.isEmpty())
    throw InputError("malformed XML: no root element");
  return root;
}

RawScene readXml(const std::string& text) {
  const XMLObject root = parsedXml(text);
  return {root.hasAttribute("name") ? root.getRequired("name") : "", readList(root)};
}

/// {a, b, c}, of a table behind its size.
std::string valueOf(const bem::Written& written) {
  using Shape = bem::Written::Shape;
  const std::string all = boost::algorithm::join(written.texts, ", ");
  if (written.shape == Shape::One)
    return all;
  return message(written.shape == Shape::Table
                     ? message(written.rows, "x", written.columns, ":")
                     : "",
                 "{", all, "}");
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
    const bem::Written written = bem::writtenIn(item.second).value();
    out << inner << "<Parameter name=\"" << xmlText(item.first) << "\" type=\""
        << written.fullType() << "\" value=\"" << xmlText(valueOf(written))
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

void checkReadable(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (!fs::exists(file, ignored))
    throw InputError("there is no such file");
  if (fs::is_directory(file, ignored))
    throw InputError("is a folder, not a file");
  if (fs::is_character_file(file, ignored) || fs::is_block_file(file, ignored))
    throw InputError("is a device, not a file");  // reading /dev/zero would never end
  errno = 0;
  if (!std::ifstream(file, std::ios::binary))
    throw InputError("cannot be read: ", std::strerror(errno));
}

namespace {

/// Removes the byte order mark that editors on Windows write.
std::string withoutMark(const std::string& text) {
  const auto begins = [&](const char* mark) { return text.rfind(mark, 0) == 0; };
  const bool zeros = text.substr(0, 4).find('\0') != std::string::npos;
  if (begins("\xFF\xFE") || begins("\xFE\xFF") || zeros)
    throw InputError(
        "its encoding is UTF-16 or UTF-32; save the file with the encoding UTF-8");
  return begins("\xEF\xBB\xBF") ? text.substr(3) : text;
}

/// \throws bem::InputError with the line of the first byte that is not valid UTF-8.
void checkEncoding(const std::string& text) {
  if (const std::size_t zero = text.find('\0'); zero != std::string::npos)
    throw InputError("byte ", zero, " is zero; a scene is text");
  if (const std::size_t at = notUtf8At(text); at != std::string::npos)
    throw InputError("line ", 1 + std::count(text.data(), text.data() + at, '\n'),
                     " is not encoded in UTF-8; save the file with the encoding UTF-8");
}

}  // namespace

std::string readText(const std::string& file) {
  checkReadable(file);
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return withoutMark(text.str());
}

std::string namedFile(const std::string& name, const std::string& scene) {
  const std::filesystem::path path(scene);
  if (path.filename() == "used.xml")
    throw InputError("the used.xml of a run names no other file; give what is in it");
  return (path.parent_path() / name).string();
}

RawScene rawScene(const std::string& text, const std::string& file) {
  checkEncoding(text);
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    throw InputError("the file is empty");
  const std::filesystem::path path(file);
  const std::string extension =
      boost::algorithm::to_lower_copy(path.extension().string());
  const bool yaml = extension == ".yaml" || extension == ".yml";
  if (!yaml && text[text.find_first_not_of(" \t\r\n")] != '<')
    throw InputError(
        extension == ".xml" ? "is not XML, which begins with <" : "is not XML",
        "; a scene is XML (.xml) or YAML (.yaml or .yml); JSON is YAML, too");
  RawScene scene = yaml ? readYaml(text) : readXml(text);
  if (scene.title.empty())
    scene.title = path.stem().string();
  return scene;
}

std::string toXml(const Teuchos::ParameterList& list, const std::string& title) {
  std::ostringstream out;
  write(list, title, "", out);
  return out.str();
}

}  // namespace epafi::drivers
