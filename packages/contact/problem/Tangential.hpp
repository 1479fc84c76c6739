#pragma once

#include "contact/law/FrictionLaw.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"

#include <limits>
#include <memory>
#include <vector>

namespace epafi::contact {

using bem::Index;
using bem::Vector;

/// A number that belongs to a normal coefficient: the derivative of a bound by it.
struct NormalShare {
  Index normal = 0;
  double value = 0;
};

/// A slip bound, and its derivative by the pressures: as a row sees them, and as its Jacobian
/// is to see them.
struct StepBound {
  double value = 0;
  std::vector<NormalShare> slopes{};
};

/// A law on an element whose coefficients are control points, see Tangential.
struct ElementLaw {
  std::vector<Index> normals;      ///< the normal coefficients of the element
  std::vector<PointLaw> nodes;     ///< the law at the Gauss-Lobatto points x_k
  bem::Matrix values;              ///< E_kj = χ_j(x_k)
  bem::Matrix inverse;             ///< C = E⁻¹
  std::vector<PointLaw> extremes;  ///< with the fields' least and largest values
};

/// A tangential coefficient of the multiplier and what limits it, m times
///
///   s_i = s(λ_i⁺),   the law at the coefficient's own place, or, on control points,
///   s_i = Σ_k C_ik s_k(Σ_j E_kj λ_j⁺),   the control points of the polynomial that meets
///
/// the law at the points x_k, kept within the least and the largest of what the law gives
/// for λ_i⁺ with the fields' values on the element.         doc/theory/multipliers.md
class Tangential {
 public:
  Tangential() = default;
  /// \param normal the normal coefficient at the same place
  Tangential(Index normal, PointLaw law) : normal_(normal), law_(std::move(law)) {}
  /// Coefficient i of an element.
  Tangential(std::shared_ptr<const ElementLaw> element, Index i)
      : normal_(element->normals[static_cast<std::size_t>(i)]),
        place_(i),
        element_(std::move(element)) {}

  /// Either component of a bonded place: held, with any force.
  static Tangential tied() { return {none, {}}; }
  bool isTied() const { return normal_ == none; }

  /// \pre not tied.
  Index normal() const { return normal_; }
  /// All normal coefficients that the bound may follow.
  std::vector<Index> normals() const {
    return element_   ? element_->normals
           : isTied() ? std::vector<Index>{}
                      : std::vector<Index>{normal_};
  }

  /// s >= 0; `pressures` begins with those of all normal coefficients.
  double bound(const Vector& pressures) const;

  /// ds/dλ, zeros left out; at a kink one of its limits.
  std::vector<NormalShare> slopes(const Vector& pressures) const;

  bool followsPressure() const;
  bool followsSeveral() const { return element_ != nullptr; }
  /// Is there a pressure at which s > 0?
  bool carries() const;
  /// s <= s(0) + steepest() λ_n, see PointLaw.
  double steepest() const;
  /// s where there is no pressure at all.
  double boundWithoutPressure() const;

  /// The same among more normal coefficients, of which so many come before its own.
  Tangential shifted(Index normals) const;

  /// With m times as large; factor >= 0.
  Tangential scaled(double factor) const;

 private:
  StepBound linear(const Vector& pressures) const;
  template <class Of>
  double largest(const Of& of) const;

  static constexpr Index none = std::numeric_limits<Index>::min();
  Index normal_ = 0;
  PointLaw law_;
  double factor_ = 1;  // m
  Index place_ = 0;    // i
  std::shared_ptr<const ElementLaw> element_;
};

/// The tangential coefficients of one element under a law.
///
/// `fields`: the values of the law's fields at t in [-1, 1]; `normals`: the element's normal
/// coefficients, one for each function of the basis; `stress`: the unit of stresses.  Where
/// coefficients are values, or no field varies, each follows the law at its own place.
std::vector<Tangential> elementTangentials(const MultiplierBasis& basis,
                                           const std::vector<Index>& normals,
                                           const std::shared_ptr<const FrictionLaw>& law,
                                           const std::function<Vector(double)>& fields,
                                           double stress);

}  // namespace epafi::contact
