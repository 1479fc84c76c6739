#pragma once

#include "contact/stabilization/StabilisedStiffness.hpp"

#include <memory>

namespace epafi::contact {

class Opposite;

/// Data of a body and of the multiplier on it.
struct BodyInput {
  const bem::Space& space;                ///< must outlive the problem
  const bem::SteklovPoincare& stiffness;  ///< must outlive the problem
  const bem::Lame& lame;
  bem::Units units;
  const Conditions& conditions;  ///< must outlive the problem
  const MultiplierBasis& basis;
  Stabilization stabilization;
  /// Opposite sides of its contact sides, bodies numbered as in the problem; null: obstacles at
  /// the gap of the conditions.
  std::shared_ptr<const Opposite> opposite{};
  /// With compressed operators, the largest number of multiplier coefficients of all bodies for
  /// which D is formed, since this is then cheaper than eliminations in the tree.
  Index formedUpTo = 1000;
};

}  // namespace epafi::contact
