#include "bem/base/Schema.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/SchemaValue.hpp"
#include "bem/base/Suggestion.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_StandardParameterEntryValidators.hpp>
#include <Teuchos_TwoDArray.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi::bem {

namespace {

using Teuchos::getValue;
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
const SchemaRow& required(const SchemaRows& table, const SchemaRow* row,
                          const std::vector<const SchemaRow*>& rows,
                          const std::string& path, const std::string& name) {
  if (row != nullptr)
    return *row;
  std::vector<std::string> known;
  known.reserve(rows.size());
  for (const SchemaRow* other : rows)
    known.push_back(example(other->name()));
  throw InputError(join(path, name), ": unknown", placesOf(table, name),
                   suggestion(name, known));
}

/// One level of the list against the rows under one pattern.
class Level {
 public:
  /// \param meant path of another list of the scene's choice with nearly this name
  Level(const SchemaRows& table, const Constant& constant, const ParameterList& given,
        const std::string& pattern, std::string path, std::string meant = "")
      : table_(table),
        constant_(constant),
        given_(given),
        path_(std::move(path)),
        meant_(std::move(meant)),
        rows_(childrenOf(table, pattern)) {}

  void complete(ParameterList& result) const {
    for (const auto& item : given_)
      required(table_, find(rows_, item.first), rows_, path_, item.first);
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
      result.setEntry(name, valueOf(entry, row, join(path_, name), constant_));
      return;
    }
    if (!entry.isList())
      throw InputError(join(path_, name), ": is ", describe(entry),
                       ", wanted: a list (ParameterList)", keysOf(row));
    const auto& sublist = getValue<ParameterList>(entry);
    if (row.kind == Kind::Free)
      result.sublist(name).setParameters(sublist);
    else
      Level(table_, constant_, sublist, row.path, join(path_, name),
            isAnyName(row.name()) ? nearlyNamed(name) : "")
          .complete(result.sublist(name));
  }

  /// " with 'Law', 'Threshold' or 'Coefficient'", of a list with own names ""
  std::string keysOf(const SchemaRow& row) const {
    std::vector<std::string> keys;
    for (const SchemaRow* child : childrenOf(table_, row.path))
      keys.push_back(example(child->name()));
    return keys.empty() || isAnyName(keys.front()) ? "" : " with " + quotedList(keys);
  }

  std::string nearlyNamed(const std::string& name) const {
    std::vector<std::string> others;
    for (const auto& item : given_)
      if (item.first != name)
        others.push_back(item.first);
    const std::string near = nearest(name, others);
    return near.empty() ? "" : join(path_, near);
  }

  void fill(const SchemaRow& row, ParameterList& result) const {
    if (row.required)
      for (const auto& item : given_)  // it may stand there under another name
        if (const SchemaRow* key = selector();
            key != nullptr && result.isParameter(key->name()))
          checkActive(item.first, result);
    if (row.required)
      throw InputError(join(path_, row.name()), ": missing; ", row.meaning,
                       row.range().empty() ? "" : ", " + row.range(),
                       meant_.empty() ? "" : "; did you mean " + meant_ + "?");
    if (row.kind == Kind::List && !isAnyName(row.name()))
      Level(table_, constant_, ParameterList(), row.path, join(path_, row.name()))
          .complete(result.sublist(row.name()));
    else if (!row.defaultValue.empty())
      result.setEntry(row.name(), defaultOf(row));
  }

  const SchemaRows& table_;
  const Constant& constant_;
  const ParameterList& given_;
  std::string path_;
  std::string meant_;
  std::vector<const SchemaRow*> rows_;
};

}  // namespace

const SchemaRow& declared(const SchemaRows& table, const std::string& path) {
  std::string pattern;
  std::string walked;
  const SchemaRow* row = nullptr;
  for (const std::string& name : namesOf(path)) {
    const auto rows = childrenOf(table, pattern);
    row = &required(table, name.empty() ? nullptr : find(rows, name), rows, walked, name);
    if (row->kind == Kind::Free)
      break;
    pattern = row->path;
    walked = join(walked, name);
  }
  return *row;
}

ParameterList complete(const SchemaRows& table, const ParameterList& given,
                       const std::string& title, const Constant& constant) {
  ParameterList result(title);
  Level(table, constant, given, "", "").complete(result);
  return result;
}

void complete(const SchemaRows& table, ParameterList& list) {
  const std::string name = list.name();
  list = within(name + arrow, [&] { return complete(table, list, name); });
}

namespace {

Teuchos::RCP<const Teuchos::ParameterEntryValidator> validatorOf(const SchemaRow& row) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto& [low, high, lowOpen, highOpen] = row.interval;
  if (row.kind == Kind::Real)  // these bounds are admissible
    return Teuchos::rcp(new Teuchos::EnhancedNumberValidator<double>(
        lowOpen ? std::nextafter(low, infinity) : low,
        highOpen ? std::nextafter(high, -infinity) : high));
  if (row.kind == Kind::Whole) {
    const auto whole = [](double bound) {
      return static_cast<int>(std::clamp<double>(bound, std::numeric_limits<int>::min(),
                                                 std::numeric_limits<int>::max()));
    };
    return Teuchos::rcp(new Teuchos::EnhancedNumberValidator<int>(
        whole(row.interval.low), whole(row.interval.high)));
  }
  if (row.allowed.empty())
    return {};
  return Teuchos::rcp(
      new Teuchos::StringValidator(Teuchos::Array<std::string>(row.allowed)));
}

}  // namespace

void addValidParameters(const SchemaRows& table, ParameterList& result) {
  for (const SchemaRow& row : table) {
    ParameterList* list = &result;
    std::vector<std::string> names = namesOf(row.path);
    names.pop_back();
    for (const std::string& name : names)
      list = &list->sublist(name);
    if (row.kind == Kind::List || row.kind == Kind::Free) {
      list->sublist(row.name(), false, row.meaning);
    } else if (!row.defaultValue.empty()) {
      ParameterEntry entry = defaultOf(row);
      entry.setDocString(message(row.meaning, row.unit.empty() ? "" : ", in ", row.unit,
                                 row.range().empty() ? "" : "; ", row.range()));
      entry.setValidator(validatorOf(row));
      list->setEntry(row.name(), entry);
    }
  }
}

std::vector<Vec2> pointsIn(const ParameterList& list, const std::string& key) {
  const auto& table = list.get<Teuchos::TwoDArray<double>>(key);
  std::vector<Vec2> points;
  for (int i = 0; i < table.getNumRows(); ++i)
    points.push_back({table(i, 0), table(i, 1)});
  return points;
}

void setPoints(ParameterList& list, const std::string& key,
               const std::vector<Vec2>& points) {
  const int size = static_cast<int>(points.size());
  Teuchos::TwoDArray<double> table(size, 2);
  for (int i = 0; i < size; ++i) {
    table(i, 0) = points[i].x;
    table(i, 1) = points[i].y;
  }
  list.set(key, table);
}

}  // namespace epafi::bem
