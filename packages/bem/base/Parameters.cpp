#include "bem/base/Parameters.hpp"

#include "bem/base/Error.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace epafi::bem {

bool Interval::contains(double value) const {
  return (lowOpen ? value > low : value >= low) &&
         (highOpen ? value < high : value <= high);
}

std::string Interval::text() const {
  if (std::isinf(high) && std::isinf(low))
    return "any finite number";
  if (std::isinf(high))
    return message(lowOpen ? "> " : ">= ", low);
  if (std::isinf(low))
    return message(highOpen ? "< " : "<= ", high);
  if (!lowOpen && !highOpen)
    return message("from ", low, " to ", high);
  return message("in ", lowOpen ? "(" : "[", low, ", ", high, highOpen ? ")" : "]");
}

namespace {

std::string where(const std::string& key, const std::string& path) {
  return path.empty() ? key : path + "->" + key;
}

std::string plain(double value) {
  std::ostringstream text;
  text.precision(17);
  text << value;
  std::ostringstream brief;
  brief << value;
  return std::stod(brief.str()) == value ? brief.str() : text.str();
}

/// The numbers of an entry: one, or those of an array; empty if it holds none.
std::vector<double> numbersOf(const Teuchos::ParameterEntry& entry) {
  if (entry.isType<double>())
    return {Teuchos::getValue<double>(entry)};
  if (entry.isType<int>())
    return {static_cast<double>(Teuchos::getValue<int>(entry))};
  if (entry.isType<Teuchos::Array<int>>()) {
    const auto& array = Teuchos::getValue<Teuchos::Array<int>>(entry);
    return {array.begin(), array.end()};
  }
  if (entry.isType<Teuchos::Array<double>>()) {
    const auto& array = Teuchos::getValue<Teuchos::Array<double>>(entry);
    return {array.begin(), array.end()};
  }
  return {};
}

std::vector<std::string> stringsOf(const Teuchos::ParameterEntry& entry) {
  if (entry.isType<std::string>())
    return {Teuchos::getValue<std::string>(entry)};
  if (entry.isType<Teuchos::Array<std::string>>()) {
    const auto& array = Teuchos::getValue<Teuchos::Array<std::string>>(entry);
    return {array.begin(), array.end()};
  }
  return {};
}

class WithinValidator final : public Teuchos::ParameterEntryValidator {
 public:
  explicit WithinValidator(const Interval& interval) : interval_(interval) {}

  void validate(const Teuchos::ParameterEntry& entry, const std::string& name,
                const std::string& list) const override {
    for (double value : numbersOf(entry))
      if (!interval_.contains(value) || !std::isfinite(value))
        throw InputError(message(where(name, list), " = ", plain(value),
                                 "; allowed: ", interval_.text()));
  }
  ValidStringsList validStringValues() const override { return Teuchos::null; }
  // NOLINTNEXTLINE(readability-const-return-type): Teuchos has it so
  const std::string getXMLTypeName() const override { return "epafi::Within"; }
  void printDoc(const std::string& doc, std::ostream& out) const override {
    out << doc << " [" << interval_.text() << "]\n";
  }

 private:
  Interval interval_;
};

class OneOfValidator final : public Teuchos::ParameterEntryValidator {
 public:
  explicit OneOfValidator(std::vector<std::string> names) : names_(std::move(names)) {}

  void validate(const Teuchos::ParameterEntry& entry, const std::string& name,
                const std::string& list) const override {
    for (const std::string& value : stringsOf(entry))
      if (std::find(names_.begin(), names_.end(), value) == names_.end())
        throw InputError(message(where(name, list), " = '", value, "'; did you mean '",
                                 nearest(value, names_),
                                 "'? allowed: ", quotedList(names_)));
  }
  ValidStringsList validStringValues() const override {
    return Teuchos::rcp(new Teuchos::Array<std::string>(names_));
  }
  // NOLINTNEXTLINE(readability-const-return-type): Teuchos has it so
  const std::string getXMLTypeName() const override { return "epafi::OneOf"; }
  void printDoc(const std::string& doc, std::ostream& out) const override {
    out << doc << " [" << quotedList(names_) << "]\n";
  }

 private:
  std::vector<std::string> names_;
};

}  // namespace

Validator within(const Interval& interval) {
  return Teuchos::rcp(new WithinValidator(interval));
}

Validator atLeast(double low) {
  Interval interval;
  interval.low = low;
  return within(interval);
}

Validator greaterThan(double low) {
  Interval interval;
  interval.low = low;
  interval.lowOpen = true;
  return within(interval);
}

Validator inRange(double low, double high) { return within({low, high, false, false}); }

Validator inInterior(double low, double high) { return within({low, high, true, true}); }

Validator oneOf(std::vector<std::string> names) {
  return Teuchos::rcp(new OneOfValidator(std::move(names)));
}

double editDistance(const std::string& a, const std::string& b) {
  const auto differ = [](char p, char q) {
    const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    return p == q ? 0.0 : lower(p) == lower(q) ? 0.5 : 1.0;
  };
  const std::size_t m = a.size();
  const std::size_t n = b.size();
  std::vector<double> table((m + 1) * (n + 1));
  const auto d = [&table, n](std::size_t i, std::size_t j) -> double& {
    return table[i * (n + 1) + j];
  };
  for (std::size_t i = 0; i <= m; ++i)
    for (std::size_t j = 0; j <= n; ++j) {
      if (i == 0 || j == 0) {
        d(i, j) = static_cast<double>(i + j);
        continue;
      }
      d(i, j) = std::min({d(i - 1, j) + 1, d(i, j - 1) + 1,
                          d(i - 1, j - 1) + differ(a[i - 1], b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d(i, j) = std::min(d(i, j), d(i - 2, j - 2) + 1);
    }
  return d(m, n);
}

std::string nearest(const std::string& name, const std::vector<std::string>& candidates) {
  std::string best;
  double smallest = std::numeric_limits<double>::infinity();
  for (const std::string& candidate : candidates) {
    // What differs in length takes at least that many insertions.
    const std::size_t longer = std::max(name.size(), candidate.size());
    const std::size_t shorter = std::min(name.size(), candidate.size());
    if (static_cast<double>(longer - shorter) >= smallest)
      continue;
    const double distance = editDistance(name, candidate);
    if (distance < smallest) {
      smallest = distance;
      best = candidate;
    }
  }
  return best;
}

std::string quotedList(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0                  ? ""
             : i + 1 == names.size() ? " or "
                                     : ", ") +
            ("'" + names[i] + "'");
  return text;
}

std::string suggestion(const std::string& name,
                       const std::vector<std::string>& candidates) {
  if (candidates.empty())
    return "; nothing may stand here";
  return message("; did you mean '", nearest(name, candidates),
                 "'? known here: ", quotedList(candidates));
}

namespace {

std::string typeOf(const Teuchos::ParameterEntry& entry) {
  return entry.isList() ? "ParameterList" : entry.getAny(false).typeName();
}

void validateEntry(const Teuchos::ParameterEntry& given,
                   const Teuchos::ParameterEntry& expected, const std::string& name,
                   const std::string& path) {
  if (given.isList() != expected.isList() ||
      (!given.isList() && given.getAny(false).type() != expected.getAny(false).type()))
    throw InputError(message(where(name, path), ": is of type ", typeOf(given),
                             ", wanted: ", typeOf(expected)));
  if (!given.isList() && expected.validator() != Teuchos::null)
    expected.validator()->validate(given, name, path);
}

}  // namespace

void validate(Teuchos::ParameterList& list, const Teuchos::ParameterList& valid,
              const std::string& path) {
  std::vector<std::string> known;
  for (const auto& item : valid)
    known.push_back(item.first);

  for (const auto& item : list) {
    const std::string& name = item.first;
    const Teuchos::ParameterEntry* expected = valid.getEntryPtr(name);
    if (expected == nullptr)
      throw InputError(message(where(name, path), ": unknown", suggestion(name, known)));
    validateEntry(item.second, *expected, name, path);
  }
  for (const auto& item : valid)
    if (item.second.isList())
      validate(list.sublist(item.first), valid.sublist(item.first),
               where(item.first, path));
    else if (!list.isParameter(item.first))
      list.setEntry(item.first, item.second);
}

}  // namespace epafi::bem
