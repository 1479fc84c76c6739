#include "drivers/run/Whole.hpp"

namespace epafi::drivers {

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
