#pragma once

#include "bem/base/Function.hpp"
#include "contact/law/FrictionLaw.hpp"
#include "drivers/scene/Interpolant.hpp"

#include <map>
#include <optional>
#include <string>

namespace epafi::drivers {

/// Place of a text in the scene, for error messages.
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
  Tables tables = {};
  bool onBoundary = false;  ///< nx and ny: the outward unit normal at the point
  /// Is x also r and y also z?  Constants of these names go before.
  bool isAxisymmetric = false;
  bool ofPressure =
      false;  ///< pressure, of a contact; a constant of this name goes before
};

/// The names that an expression may use; each form includes those before it.
enum class Form {
  Constant,     ///< of constants that are given before it, and tables
  OfConstants,  ///< of all of them
  OfTime,       ///< of t
  OfPoint       ///< of x and y, on a boundary nx and ny
};

/// Makes a function of x and y from a muParser expression; in other forms it is the same
/// everywhere.
///
/// It may use x, y, of solids of revolution r = x, z = y, t, pi, on a boundary nx, ny, the constants and tables of the scene; +
/// - * / ^, ?:, < > <= >= == !=, && ||; sin cos tan asin acos atan sinh cosh tanh asinh
/// acosh atanh, exp, sqrt, ln = log, log2, log10, abs, sign, rint, min, max, sum, avg,
/// atan2.  Assignments are refused.  May be called from several threads at once.
/// \throws bem::InputError for an invalid expression.  The function throws it where the
///   value is not one finite number, with file, path, expression and point.
bem::Function makeExpression(const std::string& text, const Place& place,
                             const Names& names = {}, Form form = Form::OfPoint);

/// The same with `pressure`, and a function of the pressure, too; empty unless the expression uses it.
contact::PressureCoefficient makeExpressionOfPressure(const std::string& text,
                                                      const Place& place, Names names);

/// The value of an expression that is the same at all points; nothing of another one.
/// \throws bem::InputError for an invalid expression.
std::optional<double> constantIn(const std::string& text, const Place& place,
                                 const Names& names);

/// Reads a list of constants; each may use the tables and the constants before it.
/// \throws bem::InputError for a name that is invalid or already in use, and for a value
///   that is not one finite number.
Constants readConstants(const Teuchos::ParameterList& list, const Place& place,
                        const Tables& tables);

/// Reads the list Tables of a scene and replaces names of files in it by their points.
/// \throws bem::InputError for names as readConstants, and what readTable throws.
Tables readTables(Teuchos::ParameterList& list, const Place& place);

}  // namespace epafi::drivers
