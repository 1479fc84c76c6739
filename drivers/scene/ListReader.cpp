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
#include <iterator>
#include <limits>

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
ParameterEntry entryOf(const Written& written) {
  using Shape = Written::Shape;
  std::vector<T> values;
  for (const std::string& text : written.texts)
    within(written.shape == Shape::One
               ? ""
               : message("entry ", values.size(), " of the array: "),
           [&] { values.push_back(valueOf<T>(text)); });
  if (written.shape == Shape::One)
    return ParameterEntry(T(values.front()));
  if (written.shape == Shape::Array)
    return ParameterEntry(Teuchos::Array<T>(values));
  Teuchos::TwoDArray<T> table(written.rows, written.columns);
  for (int k = 0; k < static_cast<int>(values.size()); ++k)
    table(k / written.columns, k % written.columns) = values[k];
  return ParameterEntry(table);
}

ParameterEntry flagOf(const Written& written) {
  if (written.shape != Written::Shape::One)
    throw InputError("no key takes an array of true and false");
  return ParameterEntry(valueOf<bool>(written.texts.front()));
}

struct Type {
  const char* name;
  ParameterEntry (*read)(const Written& written);
};

constexpr Type types[] = {{"int", entryOf<int>},
                          {"double", entryOf<double>},
                          {"string", entryOf<std::string>},
                          {"bool", flagOf}};

/// {a, b, c}
Written arrayIn(const std::string& text, bool ofTexts) {
  if (text.size() < 2 || text.front() != '{' || text.back() != '}')
    throw InputError("'", text, "' is not an array; write {a, b, c}");
  const std::string inner = trimmed(text.substr(1, text.size() - 2));
  Written array{Written::Shape::Array, {}};
  if (inner.empty())
    return array;
  for (const std::string& piece : pieces(inner)) {
    const std::string entry = trimmed(piece);
    const bool brace = entry.find_first_of("{}") != std::string::npos;
    if (entry.empty() || (brace && !(ofTexts && isBalanced(entry))))  // A={4, 4}
      throw InputError("entry ", array.texts.size(), " = '", entry,
                       "' of the array is empty or holds a brace; write {a, b, c}");
    array.texts.push_back(entry);
  }
  return array;
}

/// RxC:{a, b, ...}
Written tableIn(const std::string& text, bool ofTexts) {
  const std::string size = text.substr(0, text.find(':'));
  const std::string rows = size.substr(0, size.find('x'));
  const std::string columns = size.substr(std::min(rows.size() + 1, size.size()));
  for (const std::string& count : {rows, columns})
    if (count.empty() || count.find_first_not_of("0123456789") != std::string::npos ||
        size.size() == text.size())
      throw InputError("'", text, "' is not a table; write 4x2:{a, b, ...}, row by row");
  Written table = arrayIn(trimmed(text.substr(size.size() + 1)), ofTexts);
  table.shape = Written::Shape::Table;
  table.rows = valueOf<int>(rows);
  table.columns = valueOf<int>(columns);
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

ParameterEntry toEntry(const std::string& type, const Written& written) {
  const auto* found = std::find_if(std::begin(types), std::end(types),
                                   [&](const Type& known) { return type == known.name; });
  return found->read(written);
}

ParameterEntry readValue(const std::string& type, const std::string& value) {
  std::vector<std::string> names;
  const std::string text = trimmed(value);
  for (const auto& [name, read] : types) {
    const bool ofTexts = name == std::string("string");
    names.emplace_back(name);
    if (type == name)
      return read({Written::Shape::One, {ofTexts ? value : text}});
    if (name == std::string("bool"))
      continue;
    const std::string array = message("Array(", name, ")");
    names.insert(names.end(), {array, "TwoD" + array});
    if (type == array)
      return read(arrayIn(text, ofTexts));
    if (type == "TwoD" + array)
      return read(tableIn(text, ofTexts));
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
