#include "drivers/run/FrictionLimit.hpp"

#include "bem/base/Error.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "contact/results/Solved.hpp"

#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace epafi::drivers {

namespace {

struct Point {
  bem::Vec2 place;
  bem::Vec2 direction;
  double share = 0;  ///< of the contact's length
  double shear = 0;
  double bound = 0;
};

/// Where sides with friction are closed, by contact.
std::map<std::string, std::vector<Point>> closedPoints(const SolvedStep& step) {
  const bem::Rule& rule = bem::gaussLegendre(8);
  std::map<std::string, std::vector<Point>> result;
  for (const contact::Solved& solved : step.bodies) {
    const contact::ContactFields fields(solved);
    const bem::Mesh& mesh = solved.space.mesh();
    const double unit = mesh.outline().units(1).measure();
    for (const auto& element : fields.elements())
      for (std::size_t q = 0; q < rule.points.size() && element.shears(); ++q) {
        const double t = rule.points[q];
        const contact::ContactPoint p = fields.at(element, t);
        if (p.closed && std::isfinite(p.bound))
          result[nameOf(element)].push_back(
              {p.place, p.direction.unit,
               rule.weights[q] * mesh.measure(element.element, t) * unit, p.shear,
               p.bound});
      }
  }
  return result;
}

}  // namespace

std::string frictionLimits(const SolvedStep& step) {
  constexpr double all = 0.99;
  constexpr double around = 0.1;
  const double copies = step.spaces.scene().symmetry.copies();
  std::string text;
  for (const auto& [name, points] : closedPoints(step)) {
    double shear = 0;
    double bound = 0;
    double length = 0;
    bem::Vec2 middle;
    bem::Vec2 directions;
    for (const Point& p : points) {
      shear += p.share * std::abs(p.shear);
      bound += p.share * p.bound;
      length += p.share;
      middle = middle + p.share * p.place;
      directions = directions + p.share * p.direction;
    }
    if (!(bound > 0) || shear < all * bound)
      continue;
    double moment = 0;
    for (const Point& p : points)
      moment += p.share * p.bound * norm(p.place - (1 / length) * middle);
    text += bem::message("all of '", name,
                         "' slips: at these pressures its friction holds at most ",
                         copies * bound,
                         norm(directions) < around * length
                             ? bem::message(", a moment of ", copies * moment)
                             : "",
                         ".  ");
  }
  return text;
}

}  // namespace epafi::drivers
