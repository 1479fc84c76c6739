#include "Block.hpp"

#include <cmath>

namespace embed {

namespace bem = epafi::bem;
namespace contact = epafi::contact;
using bem::Vec2;

namespace {

bem::Material steelLike() {
  bem::Material material;
  material.youngsModulus = 5;
  material.poissonsRatio = 0.45;
  return material;
}

// Counter-clockwise; edge i runs from vertex i to i+1.
bem::Mesh squareMesh(int elementsPerSide) {
  const bem::Loop square{{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}},
                         {"foundation", "right", "top", "left"}};
  const int n = elementsPerSide;
  return bem::makeMesh(std::make_shared<bem::Outline>(square), {n, n, n, n}, 1);
}

double zero(Vec2) { return 0; }

}  // namespace

Block::Block(int elementsPerSide)
    : material(steelLike()),
      lame(material),
      space(squareMesh(elementsPerSide)),
      units{space.mesh().outline().diameter(), material.youngsModulus},
      stiffness(bem::assembleOperators(space, lame)) {}

contact::Conditions pulled() {
  contact::Conditions conditions;
  conditions.neumann["right"] = {[](Vec2) { return 1.0; }, zero};
  conditions.neumann["left"] = {[](Vec2) { return -1.0; }, zero};
  return conditions;
}

contact::Conditions pressed() {
  const auto press = [](Vec2 x) { return -(1 + std::cos(2 * x.x)); };

  contact::Conditions conditions;
  conditions.neumann["top"] = {zero, press};
  conditions.contact["foundation"] = {
      zero, contact::makeFriction("Coulomb", {[](Vec2) { return 0.3; }})};
  conditions.fix.x = true;
  conditions.fix.rotation = true;
  return conditions;
}

}  // namespace embed
