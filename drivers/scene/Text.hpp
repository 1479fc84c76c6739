#pragma once

#include "bem/base/Error.hpp"
#include "bem/base/Vec2.hpp"

#include <charconv>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace epafi::drivers {

using bem::within;

/// The number that the whole text spells; nothing if it is not a number.
template <class Number>
std::optional<Number> numberIn(const std::string& text) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}

/// Likewise of a finite number, also with a plus sign.
std::optional<double> finiteIn(const std::string& text);

/// The narrowest of the types int, double, bool and string that a text has a value of.
std::string narrowestType(const std::string& text);

/// The two numbers that begin each line of a text, with commas, semicolons or blanks between
/// them, in quotes or not, under headings or none; # begins a comment.
/// \param alone  nothing may follow them
/// \throws bem::InputError with the line
std::vector<bem::Vec2> pairsIn(const std::string& text, bool alone);

/// The text without white space of XML at both ends.
std::string trimmed(const std::string& text);

/// Index of the first byte that is not UTF-8; npos if there is none.
std::size_t notUtf8At(const std::string& text);

/// What keeps a name in a file from being one in a scene; empty if nothing does.
std::string whyNoName(const std::string& name);

/// "1 step", "2 steps"
std::string counted(std::size_t count, const std::string& one, const std::string& many);

/// A text in quotes, as JSON and YAML read it.
std::string jsonText(const std::string& text);

/// A text as one word of a POSIX shell: unchanged if it has no special characters, else
/// in single quotes.
std::string shellWord(const std::string& text);

/// Splits "a, f(b, c), {d, e}" at commas outside of parentheses and braces; at every
/// comma if these are not balanced.
std::vector<std::string> pieces(const std::string& text);

/// Are braces and parentheses balanced?
bool isBalanced(const std::string& text);

}  // namespace epafi::drivers
