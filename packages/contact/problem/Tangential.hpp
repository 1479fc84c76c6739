#pragma once

#include "contact/law/FrictionLaw.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"

#include <cassert>
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

/// Friction law of a tangential coefficient:  |λ_t| <= s(λ_n⁺), s with the fields at its place, λ_n
/// the normal coefficient there.                                [doc/theory/multipliers.md]
class Tangential : public PointLaw {
 public:
  Tangential() = default;
  /// \param normal the normal coefficient at the same place
  Tangential(Index normal, PointLaw law) : PointLaw(std::move(law)), normal_(normal) {}

  /// A component of a bonded contact: s = ∞.
  static Tangential tied() {
    return {none, PointLaw(std::numeric_limits<double>::infinity())};
  }
  bool isTied() const { return normal_ == none; }

  /// \pre not tied.
  Index normal() const {
    assert(!isTied());
    return normal_;
  }

  using PointLaw::bound;
  using PointLaw::slope;
  /// s >= 0 and ds/dλ_n; `pressures`: all normal coefficients, further entries are not used.
  double bound(const Vector& pressures) const { return bound(pressureIn(pressures)); }
  double slope(const Vector& pressures) const { return slope(pressureIn(pressures)); }

  /// Is there a pressure at which s > 0?
  bool carries() const { return bound(1.0) > 0; }
  /// The least upper bound of s, which is large where s grows without bound.
  double largest() const { return bound(1e30); }

  /// With s multiplied by factor >= 0; a bond stays one.
  Tangential scaled(double factor) const;

 private:
  static constexpr Index none = std::numeric_limits<Index>::min();
  double pressureIn(const Vector& pressures) const {
    return isTied() ? 0 : pressures[bem::at(normal_)];
  }

  Index normal_ = 0;
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
