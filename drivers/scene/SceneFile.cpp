#include "drivers/scene/SceneFile.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/SchemaRow.hpp"
#include "drivers/scene/LexicalCheck.hpp"
#include "drivers/scene/NestingCheck.hpp"
#include "drivers/scene/Text.hpp"
#include "drivers/scene/YamlText.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterEntryXMLConverterDB.hpp>
#include <Teuchos_StringInputSource.hpp>
#include <Teuchos_TwoDArray.hpp>
#include <Teuchos_XMLObject.hpp>
#include <Teuchos_XMLParameterListReader.hpp>

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
using Teuchos::XMLObject;

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
void hideNesting(const XMLObject& object) {
  for (int i = 0; i < object.numChildren(); ++i) {
    XMLObject child = object.getChild(i);
    if (child.getTag() == "ParameterList")
      hideNesting(child);
    else if (child.getRequired("type").find("Array(string)") != std::string::npos)
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
    else if (entry.isType<Teuchos::TwoDArray<std::string>>()) {
      auto& texts = Teuchos::getValue<Teuchos::TwoDArray<std::string>>(entry);
      for (int i = 0; i < texts.getNumRows(); ++i)
        for (int j = 0; j < texts.getNumCols(); ++j)
          texts(i, j) = shown(texts(i, j));
    }
  }
}

XMLObject parsedXml(const std::string& text) {
  checkNestingOfXml(text);
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

RawScene sceneOf(const XMLObject& root, const std::string& standardTitle) {
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

/// The type and value that an entry has in XML: doubles, alone and in arrays, with as few digits
/// as give back every bit, others as Teuchos writes them.
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
  const XMLObject xml = Teuchos::ParameterEntryXMLConverterDB::convertEntry(
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

void checkReadable(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (!fs::exists(file, ignored))
    throw InputError("there is no such file");
  if (fs::is_directory(file, ignored))
    throw InputError("is a folder, not a file");
  if (fs::is_character_file(file, ignored) || fs::is_block_file(file, ignored))
    throw InputError("is a device, not a file");  // /dev/zero never ends
  errno = 0;
  if (!std::ifstream(file, std::ios::binary))
    throw InputError("cannot be read: ", std::strerror(errno));
}

std::string readText(const std::string& file) {
  checkReadable(file);
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
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
  return sceneOf(yaml ? xmlOfYaml(text) : parsedXml(text), path.stem().string());
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
