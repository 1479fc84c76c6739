#pragma once

#include "contact/law/FrictionLaw.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"

#include <limits>
#include <memory>
#include <vector>

namespace epafi::contact {

using bem::Index;
using bem::Vector;

/// A slip bound, and its derivative by the pressure at its place: as a row sees them, and as its
/// Jacobian is to see them.
struct StepBound {
  double value = 0;
  double slope = 0;
};

/// A tangential coefficient of the multiplier and what limits it, m times
///
///   s_i = s(λ_i⁺),   the law at the coefficient's own place.       doc/theory/multipliers.md
class Tangential {
 public:
  Tangential() = default;
  /// \param normal the normal coefficient at the same place
  Tangential(Index normal, PointLaw law) : normal_(normal), law_(std::move(law)) {}

  /// Either component of a bonded place: held, with any force.
  static Tangential tied() { return {none, {}}; }
  bool isTied() const { return normal_ == none; }

  /// \pre not tied.
  Index normal() const { return normal_; }

  /// s >= 0; `pressures` begins with those of all normal coefficients.
  double bound(const Vector& pressures) const;

  /// ds/dλ; at a kink one of its limits.
  double slope(const Vector& pressures) const;

  bool followsPressure() const { return law_.followsPressure(); }
  /// Is there a pressure at which s > 0?
  bool carries() const;
  /// s <= s(0) + steepest() λ_n, see PointLaw.
  double steepest() const { return factor_ * law_.steepest(); }
  /// s where there is no pressure at all.
  double boundWithoutPressure() const;

  /// The same among more normal coefficients, of which so many come before its own.
  Tangential shifted(Index normals) const;

  /// With m times as large; factor >= 0.
  Tangential scaled(double factor) const;

 private:
  static constexpr Index none = std::numeric_limits<Index>::min();
  Index normal_ = 0;
  PointLaw law_;
  double factor_ = 1;  // m
};

/// The tangential coefficients of one element under a law.
///
/// `fields`: the values of the law's fields at t in [-1, 1]; `normals`: the element's normal
/// coefficients, one for each function of the basis; `stress`: the unit of stresses.  Fields become
/// coefficients of the basis, see boundCoefficients.
std::vector<Tangential> elementTangentials(const MultiplierBasis& basis,
                                           const std::vector<Index>& normals,
                                           const std::shared_ptr<const FrictionLaw>& law,
                                           const std::function<Vector(double)>& fields,
                                           double stress);

}  // namespace epafi::contact
