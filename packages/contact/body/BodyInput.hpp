#pragma once

#include "contact/stabilization/StabilisedStiffness.hpp"

#include <memory>

namespace epafi::contact {

class Opposite;

/// What a body and the multiplier on it are made of.
struct BodyInput {
  const bem::Space& space;                ///< must outlive the problem
  const bem::SteklovPoincare& stiffness;  ///< must outlive the problem
  const bem::Lame& lame;
  bem::Units units;
  const Conditions& conditions;  ///< must outlive the problem
  const MultiplierBasis& basis;
  Stabilization stabilization;
  /// What its contact sides meet, in the order of the problem's bodies; null: obstacles at
  /// the distances that the conditions say.
  std::shared_ptr<const Opposite> opposite{};
  /// Up to so many multipliers of all bodies D is formed where operators are compressed:
  /// sweeps, pivots and steps with entries then cost less than eliminations in the tree.
  Index formedUpTo = 1000;
};

}  // namespace epafi::contact
