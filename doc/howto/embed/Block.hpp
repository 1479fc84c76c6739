#pragma once

#include "bem/base/Material.hpp"
#include "bem/operators/SteklovPoincare.hpp"
#include "bem/space/Space.hpp"
#include "contact/system/ContactSystem.hpp"

namespace embed {

/// A square elastic block of side 1 and the operator S on its boundary.
struct Block {
  explicit Block(int elementsPerSide);

  epafi::bem::Material material;
  epafi::bem::Lame lame;
  epafi::bem::Space space;
  epafi::bem::Units units;
  epafi::bem::SteklovPoincare stiffness;
};

/// The block pulled apart sideways by a stress of 1.
epafi::contact::Conditions pulled();

/// The block pressed onto a rigid foundation, where it spreads against Coulomb's
/// friction.
epafi::contact::Conditions pressed();

}  // namespace embed
