#include "drivers/run/Level.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace epafi::drivers {

adaptivity::Contributions Level::squares() const {
  adaptivity::Contributions sums{};
  for (const BodyLevel& body : bodies) {
    const adaptivity::Contributions own = body.indicators.sums();
    std::transform(own.begin(), own.end(), sums.begin(), sums.begin(), std::plus<>());
  }
  return sums;
}

double Level::estimate() const {
  if (bodies.size() == 1)
    return bodies.front().indicators.estimate();
  double sum = 0;
  for (const double square : squares())
    sum += square;
  return std::sqrt(sum);
}

std::vector<StepFields> Level::solved() const {
  if (!steps.empty())
    return steps;
  StepFields only;
  only.rigid = rigid;
  for (const BodyLevel& body : bodies) {
    only.displacement.push_back(body.displacement);
    only.density.push_back(body.density);
    only.states.push_back(body.states);
  }
  return {only};
}

std::size_t Level::elements() const {
  std::size_t sum = 0;
  for (const BodyLevel& body : bodies)
    sum += body.pieces.size();
  return sum;
}

Size& Size::operator+=(const Size& other) {
  elements += other.elements;
  displacements += other.displacements;
  multipliers += other.multipliers;
  densities += other.densities;
  degreeMin = std::min(degreeMin, other.degreeMin);
  degreeMax = std::max(degreeMax, other.degreeMax);
  sizeMin = std::min(sizeMin, other.sizeMin);
  sizeMax = std::max(sizeMax, other.sizeMax);
  return *this;
}

Size sizeOf(const bem::Space& space, const contact::MultiplierSpace& multiplier,
            const contact::Conditions& conditions) {
  const bem::Mesh& mesh = space.mesh();
  const auto& elements = mesh.elements();
  const auto [lowest, highest] = std::minmax_element(
      elements.begin(), elements.end(),
      [](const auto& a, const auto& b) { return a.degree < b.degree; });
  const auto [shortest, longest] =
      std::minmax_element(elements.begin(), elements.end(),
                          [](const auto& a, const auto& b) { return a.half < b.half; });
  const double diameter = mesh.outline().scaling().length;
  return {mesh.size(),
          contact::freeDisplacements(space, conditions),
          multiplier.size(),
          space.densities(),
          lowest->degree,
          highest->degree,
          2 * shortest->half * diameter,
          2 * longest->half * diameter};
}

namespace {

/// With the moment about a point, of a force on the line through the origin.
contact::Resultant wholeOf(const Symmetry& symmetry, const contact::Resultant& half,
                           bem::Vec2 pole) {
  bem::Vec2 force{2 * half.x, 2 * half.y};
  symmetry.across(force) = 0;
  return {force.x, force.y, -cross(pole, force)};
}

}  // namespace

contact::Summary wholeOf(const Symmetry& symmetry, contact::Summary half) {
  using contact::Summary;
  if (!symmetry)
    return half;
  for (const auto member :
       {&Summary::energyStrain, &Summary::energyLoad, &Summary::forceNormal,
        &Summary::contactLength, &Summary::slipLength, &Summary::wornVolume})
    half.*member *= 2;
  for (const auto member : {&Summary::load, &Summary::inside, &Summary::contact,
                            &Summary::obstacle, &Summary::reaction})
    half.*member = wholeOf(symmetry, half.*member, {});
  half.forceTangential = 0;  // the image turns t round
  symmetry.across(half.motion.slide) = 0;
  half.motion.turn = 0;
  return half;
}

contact::Summary wholeOf(const Symmetry& symmetry, const bem::Outline& outline,
                         const contact::Summary& drawn) {
  return symmetry.cuts(outline) ? wholeOf(symmetry, drawn) : drawn;
}

std::vector<contact::Summary> wholeBodies(const Scene& scene,
                                          std::vector<contact::Summary> drawn) {
  for (std::size_t b = 0; b < drawn.size(); ++b)
    drawn[b] = wholeOf(scene.symmetry, *scene.bodies[b].outline, drawn[b]);
  return drawn;
}

RigidRow wholeOf(const Symmetry& symmetry, const bem::Outline& outline, RigidRow drawn) {
  if (symmetry.cuts(outline))
    for (const auto member :
         {&RigidRow::load, &RigidRow::reaction, &RigidRow::contact, &RigidRow::inside})
      drawn.*member = wholeOf(symmetry, drawn.*member, drawn.pole);
  return drawn;
}

}  // namespace epafi::drivers
