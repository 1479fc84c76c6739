#include "bem/base/Written.hpp"

#include "bem/base/Error.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterEntry.hpp>
#include <Teuchos_TwoDArray.hpp>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace epafi::bem {

namespace {

using Shape = Written::Shape;
using Teuchos::ParameterEntry;

bool flagIn(const std::string& text) {
  if (text != "true" && text != "false")
    throw InputError("'", text, "' is neither 'true' nor 'false'");
  return text == "true";
}

std::string textIn(const std::string& text) { return text; }

template <class T>
ParameterEntry entryOf(const Written& written, T (*valueIn)(const std::string& text)) {
  std::vector<T> values;
  for (const std::string& text : written.texts)
    within(written.shape == Shape::One
               ? ""
               : message("entry ", values.size(), " of the array: "),
           [&] { values.push_back(valueIn(text)); });
  if (written.shape == Shape::One)
    return ParameterEntry(T(values.front()));
  if (written.shape == Shape::Array)
    return ParameterEntry(Teuchos::Array<T>(values));
  Teuchos::TwoDArray<T> table(written.rows, written.columns);
  for (int k = 0; k < static_cast<int>(values.size()); ++k)
    table(k / written.columns, k % written.columns) = values[k];
  return ParameterEntry(table);
}

std::string spell(bool value) { return value ? "true" : "false"; }
std::string spell(int value) { return std::to_string(value); }
std::string spell(double value) { return shortest(value); }
std::string spell(const std::string& value) { return value; }

template <class T>
std::optional<Written> writtenAs(const char* type, const ParameterEntry& entry) {
  Written written{type, Shape::One, {}};
  if (entry.isType<T>()) {
    written.texts = {spell(Teuchos::getValue<T>(entry))};
    return written;
  }
  std::vector<T> values;
  if (entry.isType<Teuchos::Array<T>>()) {
    written.shape = Shape::Array;
    values = Teuchos::getValue<Teuchos::Array<T>>(entry).toVector();
  } else if (entry.isType<Teuchos::TwoDArray<T>>()) {
    const auto& table = Teuchos::getValue<Teuchos::TwoDArray<T>>(entry);
    written.shape = Shape::Table;
    written.rows = static_cast<int>(table.getNumRows());
    written.columns = static_cast<int>(table.getNumCols());
    values = table.getDataArray().toVector();
  } else {
    return std::nullopt;
  }
  for (const T& value : values)
    written.texts.push_back(spell(value));
  return written;
}

}  // namespace

std::string Written::fullType() const {
  const std::string array = shape == Shape::One ? type : "Array(" + type + ")";
  return shape == Shape::Table ? "TwoD" + array : array;
}

std::string shortest(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value);
  return {text, end.ptr};
}

double realIn(const std::string& text) {
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

int wholeIn(const std::string& text) {
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

ParameterEntry entryOf(const Written& written) {
  if (written.type == "int")
    return entryOf(written, wholeIn);
  if (written.type == "double")
    return entryOf(written, realIn);
  if (written.isText())
    return entryOf(written, textIn);
  if (written.shape != Shape::One)
    throw InputError("no key takes an array of true and false");
  return ParameterEntry(flagIn(written.texts.front()));
}

std::optional<Written> writtenIn(const ParameterEntry& entry) {
  if (entry.isType<bool>())
    return Written{"bool", Shape::One, {spell(Teuchos::getValue<bool>(entry))}};
  auto written = writtenAs<int>("int", entry);
  if (!written)
    written = writtenAs<double>("double", entry);
  return written ? written : writtenAs<std::string>("string", entry);
}

}  // namespace epafi::bem
