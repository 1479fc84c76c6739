#pragma once

#include "bem/base/Error.hpp"

#include <charconv>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace epafi::drivers {

/// The number that the whole text spells; nothing if it is not a number.
template <class Number>
std::optional<Number> numberIn(const std::string& text) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}

/// Returns work(); `where` is put before the message of an InputError.
template <class Work>
auto within(const std::string& where, const Work& work) {
  try {
    return work();
  } catch (const bem::InputError& error) {
    throw bem::InputError(where, error.what());
  }
}

/// The text without white space of XML at both ends.
std::string trimmed(const std::string& text);

/// Index of the first byte that is not UTF-8; npos if there is none.
std::size_t notUtf8At(const std::string& text);

/// What keeps a name in a file from being one in a scene; empty if nothing does.
std::string whyNoName(const std::string& name);

/// "1 step", "2 steps"
std::string counted(std::size_t count, const std::string& one, const std::string& many);

/// A text as one word of a POSIX shell: unchanged if it has no special characters, else
/// in single quotes.
std::string shellWord(const std::string& text);

/// Splits "a, f(b, c), {d, e}" at commas outside of parentheses and braces; at every
/// comma if these are not balanced.
std::vector<std::string> pieces(const std::string& text);

/// Are braces and parentheses balanced?
bool isBalanced(const std::string& text);

/// Replaces commas and braces of an entry, so that its array does not split there.
std::string hiddenEntry(std::string entry);
/// The inverse of hiddenEntry.
std::string shown(const std::string& entry);

}  // namespace epafi::drivers
