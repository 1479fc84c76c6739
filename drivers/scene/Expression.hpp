#pragma once

#include "bem/base/Function.hpp"
#include "drivers/scene/Interpolant.hpp"

#include <functional>
#include <map>
#include <string>

namespace epafi::drivers {

/// Place of a text in the scene, for messages.
struct Place {
  std::string file;
  std::string path;  ///< A->B->Key
};

/// Named numbers of the scene.
using Constants = std::map<std::string, double>;

/// Names that expressions may use besides x, y and pi.
struct Names {
  Constants constants = {};
  double t = 1;
  /// The outward unit normal (nx, ny) at a point; empty: not on a boundary.
  std::function<bem::Vec2(bem::Vec2)> normal = {};
  Tables tables = {};
};

/// A function of x and y from its muParser expression.
///
/// Known: x, y, t, pi, nx, ny on a boundary, the scene's constants and tables; + - * / ^,
/// ?:, < > <= >= == !=, && ||; sin cos tan asin acos atan sinh cosh tanh asinh acosh
/// atanh, exp, sqrt, ln = log, log2, log10, abs, sign, rint, min, max, sum, avg, atan2.
/// Nothing can be assigned.  May be called from several threads at once.
/// \throws bem::InputError if it is not an expression; the function throws it where the
///   value is not one finite number, naming file, path, expression and point.
bem::Function makeExpression(const std::string& text, const Place& place,
                             const Names& names = {});

/// The value of an expression in t, the constants and the tables alone.
/// \throws bem::InputError if it is none, or not one finite number.
double evaluateAt(double t, const std::string& text, const Place& place,
                  const Names& names);

/// The value of an expression in the constants and the tables alone.
/// \throws bem::InputError as evaluateAt.
double evaluateConstant(const std::string& text, const Place& place, const Names& names);

/// A list of constants; each may use those that stand before it, and the tables.
/// \throws bem::InputError for a name that is not valid or already in use, and for a value
///   that is not one finite number
Constants readConstants(const Teuchos::ParameterList& list, const Place& place,
                        const Tables& tables);

/// Reads the list Tables of a scene; points take the place of files' names in it.
/// \throws bem::InputError for names as readConstants, and what readTable throws.
Tables readTables(Teuchos::ParameterList& list, const Place& place);

}  // namespace epafi::drivers
