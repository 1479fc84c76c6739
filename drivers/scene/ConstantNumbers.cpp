#include "drivers/scene/ConstantNumbers.hpp"

#include "bem/base/Error.hpp"
#include "drivers/scene/Schema.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_TwoDArray.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace epafi::drivers {

namespace {

using Teuchos::Array;
using Teuchos::getValue;
using Teuchos::ParameterEntry;
using Teuchos::ParameterList;
using Teuchos::TwoDArray;

/// The numbers of one scene.
class Evaluation {
 public:
  Evaluation(const std::string& file, const Names& names) : file_(file), names_(names) {}

  void visit(ParameterList& list, const std::string& path) {
    for (const auto& item : list) {
      ParameterEntry& entry = *list.getEntryPtr(item.first);
      const std::string place = path.empty() ? item.first : bem::join(path, item.first);
      if (!entry.isList() && !holdsTexts(entry))
        continue;
      const Parameter& row = bem::declared(parameters(), place);
      if (!entry.isList())
        try {
          evaluate(entry, row.kind, place);
        } catch (const bem::InputError& error) {
          throw bem::InputError(error.what(), "; wanted: ", bem::textOf(row.kind).wanted,
                                ", or an expression in Constants for each number");
        }
      else if (row.kind == Kind::List)
        visit(getValue<ParameterList>(entry), place);
    }
  }

  Entries found;

 private:
  static bool holdsTexts(const ParameterEntry& entry) {
    return entry.isType<std::string>() || entry.isType<Array<std::string>>() ||
           entry.isType<TwoDArray<std::string>>();
  }

  void evaluate(ParameterEntry& entry, Kind kind, const std::string& place) {
    const bool whole = kind == Kind::Whole || kind == Kind::Counts;
    const bool alone = entry.isType<std::string>();
    const ParameterEntry before = entry;
    if (entry.isType<TwoDArray<std::string>>() && kind == Kind::Points)
      entry.setValue(table(getValue<TwoDArray<std::string>>(entry), place));
    else if (alone && (kind == Kind::Real || kind == Kind::Reals))
      entry.setValue(real(getValue<std::string>(entry), place));
    else if (alone && whole)
      entry.setValue(count(getValue<std::string>(entry), place));
    else if (entry.isType<Array<std::string>>() && kind == Kind::Reals)
      entry.setValue(each(getValue<Array<std::string>>(entry), place, &Evaluation::real));
    else if (entry.isType<Array<std::string>>() && whole)
      entry.setValue(
          each(getValue<Array<std::string>>(entry), place, &Evaluation::count));
    else
      return;
    found.emplace_back(place, before);
  }

  double real(const std::string& text, const std::string& place) const {
    return evaluateConstant(text, {file_, place}, names_);
  }

  int count(const std::string& text, const std::string& place) const {
    const double value = real(text, place);
    constexpr double largest = std::numeric_limits<int>::max();
    if (value != std::round(value) || std::abs(value) > largest)
      throw bem::InputError(place, " = '", text, "' is ", bem::shortest(value));
    return static_cast<int>(value);
  }

  template <class Number>
  Array<Number> each(const Array<std::string>& texts, const std::string& place,
                     Number (Evaluation::*value)(const std::string&, const std::string&)
                         const) const {
    Array<Number> numbers;
    for (const std::string& text : texts)
      numbers.push_back((this->*value)(text, place));
    return numbers;
  }

  TwoDArray<double> table(const TwoDArray<std::string>& texts,
                          const std::string& place) const {
    TwoDArray<double> numbers(texts.getNumRows(), texts.getNumCols());
    for (int i = 0; i < texts.getNumRows(); ++i)
      for (int j = 0; j < texts.getNumCols(); ++j)
        numbers(i, j) = real(texts(i, j), place);
    return numbers;
  }

  const std::string& file_;
  const Names& names_;
};

}  // namespace

Entries evaluateNumbers(ParameterList& scene, const std::string& file,
                        const Names& names) {
  Evaluation evaluation(file, names);
  evaluation.visit(scene, "");
  return std::move(evaluation.found);
}

void putBack(const Entries& entries, ParameterList& scene) {
  for (const auto& [path, entry] : entries) {
    ParameterList* list = &scene;
    std::size_t at = 0;
    for (auto end = path.find(bem::arrow); end != std::string::npos;
         end = path.find(bem::arrow, at)) {
      list = &list->sublist(path.substr(at, end - at));
      at = end + std::strlen(bem::arrow);
    }
    list->setEntry(path.substr(at), entry);
  }
}

}  // namespace epafi::drivers
