#pragma once

#include "bem/base/Schema.hpp"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace epafi::drivers {

/// A function of one variable through given points: a measured profile, a course of loads.
class Interpolant {
 public:
  enum class Interpolation {
    Linear,
    Cubic,  ///< once continuously differentiable, with slopes of the modified Akima kind
    Spline  ///< cubic, twice continuously differentiable; exact for cubic functions
  };

  /// \throws bem::InputError unless x rises from point to point, all numbers are finite and
  ///   there are at least two points, four but for Linear.
  Interpolant(std::vector<double> x, std::vector<double> values,
              Interpolation interpolation);

  double low() const { return low_; }
  double high() const { return high_; }

  /// NaN outside [low(), high()].
  double operator()(double x) const;

 private:
  double low_;
  double high_;
  std::function<double(double)> inside_;
};

/// By the names under which expressions know them.
using Tables = std::map<std::string, std::shared_ptr<const Interpolant>>;

bem::SchemaRows tableRows();

/// Reads a table; the points of a file take the place of its name in the list, so that used.xml
/// needs no other file.
///
/// A file has a point a line, two numbers with a comma, a semicolon or blanks between them;
/// lines before the first point that do not begin with a number are a heading, # begins a remark.
/// \param sceneFile  relative names start from its folder
/// \throws bem::InputError for a file that is not like this, and what Interpolant throws.
std::shared_ptr<const Interpolant> readTable(Teuchos::ParameterList& list,
                                             const std::string& sceneFile);

}  // namespace epafi::drivers
