#pragma once

#include "bem/base/Function.hpp"

#include <string>

namespace epafi::drivers {

/// Where a text of the scene stands, for messages.
struct Place {
  std::string file;
  std::string path;  ///< A->B->Key
};

/// A function of x and y from its muParser expression at a time t.
///
/// Known: x, y, t, pi; + - * / ^, ?:, < > <= >= == !=, && ||; sin cos tan asin acos atan
/// sinh cosh tanh asinh acosh atanh, exp, sqrt, ln = log, log2, log10, abs, sign, rint,
/// min, max, sum, avg, atan2.  Nothing can be assigned.  May be called from several
/// threads at once.
/// \throws bem::InputError if it is not an expression; the function throws it where the
///   value is not one finite number, naming file, path, expression and point.
bem::Function makeExpression(const std::string& text, const Place& place, double t = 1);

}  // namespace epafi::drivers
