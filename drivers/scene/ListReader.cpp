#include "drivers/scene/ListReader.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/SchemaRow.hpp"
#include "bem/base/Suggestion.hpp"
#include "drivers/scene/Text.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_TwoDArray.hpp>
#include <Teuchos_XMLObject.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <type_traits>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::message;
using Teuchos::ParameterEntry;
using Teuchos::ParameterList;
using Teuchos::XMLObject;

template <class T>
T valueOf(const std::string& text);

template <>
std::string valueOf(const std::string& text) {
  return text;
}

template <>
double valueOf(const std::string& text) {
  char* stop = nullptr;
  const double value = std::strtod(text.c_str(), &stop);
  // strtod also accepts infinity and hexadecimal numbers
  if (text.empty() || stop != text.c_str() + text.size() ||
      text.find_first_not_of("0123456789+-.eE") != std::string::npos)
    throw InputError("'", text, "' is not a number; write 0.5, -3 or 1e-3");
  if (!std::isfinite(value))
    throw InputError("'", text, "' is too large for a number");
  const std::string mantissa = text.substr(0, text.find_first_of("eE"));
  const bool subnormal = std::abs(value) < std::numeric_limits<double>::min();
  if (subnormal && mantissa.find_first_of("123456789") != std::string::npos)
    throw InputError("'", text, "' is too small for a number; from 2.3e-308 on, or 0");
  return value;
}

template <>
int valueOf(const std::string& text) {
  const std::size_t start = !text.empty() && text[0] == '+' ? 1 : 0;
  int value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + start, end, value);
  if (error == std::errc::result_out_of_range)
    throw InputError("'", text, "' is out of range; from ",
                     std::numeric_limits<int>::min(), " to ",
                     std::numeric_limits<int>::max());
  if (error != std::errc() || stop != end || (start == 1 && text[1] == '-'))
    throw InputError("'", text, "' is not a whole number");
  return value;
}

template <>
bool valueOf(const std::string& text) {
  if (text != "true" && text != "false")
    throw InputError("'", text, "' is neither 'true' nor 'false'");
  return text == "true";
}

template <class T>
ParameterEntry one(const std::string& text) {
  return ParameterEntry(
      valueOf<T>(std::is_same_v<T, std::string> ? text : trimmed(text)));
}

/// {a, b, c}
template <class T>
Teuchos::Array<T> entriesOf(const std::string& text) {
  if (text.size() < 2 || text.front() != '{' || text.back() != '}')
    throw InputError("'", text, "' is not an array; write {a, b, c}");
  const std::string inner = trimmed(text.substr(1, text.size() - 2));
  Teuchos::Array<T> result;
  if (inner.empty())
    return result;
  constexpr bool texts = std::is_same_v<T, std::string>;  // may hold arrays: A={4, 4}
  for (const std::string& piece : pieces(inner)) {
    const std::string entry = trimmed(piece);
    const bool brace = entry.find_first_of("{}") != std::string::npos;
    if (entry.empty() || (brace && !(texts && isBalanced(entry))))
      throw InputError("entry ", result.size(), " = '", entry,
                       "' of the array is empty or holds a brace; write {a, b, c}");
    within(message("entry ", result.size(), " of the array: "),
           [&] { result.push_back(valueOf<T>(shown(entry))); });
  }
  return result;
}

template <class T>
ParameterEntry array(const std::string& text) {
  return ParameterEntry(entriesOf<T>(trimmed(text)));
}

/// RxC:{a, b, ...}
template <class T>
ParameterEntry table(const std::string& given) {
  const std::string text = trimmed(given);
  const std::string size = text.substr(0, text.find(':'));
  const std::string rows = size.substr(0, size.find('x'));
  const std::string columns = size.substr(std::min(rows.size() + 1, size.size()));
  for (const std::string& count : {rows, columns})
    if (count.empty() || count.find_first_not_of("0123456789") != std::string::npos ||
        size.size() == text.size())
      throw InputError("'", text, "' is not a table; write 4x2:{a, b, ...}, row by row");
  const int rowCount = valueOf<int>(rows);
  const int columnCount = valueOf<int>(columns);
  const long wanted = static_cast<long>(rowCount) * columnCount;
  const Teuchos::Array<T> entries = entriesOf<T>(trimmed(text.substr(size.size() + 1)));
  if (entries.size() != wanted)
    throw InputError("a table ", size, " has ", wanted, " entries; ", entries.size(),
                     " are given");
  Teuchos::TwoDArray<T> result(rowCount, columnCount);
  for (int k = 0; k < wanted; ++k)
    result(k / columnCount, k % columnCount) = entries[k];
  return ParameterEntry(result);
}

struct Type {
  const char* name;
  ParameterEntry (*read)(const std::string& text);
};

constexpr Type types[] = {
    {"int", one<int>},
    {"double", one<double>},
    {"bool", one<bool>},
    {"string", one<std::string>},
    {"Array(int)", array<int>},
    {"Array(double)", array<double>},
    {"Array(string)", array<std::string>},
    {"TwoDArray(int)", table<int>},
    {"TwoDArray(double)", table<double>},
    {"TwoDArray(string)", table<std::string>},
};

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
    entry.setAnyValue(Teuchos::any(entry.getAny(false)),
                      valueOf<bool>(object.getRequired("isDefault")));
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
  for (const Type& known : types) {
    if (type == known.name)
      return known.read(value);
    names.emplace_back(known.name);
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

}  // namespace epafi::drivers
