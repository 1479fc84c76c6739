#include "bem/base/Schema.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/SchemaValue.hpp"
#include "bem/base/Suggestion.hpp"

#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <cstring>

namespace epafi::bem {

namespace {

using Teuchos::ParameterEntry;
using Teuchos::ParameterList;

bool isAnyName(const std::string& pattern) { return pattern.front() == '<'; }

bool isCount(const std::string& text) {
  return !text.empty() && text.size() < 7 && text.front() != '0' &&
         text.find_first_not_of("0123456789") == std::string::npos;
}

bool matches(const std::string& pattern, const std::string& name) {
  if (isAnyName(pattern))
    return true;
  const auto k = pattern.find("<k>");
  if (k == std::string::npos)
    return pattern == name;
  const std::string before = pattern.substr(0, k);
  const std::string after = pattern.substr(k + 3);
  return name.size() > before.size() + after.size() &&
         name.compare(0, before.size(), before) == 0 &&
         name.compare(name.size() - after.size(), after.size(), after) == 0 &&
         isCount(name.substr(before.size(), name.size() - before.size() - after.size()));
}

/// A pattern as a name that one could write.
std::string example(const std::string& pattern) {
  const auto k = pattern.find("<k>");
  return k == std::string::npos ? pattern
                                : pattern.substr(0, k) + "1" + pattern.substr(k + 3);
}

const SchemaRow* find(const std::vector<const SchemaRow*>& rows,
                      const std::string& name) {
  for (const SchemaRow* row : rows)
    if (matches(row->name(), name))
      return row;
  return nullptr;
}

/// What has been found among these rows; \throws InputError if nothing.
const SchemaRow& required(const SchemaRow* row, const std::vector<const SchemaRow*>& rows,
                          const std::string& path, const std::string& name) {
  if (row != nullptr)
    return *row;
  std::vector<std::string> known;
  known.reserve(rows.size());
  for (const SchemaRow* other : rows)
    known.push_back(example(other->name()));
  throw InputError(join(path, name), ": unknown", suggestion(name, known));
}

/// One level of the list against the rows under one pattern.
class Level {
 public:
  Level(const SchemaRows& table, const ParameterList& given, const std::string& pattern,
        std::string path)
      : table_(table),
        given_(given),
        path_(std::move(path)),
        rows_(childrenOf(table, pattern)) {}

  void complete(ParameterList& result) const {
    for (const auto& item : given_)
      required(find(rows_, item.first), rows_, path_, item.first);
    for (const SchemaRow* row : rows_) {
      if (!active(*row, result))
        continue;
      bool found = false;
      for (const auto& item : given_)
        if (find(rows_, item.first) == row) {
          found = true;
          take(*row, item.first, item.second, result);
        }
      if (!found)
        fill(*row, result);
    }
    for (const auto& item : given_)
      checkActive(item.first, result);
  }

 private:
  /// The sibling whose value decides which keys exist.
  const SchemaRow* selector() const {
    for (const char* name : {"Type", "Law"})
      for (const SchemaRow* row : rows_)
        if (row->name() == name)
          return row;
    return nullptr;
  }

  bool active(const SchemaRow& row, const ParameterList& result) const {
    return row.only.empty() ||
           std::count(row.only.begin(), row.only.end(),
                      result.get<std::string>(selector()->name())) > 0;
  }

  void checkActive(const std::string& name, const ParameterList& result) const {
    const SchemaRow& row = *find(rows_, name);
    if (active(row, result))
      return;
    std::vector<std::string> known;
    for (const SchemaRow* other : rows_)
      if (active(*other, result))
        known.push_back(example(other->name()));
    const std::string key = selector()->name();
    throw InputError(join(path_, name), ": belongs to ", key, " ", quotedList(row.only),
                     ", but ", key, " is '", result.get<std::string>(key),
                     "'; known here: ", quotedList(known));
  }

  void take(const SchemaRow& row, const std::string& name, const ParameterEntry& entry,
            ParameterList& result) const {
    if (row.kind != Kind::List && row.kind != Kind::Free) {
      result.setEntry(name, checked(entry, row, join(path_, name)));
      return;
    }
    if (!entry.isList())
      throw InputError(join(path_, name), ": is ", describe(entry),
                       ", wanted: a sublist (ParameterList)");
    const auto& sublist = Teuchos::getValue<ParameterList>(entry);
    if (row.kind == Kind::Free)
      result.sublist(name).setParameters(sublist);
    else
      Level(table_, sublist, row.path, join(path_, name)).complete(result.sublist(name));
  }

  void fill(const SchemaRow& row, ParameterList& result) const {
    if (row.required)
      throw InputError(join(path_, row.name()), ": missing; ", row.meaning,
                       row.range().empty() ? "" : ", " + row.range());
    if (row.kind == Kind::List && !isAnyName(row.name()))
      Level(table_, ParameterList(), row.path, join(path_, row.name()))
          .complete(result.sublist(row.name()));
    else if (!row.standard.empty())
      result.setEntry(row.name(), standardOf(row));
  }

  const SchemaRows& table_;
  const ParameterList& given_;
  std::string path_;
  std::vector<const SchemaRow*> rows_;
};

}  // namespace

const SchemaRow& declared(const SchemaRows& table, const std::string& path) {
  std::string pattern;
  std::string walked;
  const SchemaRow* row = nullptr;
  for (std::size_t at = 0; at <= path.size();) {
    const std::size_t end = std::min(path.find(arrow, at), path.size());
    const std::string name = path.substr(at, end - at);
    const auto rows = childrenOf(table, pattern);
    row = &required(name.empty() ? nullptr : find(rows, name), rows, walked, name);
    pattern = row->path;
    walked = join(walked, name);
    at = end + std::strlen(arrow);
  }
  return *row;
}

ParameterList complete(const SchemaRows& table, const ParameterList& given,
                       const std::string& title) {
  ParameterList result(title);
  Level(table, given, "", "").complete(result);
  return result;
}

}  // namespace epafi::bem
