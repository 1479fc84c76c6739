#pragma once

#include "contact/law/FrictionLaw.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"

#include <limits>
#include <memory>
#include <vector>

namespace epafi::contact {

using bem::Index;
using bem::Vector;

/// Slip bound of a row of Equation and its derivative by the pressure, for the Jacobian.
struct StepBound {
  double value = 0;
  double slope = 0;
};

/// Friction law of a tangential coefficient:  |λ_t| <= m s(λ_n⁺), s with the fields at its
/// place, λ_n the normal coefficient there, m a factor.           [doc/theory/multipliers.md]
class Tangential {
 public:
  Tangential() = default;
  /// \param normal the normal coefficient at the same place
  Tangential(Index normal, PointLaw law) : normal_(normal), law_(std::move(law)) {}

  /// A component of a bonded contact: s = ∞.
  static Tangential tied() { return {none, {}}; }
  bool isTied() const { return normal_ == none; }

  /// \pre not tied.
  Index normal() const { return normal_; }

  /// m s >= 0; `pressures`: all normal coefficients, further entries are not used.
  double bound(const Vector& pressures) const;

  /// m ds/dλ_n; at a kink one of the one-sided derivatives.
  double slope(const Vector& pressures) const;

  bool followsPressure() const { return law_.followsPressure(); }
  /// Is there a pressure at which s > 0?
  bool carries() const;
  /// m s(λ_n) <= m s(0) + steepest() λ_n, see PointLaw.
  double steepest() const { return factor_ * law_.steepest(); }
  /// m s(0).
  double boundWithoutPressure() const;
  /// m times the least upper bound of s, which is large where s grows without bound.
  double largest() const;

  /// With the number of its normal coefficient increased by `normals`.
  Tangential shifted(Index normals) const;

  /// With m multiplied by factor >= 0.
  Tangential scaled(double factor) const;

 private:
  static constexpr Index none = std::numeric_limits<Index>::min();
  Index normal_ = 0;
  PointLaw law_;
  double factor_ = 1;  // m
};

/// The tangential coefficients of one element under a law.
///
/// \param normals the element's normal coefficients, one per basis function
/// \param fields values of the law's fields at t in [-1, 1], in the user's units; at each
///   coefficient by boundCoefficients
/// \param stress the unit of stresses
std::vector<Tangential> elementTangentials(const MultiplierBasis& basis,
                                           const std::vector<Index>& normals,
                                           const std::shared_ptr<const FrictionLaw>& law,
                                           const std::function<Vector(double)>& fields,
                                           double stress);

}  // namespace epafi::contact
