#include "drivers/scene/NestingCheck.hpp"

#include "bem/base/Error.hpp"

namespace epafi::drivers {

namespace {

constexpr int deepest = 1000;

void checkDepth(int depth) {
  if (depth > deepest)
    throw bem::InputError("lists stand in lists more than ", deepest, " deep");
}

/// Where a tag's '>' is, the one behind its attributes' quotes; or the text's size.
std::size_t endOfTag(const std::string& text, std::size_t at) {
  for (char quote = 0; at < text.size() && (quote != 0 || text[at] != '>'); ++at)
    if (quote == 0 && (text[at] == '"' || text[at] == '\''))
      quote = text[at];
    else if (text[at] == quote)
      quote = 0;
  return at;
}

}  // namespace

void checkNestingOfXml(const std::string& text) {
  int depth = 0;
  for (std::size_t at = text.find('<'); at < text.size(); at = text.find('<', at)) {
    if (text.compare(at, 4, "<!--") == 0) {
      at = text.find("-->", at);
      continue;
    }
    const std::size_t end = endOfTag(text, at + 1);
    const char first = text[at + 1];
    const bool opens = first != '!' && first != '?' && text[end - 1] != '/';
    checkDepth(depth += first == '/' ? -1 : opens ? 1 : 0);
    at = end;
  }
}

}  // namespace epafi::drivers
