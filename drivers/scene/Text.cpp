#include "drivers/scene/Text.hpp"

#include <algorithm>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <boost/locale/utf.hpp>
#include <cctype>
#include <cstring>

namespace epafi::drivers {

namespace {

constexpr const char* signs = "{},";
constexpr const char* standIns = "\x01\x02\x03";  // not allowed in XML texts

int change(char c) {
  if (c == '(' || c == '{')
    return 1;
  return c == ')' || c == '}' ? -1 : 0;
}

}  // namespace

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

std::string hiddenEntry(std::string entry) {
  for (char& c : entry)
    if (const char* sign = std::strchr(signs, c))
      c = standIns[sign - signs];
  return entry;
}

std::string shown(const std::string& entry) {
  std::string result = entry;
  for (char& c : result)
    if (const char* sign = std::strchr(standIns, c))
      c = signs[sign - standIns];
  return result;
}

}  // namespace epafi::drivers
