#pragma once

#include "bem/base/Error.hpp"

#include <charconv>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace epafi::drivers {

/// The number that a text is, as a whole; nothing if it is none.
template <class Number>
std::optional<Number> numberIn(const std::string& text) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}

/// work(); what it complains about begins with where that is.
template <class Work>
auto within(const std::string& where, const Work& work) {
  try {
    return work();
  } catch (const bem::InputError& error) {
    throw bem::InputError(where, error.what());
  }
}

/// Without XML's white space at both ends.
std::string trimmed(const std::string& text);

/// "1 step", "2 steps"
std::string counted(std::size_t count, const std::string& one, const std::string& many);

/// A text as a POSIX shell takes it for one word: as it is where no sign means anything else
/// there, else between single quotes.
std::string shellWord(const std::string& text);

/// The pieces of "a, f(b, c), {d, e}": commas within parentheses and braces do not count,
/// unless these are not in pairs: then every comma does.
std::vector<std::string> pieces(const std::string& text);

/// Are braces and parentheses in pairs?
bool isBalanced(const std::string& text);

/// An entry of an array of texts "{A={4, 4}, B=1}" whose own commas and braces do not count.
std::string hiddenEntry(std::string entry);
/// With its own signs again.
std::string shown(const std::string& entry);

}  // namespace epafi::drivers
