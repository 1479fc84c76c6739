#pragma once

#include "contact/results/Summary.hpp"
#include "contact/results/VirtualWork.hpp"
#include "contact/system/ContactSystem.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace epafi::contact {

/// What is missing to the balance of a body, or to the sum of contact forces on all bodies, which is
/// zero without those of obstacles; in the user's units.
struct Imbalance {
  std::optional<std::size_t>
      body{};           ///< elastic bodies first, then rigid ones; none: all
  Resultant missing{};  ///< the moment about the middle or reference point
  double size = 0;      ///< the larger of force, and of moment over length
  double largest = 0;   ///< F below
  double rounding = 0;  ///< what rounding may leave
  double unsolved = 0;  ///< and what the tolerance of the solver may leave

  bool isBroken() const { return !(size <= rounding + unsolved); }
  bool isRounding() const { return size <= rounding; }
};

/// Forces and moments of solved states, one after the other along a path.  What rounding may leave of
/// an elastic body is
///
///   1e-9 F + 1e-14 (1 + 0.2/(1 - 2ν)) μ |u|,
///
/// with compressed operators 5e-12 in place of 1e-14, 1 - 2ν at least 1e-7, and at ν = 1/2 1e-3 in
/// place of 1e-9, since pressures lose digits there; F the largest force on the body (where forces
/// cancel, what moves it by |u| at its strain energy), or ∫ |λ| ds of all contact of one body if that
/// is larger, until then; ν, μ and u of the body, μ the shear modulus, |u| the largest until then:
/// those of bodies slender by more than 1 : 1000 are that large.  Of the contact forces and of a
/// rigid body, which nothing is computed in, it is 1e-9 F + 1e-14 max μ |u|; a spring's force
/// k (end - motion) may have 1e-14 k (|end| + |motion|) more.
///
/// The rows G'λ + K α = q of free motions, elastic and rigid ones, are solved to the tolerance over
/// Problem::stress times Σ |G|, at most 2 l: l the length of all contact.  A body with a free motion may
/// miss 2 tolerance stress l more.
///
/// Of the virtual work it is 1e-9 of the sum of the absolute values of its terms, the largest until
/// then, and what the second term leaves on |u|, at ν = 1/2 that of ν = 0.  A free motion does as much more as it may miss.
///
/// Moments count over the body's diameter; those of a rigid body over the unit of length, or over
/// the largest lever arm of its contact if that is longer.
///                                                  [doc/theory/contact.md, Several bodies]
class Balance {
 public:
  /// \param compressibilities 1 - 2ν of each elastic body, in plane strain
  explicit Balance(Vector compressibilities)
      : compressibilities_(std::move(compressibilities)),
        motions_(compressibilities_.size()) {}

  /// Of each body and, last, of the contact forces.
  /// \param tolerance  that of the scaled residual, see Report
  std::vector<Imbalance> of(const ContactSystem& system, const Configuration& at,
                            const std::vector<Solved>& bodies,
                            const std::vector<Summary>& summaries, double tolerance);
  /// Of a state that of() has been asked for, dimensionless.
  VirtualWork workOf(const ContactSystem& system, const Configuration& at,
                     const Vector& shearModuli, double tolerance);

 private:
  Vector compressibilities_;
  Vector
      motions_;  ///< max |u| of each elastic body, that of body loads, too, dimensionless
  Vector largest_;
  double largestWork_ = 0;
};

}  // namespace epafi::contact
