#include "bem/base/Error.hpp"
#include "drivers/scene/SceneFile.hpp"
#include "drivers/scene/Text.hpp"

#include <regex>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::lastOf;
using Teuchos::ParameterList;

/// The names A and B of A->B->Key.
std::vector<std::string> parents(const std::string& path) {
  std::vector<std::string> names = bem::namesOf(path);
  names.pop_back();
  return names;
}

/// The list that contains the last name of a path; null if there is none.
ParameterList* holderOf(ParameterList& list, const std::string& path) {
  ParameterList* target = &list;
  for (const std::string& name : parents(path))
    if (target->isSublist(name))
      target = &target->sublist(name);
    else
      return nullptr;
  return target->isParameter(lastOf(path)) ? target : nullptr;
}

/// The list in which a path ends, created if it is missing.
ParameterList& madeParentOf(ParameterList& list, const std::string& path) {
  ParameterList* target = &list;
  std::string walked;
  for (const std::string& name : parents(path)) {
    walked = bem::join(walked, name);
    if (target->isParameter(name) && !target->isSublist(name))
      throw InputError(walked + ": is not a list in the scene");
    target = &target->sublist(name);
  }
  return *target;
}

void removeAt(ParameterList& list, const std::string& path) {
  ParameterList* holder = holderOf(list, path);
  if (holder == nullptr)
    throw InputError(path +
                     ": is not in the scene, so it cannot be removed; a value is written "
                     "after the =");
  holder->remove(lastOf(path));
}

void setAt(ParameterList& list, const std::string& path, const std::string& value);

/// A value of a list that is passed on unchecked, where nothing declares its type: as in a YAML
/// file.
void setFree(ParameterList& list, const std::string& path, const std::string& value) {
  if (holderOf(list, path) != nullptr && holderOf(list, path)->isSublist(lastOf(path)))
    throw InputError(path + ": is a sublist; name a key in it");
  madeParentOf(list, path).setEntry(lastOf(path), readValue(narrowestType(value), value));
}

/// Replaces a list by "{Key=value, Key=value}".
void setList(ParameterList& list, const std::string& path, const std::string& value) {
  if (value.front() != '{' || value.back() != '}')
    throw InputError(path +
                     ": is a sublist; name a key in it, or replace the whole by "
                     "{Key=value, Key=value}");
  ParameterList& parent = madeParentOf(list, path);
  parent.remove(lastOf(path), false);
  parent.sublist(lastOf(path));
  for (const std::string& piece : pieces(value.substr(1, value.size() - 2))) {
    if (trimmed(piece).empty())
      continue;
    const auto equal = piece.find('=');
    if (equal == std::string::npos)
      throw InputError(path, ": '", trimmed(piece), "' is not a Key=value");
    const std::string inner = bem::join(path, trimmed(piece.substr(0, equal)));
    if (holderOf(list, inner) != nullptr)
      throw InputError(inner + ": given twice; keep one");
    setAt(list, inner, trimmed(piece.substr(equal + 1)));
  }
}

/// The type of a value: that of its key, or texts where expressions stand for numbers.
std::string typeOf(std::string type, const std::string& value) {
  static const std::regex number("[-+0-9.eE:x{}, \\t]|\\b(nan|inf)\\b");
  if (!std::regex_replace(value, number, "").empty())
    for (const std::string kind : {"double", "int"})
      if (const auto at = type.find(kind);
          at != std::string::npos && type.find("string") == std::string::npos)
        type.replace(at, kind.size(), "string");
  return type;
}

void setAt(ParameterList& list, const std::string& path, const std::string& value) {
  const Parameter& row = bem::declared(parameters(), path);
  if (value.empty())
    return removeAt(list, path);
  const bool isFree = row.kind == Kind::Free;
  if (row.kind == Kind::List ||
      (isFree && (value.front() == '{' || bem::namesOf(path) == bem::namesOf(row.path))))
    return setList(list, path, value);
  if (isFree)
    return setFree(list, path, value);
  const bool alone = value.find('{') == std::string::npos;
  if (alone && row.kind == Kind::Counts && value.find(',') != std::string::npos)
    throw InputError(
        path, ": '", value, "' is not an array; write {",
        value.substr(value.find_first_not_of("[ "),
                     value.find_last_not_of("] ") + 1 - value.find_first_not_of("[ ")),
        "}");
  const auto& kind = textOf(row.kind);
  const bool one = alone && (row.kind == Kind::Counts || row.kind == Kind::Reals);
  const std::string type = typeOf(one ? kind.element : kind.type, value);
  const auto entry = within(path + ": ", [&] { return readValue(type, value); });
  madeParentOf(list, path).setEntry(lastOf(path), entry);
}

}  // namespace

void applyOverride(ParameterList& list, const std::string& assignment) {
  const auto equal = assignment.find('=');
  if (equal == std::string::npos)
    throw InputError(
        "--set '", assignment, "': write 'A->B->Key=value'",
        !assignment.empty() && assignment.back() == '-'
            ? "; the shell has taken the > for itself: put quotes round all of it"
            : "");
  const std::string path = trimmed(assignment.substr(0, equal));
  const std::string value = trimmed(assignment.substr(equal + 1));
  within("--set ", [&] {
    try {
      setAt(list, path, value);
    } catch (const InputError& error) {
      const bool parted =
          path.find("->") == path.npos && path.find_first_of("./") != path.npos;
      throw InputError(error.what(),
                       parted ? "; names are parted by ->, not by . or /" : "");
    }
  });
}

}  // namespace epafi::drivers
