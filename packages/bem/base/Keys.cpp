#include "bem/base/Keys.hpp"

#include <Teuchos_ParameterList.hpp>

namespace epafi::bem {

namespace {

using Teuchos::ParameterList;
using Optional = std::optional<double>;
using OptionalCount = std::optional<int>;
using Points = std::vector<Vec2>;

Kind kindOf(bool) { return Kind::Flag; }
Kind kindOf(int) { return Kind::Whole; }
Kind kindOf(double) { return Kind::Real; }
Kind kindOf(const Optional&) { return Kind::Real; }
Kind kindOf(const OptionalCount&) { return Kind::Whole; }
Kind kindOf(const Points&) { return Kind::Points; }

std::string defaultOf(bool value) { return value ? "true" : "false"; }
std::string defaultOf(int value) { return shortest(value); }
std::string defaultOf(double value) { return shortest(value); }
std::string defaultOf(const Optional& value) { return value ? shortest(*value) : ""; }
std::string defaultOf(const OptionalCount& value) {
  return value ? shortest(*value) : "";
}
std::string defaultOf(const Points&) { return ""; }

template <class Value>
void read(const ParameterList& list, const std::string& name, Value& value) {
  value = list.get<Value>(name);
}

template <class Value>
void read(const ParameterList& list, const std::string& name,
          std::optional<Value>& value) {
  if (!list.getEntry(name).isDefault())
    value = list.get<Value>(name);
}

void read(const ParameterList& list, const std::string& name, Points& value) {
  value = pointsIn(list, name);
}

}  // namespace

void Keys::add(Value value, const std::string& name, const std::string& unit,
               const Interval& range, const std::string& meaning,
               const std::string& told) {
  std::visit(
      [&](auto* member) {
        append(rows, {Row(name, kindOf(*member), unit, range, meaning)
                          .defaultValue(told.empty() ? defaultOf(*member) : told)});
        if (list_ != nullptr && list_->isParameter(name))
          read(*list_, name, *member);
      },
      value);
}

void Keys::add(std::string* value, const std::string& name,
               const std::vector<std::string>& allowed, const std::string& meaning) {
  append(rows, {Row(name, Kind::Text, meaning).defaultValue(*value).allowed(allowed)});
  if (list_ != nullptr)
    *value = list_->get<std::string>(name);
}

const ParameterList* Keys::sublist(const std::string& name) const {
  return list_ == nullptr ? nullptr : &list_->sublist(name);
}

}  // namespace epafi::bem
