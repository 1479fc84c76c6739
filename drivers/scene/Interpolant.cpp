#include "drivers/scene/Interpolant.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Named.hpp"
#include "drivers/scene/SceneFile.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_TwoDArray.hpp>

#include <algorithm>
#include <boost/math/interpolators/makima.hpp>
#include <filesystem>
#include <limits>
#include <sstream>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::message;
using Points = Teuchos::TwoDArray<double>;

std::function<double(double)> linear(std::vector<double> x, std::vector<double> values) {
  return [x = std::move(x), values = std::move(values)](double at) {
    const auto next = std::upper_bound(x.begin() + 1, x.end() - 1, at);
    const auto i = static_cast<std::size_t>(next - x.begin());
    const double share = (at - x[i - 1]) / (x[i] - x[i - 1]);
    return (1 - share) * values[i - 1] + share * values[i];
  };
}

std::function<double(double)> cubic(std::vector<double> x, std::vector<double> values) {
  using boost::math::interpolators::makima;
  return makima<std::vector<double>>(std::move(x), std::move(values));
}

void check(const std::vector<double>& x, const std::vector<double>& values,
           std::size_t fewest) {
  if (x.size() < fewest)
    throw InputError(
        message("has ", x.size(), " points; at least ", fewest, " are needed"));
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(x[i]) || !std::isfinite(values[i]))
      throw InputError(
          message("point ", i, " = (", x[i], ", ", values[i], ") is not finite"));
    if (i > 0 && !(x[i] > x[i - 1]))
      throw InputError(message("point ", i, " is at ", x[i], ", the one before it at ",
                               x[i - 1], "; they must rise"));
  }
}

/// Two numbers, or nothing if the line is empty or a remark.
std::vector<double> numbersOf(std::string line, bool& isText) {
  line.erase(std::find(line.begin(), line.end(), '#'), line.end());
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == ',' || c == ';'; }, ' ');
  std::istringstream words(line);
  std::vector<double> numbers;
  for (double number = 0; words >> number;)
    numbers.push_back(number);
  isText = !words.eof();
  return numbers;
}

Points readPoints(const std::string& text) {
  std::vector<double> all;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    bool isText = false;
    const std::vector<double> numbers = numbersOf(line, isText);
    const bool isHeading = all.empty() && numbers.empty();
    if (isHeading || (numbers.empty() && !isText))
      continue;
    if (isText || numbers.size() != 2)
      throw InputError(message("line ", number, " is not two numbers: '", line, "'"));
    all.insert(all.end(), numbers.begin(), numbers.end());
  }
  Points points(static_cast<Points::size_type>(all.size() / 2), 2);
  for (std::size_t i = 0; i < all.size(); ++i)
    points(static_cast<Points::size_type>(i / 2), static_cast<Points::size_type>(i % 2)) =
        all[i];
  return points;
}

void expandFile(Teuchos::ParameterList& list, const std::string& sceneFile) {
  if (list.isParameter("File") == list.isParameter("Points"))
    throw InputError("give Points or File, one of them");
  if (!list.isParameter("File"))
    return;
  const auto name = list.get<std::string>("File");
  const std::string file =
      (std::filesystem::path(sceneFile).parent_path() / name).string();
  try {
    list.set("Points", readPoints(readText(file)));
  } catch (const InputError& error) {
    throw InputError(message("File = '", name, "' (", file, "): ", error.what()));
  }
  list.remove("File");
}

constexpr bem::Named<Interpolant::Interpolation> interpolations[] = {
    {"Linear", Interpolant::Interpolation::Linear},
    {"Cubic", Interpolant::Interpolation::Cubic},
};

}  // namespace

Interpolant::Interpolant(std::vector<double> x, std::vector<double> values,
                         Interpolation interpolation) {
  const bool isCubic = interpolation == Interpolation::Cubic;
  check(x, values, isCubic ? 4 : 2);
  low_ = x.front();
  high_ = x.back();
  inside_ = isCubic ? cubic(std::move(x), std::move(values))
                    : linear(std::move(x), std::move(values));
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
          "between the points; Cubic is smooth (modified Akima)")
          .standard(interpolations[0].name)
          .allowed(bem::namesOf(interpolations)),
  };
}

std::shared_ptr<const Interpolant> readTable(Teuchos::ParameterList& list,
                                             const std::string& sceneFile) {
  expandFile(list, sceneFile);
  const auto& points = list.get<Points>("Points");
  std::vector<double> x;
  std::vector<double> values;
  for (Points::size_type i = 0; i < points.getNumRows(); ++i) {
    x.push_back(points(i, 0));
    values.push_back(points(i, 1));
  }
  return std::make_shared<const Interpolant>(
      std::move(x), std::move(values),
      bem::named(interpolations, list.get<std::string>("Interpolation")));
}

}  // namespace epafi::drivers
