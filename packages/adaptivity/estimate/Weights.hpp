#pragma once

#include "adaptivity/estimate/ContactTerms.hpp"
#include "adaptivity/estimate/Indicators.hpp"
#include "bem/base/Family.hpp"
#include "bem/base/Material.hpp"

#include <string>
#include <vector>

namespace epafi::adaptivity {

/// Bound of the violations of the contact conditions.
enum class Bounds {
  Printed,  ///< as in [P sec. 8], by λʰ
  Sharp     ///< by sharpContactTerms(), with equivalentMultiplier()
};

/// Factors by which contributions of different units are added.
struct Weights {
  const char* name;
  const char* meaning;
  /// Factors of the dimensionless squares, one per source.
  Contributions (*factors)(const bem::Lame& lame, bem::Units units);
  Bounds bounds;
};

/// All weights.  To add one: a line in Weights.cpp, or add() in a program.
bem::Family<Weights>& weightings();

}  // namespace epafi::adaptivity
