#pragma once

#include "contact/results/Summary.hpp"
#include "contact/system/ContactSystem.hpp"

#include <optional>
#include <vector>

namespace epafi::contact {

/// What is missing to the balance of a body, or to the sum of contact forces on all bodies, which is
/// zero without those of obstacles; in the user's units.
struct Imbalance {
  std::optional<std::size_t>
      body{};           ///< elastic bodies first, then rigid ones; none: all
  Resultant missing{};  ///< the moment about the middle of the body
  double size = 0;      ///< the larger of force, and of moment over diameter
  double largest = 0;   ///< F below
  double bound = 0;     ///< what rounding may leave

  bool isBroken() const { return !(size <= bound); }
};

/// Forces and moments of solved states, one after the other along a path.  What rounding may leave is
///
///   1e-9 F + 1e-14 (1 + 0.2/(1 - 2ν)) max μ |u|,
///
/// with compressed operators 5e-12 in place of 1e-14, 1 - 2ν at least 1e-7, and at ν = 1/2 1e-3 in
/// place of 1e-9, since pressures lose digits there; F the largest force on the body (where forces
/// cancel, what moves it by |u| at its strain energy), or ∫ |λ| ds of all contact of one body if that
/// is larger, until then; μ the shear modulus, u displacements: those of bodies slender by more than
/// 1 : 1000 are that large.  A spring's force k (end - motion) may have 1e-14 k (|end| + |motion|)
/// more.                                              [doc/theory/contact.md, Several bodies]
class Balance {
 public:
  /// \param compressibility the smallest 1 - 2ν of the bodies, in plane strain
  explicit Balance(double compressibility) : compressibility_(compressibility) {}

  /// Of each body and, last, of the contact forces.
  std::vector<Imbalance> of(const ContactSystem& system, const Configuration& at,
                            const std::vector<Solved>& bodies,
                            const std::vector<Summary>& summaries);

 private:
  double compressibility_;
  Vector largest_;
  double motion_ = 0;  ///< max |u|, dimensionless
};

}  // namespace epafi::contact
