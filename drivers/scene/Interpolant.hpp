#pragma once

#include "bem/base/Schema.hpp"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace epafi::drivers {

/// A function of one variable through given points: a measured profile, a load history.
class Interpolant {
 public:
  enum class Interpolation {
    Linear,
    Cubic,  ///< continuous first derivative, modified Akima slopes
    Spline  ///< cubic, continuous second derivative; exact for cubic functions
  };

  /// \throws bem::InputError unless x increases strictly, all numbers are finite and
  ///   there are at least two points (Linear) or four.
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

/// Tables by the names that expressions use.
using Tables = std::map<std::string, std::shared_ptr<const Interpolant>>;

bem::SchemaRows tableRows();

/// Reads a table and replaces File in the list by the points of the file, so that
/// used.xml depends on no other file.
///
/// Each line of a file has the two numbers of a point, separated by comma, semicolon or
/// blanks.  Lines before the first point may be a heading; # begins a comment.
/// \param sceneFile  relative names of files start from its folder
/// \throws bem::InputError for a file of another form, and as Interpolant.
std::shared_ptr<const Interpolant> readTable(Teuchos::ParameterList& list,
                                             const std::string& sceneFile);

}  // namespace epafi::drivers
