#include "drivers/scene/Text.hpp"

#include <algorithm>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <boost/locale/utf.hpp>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace epafi::drivers {

namespace {

int change(char c) {
  if (c == '(' || c == '{')
    return 1;
  return c == ')' || c == '}' ? -1 : 0;
}

}  // namespace

std::optional<double> finiteIn(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool isWhole = !text.empty() && end == text.c_str() + text.size();
  return isWhole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string narrowestType(const std::string& text) {
  const std::string unsignedText = text.substr(text.find_first_of("+-") == 0 ? 1 : 0);
  if (numberIn<int>(unsignedText))
    return "int";
  // includes numbers out of range, for which realIn has a better message
  if (unsignedText.find_first_of(".0123456789") == 0 &&
      text.find_first_not_of("0123456789+-.eE") == std::string::npos)
    return "double";
  return text == "true" || text == "false" ? "bool" : "string";
}

std::vector<bem::Vec2> pairsIn(const std::string& text, bool alone) {
  std::vector<bem::Vec2> pairs;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::string blank = line.substr(0, line.find('#'));
    std::replace_if(blank.begin(), blank.end(), boost::is_any_of(",;\""), ' ');
    std::istringstream words(blank);
    std::vector<std::optional<double>> found;
    for (std::string word; words >> word;)
      found.push_back(finiteIn(word));
    const bool isHeading =
        pairs.empty() && std::count(found.begin(), found.end(), std::nullopt) ==
                             static_cast<std::ptrdiff_t>(found.size());
    if (found.empty() || isHeading)
      continue;
    if (found.size() < 2 || !found[0] || !found[1] || (alone && found.size() > 2))
      throw bem::InputError("line ", number, alone ? " is not" : " does not begin with",
                            " two numbers: '", line, "'");
    pairs.push_back({*found[0], *found[1]});
  }
  return pairs;
}

std::string trimmed(const std::string& text) {
  return boost::algorithm::trim_copy_if(text, boost::algorithm::is_any_of(" \t\r\n"));
}

std::size_t notUtf8At(const std::string& text) {
  for (auto at = text.begin(); at != text.end();) {
    const auto start = at;
    if (boost::locale::utf::utf_traits<char>::decode(at, text.end()) >
        boost::locale::utf::code_point{0x10FFFF})
      return static_cast<std::size_t>(start - text.begin());
  }
  return std::string::npos;
}

std::string whyNoName(const std::string& name) {
  const bool isUtf8 = notUtf8At(name) == std::string::npos;
  const auto isControl = [](unsigned char c) { return std::iscntrl(c) != 0; };
  if (isUtf8 && std::none_of(name.begin(), name.end(), isControl))
    return "";
  std::string shown = name;
  std::replace_if(
      shown.begin(), shown.end(), [](unsigned char c) { return std::isprint(c) == 0; },
      '?');
  return "the name '" + shown +
         (isUtf8
              ? "' has a control character, as a tab; rename it"
              : "' is not encoded in UTF-8; rename it, or save the file in UTF-8, as a "
                "DXF of version 2007 or later is");
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string shellWord(const std::string& text) {
  constexpr const char* plain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./+,:=@%-";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos)
    return text;
  std::string word = "'";
  for (const char c : text)
    word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

bool isBalanced(const std::string& text) {
  int depth = 0;
  for (const char c : text) {
    depth += change(c);
    if (depth < 0)
      return false;
  }
  return depth == 0;
}

std::string jsonText(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      quoted += '\\';
    if (static_cast<unsigned char>(c) >= ' ') {
      quoted += c;
      continue;
    }
    char escaped[8];  // control characters
    std::snprintf(escaped, sizeof escaped, "\\u%04x", static_cast<unsigned>(c));
    quoted += escaped;
  }
  return quoted + "\"";
}

std::vector<std::string> pieces(const std::string& text) {
  const bool nested = isBalanced(text);
  std::vector<std::string> result(1);
  int depth = 0;
  for (const char c : text) {
    depth += nested ? change(c) : 0;
    if (c == ',' && depth == 0)
      result.emplace_back();
    else
      result.back() += c;
  }
  return result;
}

}  // namespace epafi::drivers
