#include "drivers/scene/LexicalCheck.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Parameters.hpp"
#include "drivers/scene/ArrayText.hpp"

#include <Teuchos_XMLObject.hpp>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::message;

std::string trimmed(const std::string& text) {
  const char* blank = " \t\r\n";
  const auto first = text.find_first_not_of(blank);
  if (first == std::string::npos)
    return "";
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

bool isDigit(char c) { return '0' <= c && c <= '9'; }

/// Length of the digits that start at `at`.
std::size_t digits(const std::string& text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && isDigit(text[end]))
    ++end;
  return end - at;
}

std::size_t sign(const std::string& text, std::size_t at) {
  return at < text.size() && (text[at] == '+' || text[at] == '-') ? 1 : 0;
}

/// [+-] digits [. digits] [e [+-] digits], at least one digit before the exponent.
bool spellsReal(const std::string& text) {
  std::size_t at = sign(text, 0);
  const std::size_t whole = digits(text, at);
  at += whole;
  std::size_t fraction = 0;
  if (at < text.size() && text[at] == '.') {
    fraction = digits(text, ++at);
    at += fraction;
  }
  if (whole + fraction == 0)
    return false;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    ++at;
    at += sign(text, at);
    const std::size_t exponent = digits(text, at);
    if (exponent == 0)
      return false;
    at += exponent;
  }
  return at == text.size();
}

void checkReal(const std::string& text, double largest) {
  if (!spellsReal(text))
    throw InputError(message("'", text, "' is not a number; write 0.5, -3 or 1e-3"));
  const double value = std::strtod(text.c_str(), nullptr);
  if (!(std::abs(value) <= largest))
    throw InputError(message("'", text, "' is too large for a number"));
  const std::string mantissa = text.substr(0, text.find_first_of("eE"));
  if (value == 0 && mantissa.find_first_of("123456789") != std::string::npos)
    throw InputError(message("'", text, "' is too small for a number; write 0"));
}

template <class Integer>
void checkWhole(const std::string& text) {
  const std::size_t start = !text.empty() && text[0] == '+' ? 1 : 0;
  Integer value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + start, end, value);
  if (error == std::errc::result_out_of_range)
    throw InputError(message("'", text, "' is out of range; from ",
                             std::numeric_limits<Integer>::min(), " to ",
                             std::numeric_limits<Integer>::max()));
  if (error != std::errc() || stop != end || (start == 1 && !isDigit(text[1])))
    throw InputError(message("'", text, "' is not a whole number"));
}

void checkFlag(const std::string& text) {
  if (text != "true" && text != "false")
    throw InputError(message("'", text, "' is neither 'true' nor 'false'"));
}

struct Scalar {
  const char* type;
  void (*check)(const std::string& text);
};

constexpr Scalar scalars[] = {
    {"int", &checkWhole<int>},
    {"unsigned int", &checkWhole<unsigned>},
    {"long long", &checkWhole<long long>},
    {"float",
     [](const std::string& text) { checkReal(text, std::numeric_limits<float>::max()); }},
    {"double",
     [](const std::string& text) {
       checkReal(text, std::numeric_limits<double>::max());
     }},
    {"bool", &checkFlag},
    {"string", [](const std::string&) {}},
};

const Scalar* findScalar(const std::string& type) {
  for (const Scalar& scalar : scalars)
    if (type == scalar.type)
      return &scalar;
  return nullptr;
}

std::vector<std::string> typeNames() {
  std::vector<std::string> names;
  for (const char* form : {"", "Array(", "TwoDArray("})
    for (const Scalar& scalar : scalars)
      names.push_back(std::string(form) + scalar.type + (*form == 0 ? "" : ")"));
  return names;
}

/// The entries of {a, b, c}, each checked; returns how many.
long checkEntries(const Scalar& scalar, const std::string& text) {
  if (text.size() < 2 || text.front() != '{' || text.back() != '}')
    throw InputError(message("'", text, "' is not an array; write {a, b, c}"));
  const std::string inner = trimmed(text.substr(1, text.size() - 2));
  if (inner.empty())
    return 0;
  long count = 0;
  const bool texts = std::string(scalar.type) == "string";  // may hold arrays: A={4, 4}
  for (const std::string& piece : pieces(inner)) {
    const std::string entry = trimmed(piece);
    const bool brace = entry.find_first_of("{}") != std::string::npos;
    if (entry.empty() || (brace && !(texts && isBalanced(entry))))
      throw InputError(message("entry ", count, " = '", entry,
                               "' of the array is empty or ",
                               "holds a brace; write {a, b, c}"));
    try {
      scalar.check(entry);
    } catch (const InputError& error) {
      throw InputError(message("entry ", count, " of the array: ", error.what()));
    }
    ++count;
  }
  return count;
}

/// RxC:{a, b, ...}
void checkTable(const Scalar& scalar, const std::string& text) {
  const std::size_t rows = digits(text, 0);
  const std::size_t columns = rows < text.size() ? digits(text, rows + 1) : 0;
  const std::size_t colon = rows + 1 + columns;
  if (rows == 0 || columns == 0 || text[rows] != 'x' || colon >= text.size() ||
      text[colon] != ':')
    throw InputError(
        message("'", text, "' is not a table; write 4x2:{a, b, ...}, row by row"));
  checkWhole<int>(text.substr(0, rows));
  checkWhole<int>(text.substr(rows + 1, columns));
  const long wanted =
      std::stol(text.substr(0, rows)) * std::stol(text.substr(rows + 1, columns));
  const long found = checkEntries(scalar, trimmed(text.substr(colon + 1)));
  if (found != wanted)
    throw InputError(message("a table ", text.substr(0, colon), " has ", wanted,
                             " entries; ", found, " are given"));
}

std::string between(const std::string& text, const std::string& before) {
  if (text.rfind(before, 0) != 0 || text.back() != ')')
    return "";
  return text.substr(before.size(), text.size() - before.size() - 1);
}

std::string nameOf(const Teuchos::XMLObject& object, const std::string& path) {
  if (!object.hasAttribute("name") || object.getRequired("name").empty())
    throw InputError(message(path.empty() ? "" : path + ": ", "a ", object.getTag(),
                             " has no name; write <", object.getTag(), " name=\"...\""));
  return object.getRequired("name");
}

void checkParameter(const Teuchos::XMLObject& object) {
  if (!object.hasAttribute("type"))
    throw InputError("has no type; write type=\"double\" or what fits");
  if (!object.hasAttribute("value"))
    throw InputError("has no value; write value=\"...\"");
  if (object.numChildren() > 0)
    throw InputError("is a Parameter and cannot hold others; use ParameterList");
  checkValue(object.getRequired("type"), object.getRequired("value"));
}

void checkList(const Teuchos::XMLObject& list, const std::string& path) {
  const std::string start = path.empty() ? "" : path + ": ";
  for (int i = 0; i < list.numContentLines(); ++i)
    if (!trimmed(list.getContentLine(i)).empty())
      throw InputError(
          message(start, "stray text '", trimmed(list.getContentLine(i)), "'"));
  std::set<std::string> names;
  for (int i = 0; i < list.numChildren(); ++i) {
    const Teuchos::XMLObject& child = list.getChild(i);
    const std::string& tag = child.getTag();
    if (tag != "Parameter" && tag != "ParameterList")
      throw InputError(message(start, "unknown tag <", tag, ">",
                               bem::suggestion(tag, {"Parameter", "ParameterList"})));
    const std::string name = nameOf(child, path);
    const std::string inner = path.empty() ? name : message(path, "->", name);
    if (!names.insert(name).second)
      throw InputError(inner + ": given twice; keep one");
    if (tag == "ParameterList") {
      checkList(child, inner);
      continue;
    }
    try {
      checkParameter(child);
    } catch (const InputError& error) {
      throw InputError(inner + ": " + error.what());
    }
  }
}

}  // namespace

void checkValue(const std::string& type, const std::string& value) {
  if (const Scalar* scalar = findScalar(type))
    scalar->check(type == "string" ? value : trimmed(value));
  else if (const Scalar* entry = findScalar(between(type, "Array(")))
    checkEntries(*entry, trimmed(value));
  else if (const Scalar* cell = findScalar(between(type, "TwoDArray(")))
    checkTable(*cell, trimmed(value));
  else
    throw InputError(
        message("unknown type '", type, "'", bem::suggestion(type, typeNames())));
}

void checkLexically(const Teuchos::XMLObject& root) {
  if (root.getTag() != "ParameterList")
    throw InputError(
        message("the root is <", root.getTag(), ">; it must be <ParameterList>"));
  checkList(root, "");
}

}  // namespace epafi::drivers
