#include "drivers/run/Level.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace epafi::drivers {

double Level::timeOf(const SolvedState& step, double end) const {
  return !onPath() ? end : path.empty() ? step.t : std::min(step.t, path.back().t);
}

adaptivity::Contributions Level::squares() const {
  adaptivity::Contributions sums{};
  for (const adaptivity::Indicators& ofBody : indicators) {
    const adaptivity::Contributions own = ofBody.sums();
    std::transform(own.begin(), own.end(), sums.begin(), sums.begin(), std::plus<>());
  }
  return sums;
}

double Level::estimate() const {
  if (indicators.size() == 1)
    return indicators.front().estimate();
  double sum = 0;
  for (const double square : squares())
    sum += square;
  return std::sqrt(sum);
}

std::size_t Level::elements() const {
  std::size_t sum = 0;
  for (const std::vector<bem::Piece>& pieces : meshes)
    sum += pieces.size();
  return sum;
}

contact::Summary wholeOf(const Symmetry& symmetry, contact::Summary half,
                         bem::Vec2 pole) {
  using contact::Summary;
  if (!symmetry)
    return half;
  for (const auto member :
       {&Summary::energyStrain, &Summary::energyLoad, &Summary::forceNormal,
        &Summary::contactLength, &Summary::contactLengthError, &Summary::slipLength,
        &Summary::wornVolume})
    half.*member *= 2;
  for (const auto member : {&Summary::load, &Summary::inside, &Summary::contact,
                            &Summary::obstacle, &Summary::reaction}) {
    bem::Vec2 force = 2 * bem::Vec2{(half.*member).x, (half.*member).y};
    symmetry.across(force) = 0;
    half.*member = {force.x, force.y, -cross(pole, force)};
  }
  half.forceTangential = 0;  // the image turns t round
  symmetry.across(half.motion.slide) = 0;
  half.motion.turn = 0;
  return half;
}

contact::Summary wholeOf(const Symmetry& symmetry, const bem::Outline& outline,
                         const contact::Summary& drawn, bem::Vec2 pole) {
  return symmetry.cuts(outline) ? wholeOf(symmetry, drawn, pole) : drawn;
}

}  // namespace epafi::drivers
