#pragma once

#include "bem/base/Error.hpp"

#include <string>

namespace epafi::test {

/// What an action says that ends with an error of this kind; empty if it ends without.
template <class Error = bem::InputError, class Action>
std::string messageOf(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace epafi::test
