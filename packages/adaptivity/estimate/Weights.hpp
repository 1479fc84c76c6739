#pragma once

#include "adaptivity/estimate/ContactTerms.hpp"
#include "adaptivity/estimate/Indicators.hpp"
#include "bem/base/Material.hpp"
#include "bem/base/Units.hpp"

#include <string>
#include <vector>

namespace epafi::adaptivity {

/// Which multiplier stands in the estimate.
enum class MultiplierChoice {
  Discrete,   ///< λʰ
  Equivalent  ///< one that does the same work, see EquivalentMultiplier
};

/// How contributions of different units are added up.
struct Weights {
  const char* name;
  const char* meaning;
  /// Factors that the dimensionless squares are multiplied by.
  Contributions (*factors)(const bem::Lame& lame, bem::Units units);
  SlipTerm slipTerm;
  MultiplierChoice multiplier;
};

/// All weights.  A new one is one line in Weights.cpp.
const std::vector<Weights>& weightings();

/// \throws bem::InputError naming the known weights.
const Weights& weighting(const std::string& name);

}  // namespace epafi::adaptivity
