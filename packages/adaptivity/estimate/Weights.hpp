#pragma once

#include "adaptivity/estimate/ContactTerms.hpp"
#include "adaptivity/estimate/Indicators.hpp"
#include "bem/base/Family.hpp"
#include "bem/base/Material.hpp"

#include <string>
#include <vector>

namespace epafi::adaptivity {

/// How violations of the contact conditions are bounded.
enum class Bounds {
  Printed,  ///< as in [P sec. 8], by λʰ
  Sharp     ///< by sharpContactTerms of an equivalentMultiplier
};

/// How contributions of different units are added up.
struct Weights {
  const char* name;
  const char* meaning;
  /// Factors that the dimensionless squares are multiplied by.
  Contributions (*factors)(const bem::Lame& lame, bem::Units units);
  Bounds bounds;
};

/// All weights.  A new one is one line in Weights.cpp, or added by a program.
bem::Family<Weights>& weightings();

}  // namespace epafi::adaptivity
