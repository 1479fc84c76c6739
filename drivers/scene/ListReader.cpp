#include "bem/base/Error.hpp"
#include "bem/base/SchemaRow.hpp"
#include "bem/base/Suggestion.hpp"
#include "bem/base/Written.hpp"
#include "drivers/scene/SceneFile.hpp"
#include "drivers/scene/Text.hpp"

#include <Teuchos_XMLObject.hpp>

#include <algorithm>

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

}  // namespace epafi::drivers
