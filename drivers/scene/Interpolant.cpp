#include "drivers/scene/Interpolant.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Named.hpp"
#include "drivers/scene/SceneFile.hpp"
#include "drivers/scene/Text.hpp"

#include <Teuchos_LAPACK.hpp>
#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <boost/math/interpolators/cubic_hermite.hpp>
#include <boost/math/interpolators/makima.hpp>
#include <limits>

namespace epafi::drivers {

namespace {

using bem::InputError;

std::function<double(double)> linear(std::vector<double> x, std::vector<double> values) {
  return [x = std::move(x), values = std::move(values)](double at) {
    const auto next = std::upper_bound(x.begin() + 1, x.end() - 1, at);
    const std::size_t i = next - x.begin();
    const double share = (at - x[i - 1]) / (x[i] - x[i - 1]);
    return (1 - share) * values[i - 1] + share * values[i];
  };
}

std::function<double(double)> cubic(std::vector<double> x, std::vector<double> values) {
  using boost::math::interpolators::makima;
  return makima<std::vector<double>>(std::move(x), std::move(values));
}

/// Slopes of the "not a knot" spline: second derivatives are continuous at all points,
/// third derivatives at the second and the last but one.  Exact for cubic functions.
std::vector<double> splineSlopes(const std::vector<double>& x,
                                 const std::vector<double>& values) {
  const std::size_t last = x.size() - 1;
  const auto width = [&x](std::size_t i) { return x[i + 1] - x[i]; };
  const auto slope = [&](std::size_t i) {
    return (values[i + 1] - values[i]) / width(i);
  };
  // right-hand side at an end; h, next: widths of the end intervals, s, nextS: slopes
  const auto atEnd = [](double h, double next, double s, double nextS) {
    return ((3 * h + 2 * next) * next * s + h * h * nextS) / (h + next);
  };
  std::vector<double> below(last);
  std::vector<double> diagonal(last + 1);
  std::vector<double> above(last);
  std::vector<double> slopes(last + 1);
  diagonal[0] = width(1);
  above[0] = width(0) + width(1);
  slopes[0] = atEnd(width(0), width(1), slope(0), slope(1));
  for (std::size_t i = 1; i < last; ++i) {
    below[i - 1] = width(i);
    diagonal[i] = 2 * (width(i - 1) + width(i));
    above[i] = width(i - 1);
    slopes[i] = 3 * (width(i) * slope(i - 1) + width(i - 1) * slope(i));
  }
  diagonal[last] = width(last - 2);
  below[last - 1] = width(last - 1) + width(last - 2);
  slopes[last] =
      atEnd(width(last - 1), width(last - 2), slope(last - 1), slope(last - 2));

  const int n = static_cast<int>(x.size());
  std::vector<double> second(x.size());
  std::vector<int> pivots(x.size());
  int info = 0;
  const Teuchos::LAPACK<int, double> lapack;
  lapack.GTTRF(n, below.data(), diagonal.data(), above.data(), second.data(),
               pivots.data(), &info);
  if (info == 0)
    lapack.GTTRS('N', n, 1, below.data(), diagonal.data(), above.data(), second.data(),
                 pivots.data(), slopes.data(), n, &info);
  if (info != 0)
    throw InputError(
        "has points too unevenly spaced for a spline; choose Linear or Cubic");
  return slopes;
}

std::function<double(double)> spline(std::vector<double> x, std::vector<double> values) {
  using boost::math::interpolators::cubic_hermite;
  std::vector<double> slopes = splineSlopes(x, values);
  return cubic_hermite<std::vector<double>>(std::move(x), std::move(values),
                                            std::move(slopes));
}

void check(const std::vector<double>& x, const std::vector<double>& values,
           std::size_t fewest) {
  if (x.size() < fewest)
    throw InputError("has ", x.size(), " points; at least ", fewest, " are needed");
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(x[i]) || !std::isfinite(values[i]))
      throw InputError("point ", i, " = (", x[i], ", ", values[i], ") is not finite");
    if (i > 0 && !(x[i] > x[i - 1]))
      throw InputError("point ", i, " is at ", x[i], ", the one before it at ", x[i - 1],
                       "; they must rise");
  }
}

void expandFile(Teuchos::ParameterList& list, const std::string& sceneFile) {
  if (list.isParameter("File") == list.isParameter("Points"))
    throw InputError("give Points or File, one of them");
  if (!list.isParameter("File"))
    return;
  const auto name = list.get<std::string>("File");
  const std::string file = within("File: ", [&] { return namedFile(name, sceneFile); });
  within(bem::message("File = '", name, "' (", file, "): "),
         [&] { bem::setPoints(list, "Points", pairsIn(readText(file), true)); });
  list.remove("File");
}

constexpr bem::Named<Interpolant::Interpolation> interpolations[] = {
    {"Linear", Interpolant::Interpolation::Linear},
    {"Cubic", Interpolant::Interpolation::Cubic},
    {"Spline", Interpolant::Interpolation::Spline},
};

}  // namespace

Interpolant::Interpolant(std::vector<double> x, std::vector<double> values,
                         Interpolation interpolation) {
  check(x, values, interpolation == Interpolation::Linear ? 2 : 4);
  low_ = x.front();
  high_ = x.back();
  const auto through = interpolation == Interpolation::Linear  ? linear
                       : interpolation == Interpolation::Cubic ? cubic
                                                               : spline;
  inside_ = through(std::move(x), std::move(values));
}

double Interpolant::operator()(double x) const {
  return x >= low_ && x <= high_ ? inside_(x) : std::numeric_limits<double>::quiet_NaN();
}

bem::SchemaRows tableRows() {
  using bem::Kind;
  using bem::Row;
  return {
      Row("File", Kind::Text,
          "a point a line, two numbers with a comma, a semicolon or blanks between them, "
          "under a heading or none; relative to the scene"),
      Row("Points", Kind::Points, "instead of File: argument and value of each point"),
      Row("Interpolation", Kind::Text,
          "between the points; Cubic (modified Akima) has no corners and hardly "
          "overshoots; Spline has continuous curvature, which the pressure under a "
          "profile asks for")
          .defaultValue(interpolations[0].name)
          .allowed(bem::namesOf(interpolations)),
  };
}

std::shared_ptr<const Interpolant> readTable(Teuchos::ParameterList& list,
                                             const std::string& sceneFile) {
  expandFile(list, sceneFile);
  std::vector<double> x;
  std::vector<double> values;
  for (const bem::Vec2 point : bem::pointsIn(list, "Points")) {
    x.push_back(point.x);
    values.push_back(point.y);
  }
  return std::make_shared<const Interpolant>(
      std::move(x), std::move(values),
      bem::named(interpolations, list.get<std::string>("Interpolation")));
}

}  // namespace epafi::drivers
