#include "drivers/scene/LexicalCheck.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"
#include "drivers/scene/Text.hpp"

#include <Teuchos_XMLObject.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::message;

bool isCount(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

void checkReal(const std::string& text) {
  char* stop = nullptr;
  const double value = std::strtod(text.c_str(), &stop);
  // strtod knows infinities and hexadecimal digits, too
  if (text.empty() || stop != text.c_str() + text.size() ||
      text.find_first_not_of("0123456789+-.eE") != std::string::npos)
    throw InputError("'", text, "' is not a number; write 0.5, -3 or 1e-3");
  if (!std::isfinite(value))
    throw InputError("'", text, "' is too large for a number");
  const std::string mantissa = text.substr(0, text.find_first_of("eE"));
  const bool subnormal = std::abs(value) < std::numeric_limits<double>::min();
  if (subnormal && mantissa.find_first_of("123456789") != std::string::npos)
    throw InputError("'", text, "' is too small for a number; from 2.3e-308 on, or 0");
}

void checkWhole(const std::string& text) {
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
}

void checkFlag(const std::string& text) {
  if (text != "true" && text != "false")
    throw InputError("'", text, "' is neither 'true' nor 'false'");
}

struct Scalar {
  const char* type;
  void (*check)(const std::string& text);
};

constexpr Scalar scalars[] = {
    {"int", &checkWhole},
    {"double", &checkReal},
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
    throw InputError("'", text, "' is not an array; write {a, b, c}");
  const std::string inner = trimmed(text.substr(1, text.size() - 2));
  if (inner.empty())
    return 0;
  long count = 0;
  const bool texts = std::string(scalar.type) == "string";  // may hold arrays: A={4, 4}
  for (const std::string& piece : pieces(inner)) {
    const std::string entry = trimmed(piece);
    const bool brace = entry.find_first_of("{}") != std::string::npos;
    if (entry.empty() || (brace && !(texts && isBalanced(entry))))
      throw InputError("entry ", count, " = '", entry, "' of the array is empty or ",
                       "holds a brace; write {a, b, c}");
    within(message("entry ", count, " of the array: "), [&] { scalar.check(entry); });
    ++count;
  }
  return count;
}

/// RxC:{a, b, ...}
void checkTable(const Scalar& scalar, const std::string& text) {
  const std::string size = text.substr(0, text.find(':'));
  const std::string rows = size.substr(0, size.find('x'));
  const std::string columns = size.substr(std::min(rows.size() + 1, size.size()));
  if (!isCount(rows) || !isCount(columns) || size.size() == text.size())
    throw InputError("'", text, "' is not a table; write 4x2:{a, b, ...}, row by row");
  checkWhole(rows);
  checkWhole(columns);
  const long wanted = std::stol(rows) * std::stol(columns);
  const long found = checkEntries(scalar, trimmed(text.substr(size.size() + 1)));
  if (found != wanted)
    throw InputError("a table ", size, " has ", wanted, " entries; ", found,
                     " are given");
}

std::string between(const std::string& text, const std::string& before) {
  if (text.rfind(before, 0) != 0 || text.back() != ')')
    return "";
  return text.substr(before.size(), text.size() - before.size() - 1);
}

std::string nameOf(const Teuchos::XMLObject& object, const std::string& path) {
  if (!object.hasAttribute("name") || object.getRequired("name").empty())
    throw InputError(path.empty() ? "" : path + ": ", "a ", object.getTag(),
                     " has no name; write <", object.getTag(), " name=\"...\"");
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
      throw InputError(start, "stray text '", trimmed(list.getContentLine(i)), "'");
  std::set<std::string> names;
  for (int i = 0; i < list.numChildren(); ++i) {
    const Teuchos::XMLObject& child = list.getChild(i);
    const std::string& tag = child.getTag();
    if (tag != "Parameter" && tag != "ParameterList")
      throw InputError(start, "unknown tag <", tag, ">",
                       bem::suggestion(tag, {"Parameter", "ParameterList"}));
    const std::string name = nameOf(child, path);
    const std::string inner = path.empty() ? name : message(path, "->", name);
    if (!names.insert(name).second)
      throw InputError(inner + ": given twice; keep one");
    if (tag == "ParameterList") {
      checkList(child, inner);
      continue;
    }
    within(inner + ": ", [&] { checkParameter(child); });
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
    throw InputError("unknown type '", type, "'", bem::suggestion(type, typeNames()));
}

void checkLexically(const Teuchos::XMLObject& root) {
  if (root.getTag() != "ParameterList")
    throw InputError("the root is <", root.getTag(), ">; it must be <ParameterList>");
  checkList(root, "");
}

}  // namespace epafi::drivers
