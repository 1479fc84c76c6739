#include "drivers/scene/Override.hpp"

#include "bem/base/Error.hpp"
#include "drivers/scene/LexicalCheck.hpp"
#include "drivers/scene/RemovedKeys.hpp"
#include "drivers/scene/Schema.hpp"
#include "drivers/scene/Text.hpp"

#include <Teuchos_XMLObject.hpp>
#include <Teuchos_XMLParameterListReader.hpp>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::lastOf;

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
  const Parameter& row = bem::declared(parameters(), path);
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
  within(path + ": ", [&] { checkValue(type, text); });
  madeParentOf(list, path).setEntry(lastOf(path), entryOf(type, text));
}

}  // namespace

void applyOverride(Teuchos::ParameterList& list, const std::string& assignment) {
  const auto equal = assignment.find('=');
  if (equal == std::string::npos)
    throw InputError("--set '", assignment, "': write 'A->B->Key=value'");
  const std::string path = assignment.substr(0, equal);
  const std::string value = assignment.substr(equal + 1);
  within("--set ", [&] {
    refuseRemovedKey(path);
    setAt(list, path, value);
  });
}

}  // namespace epafi::drivers
