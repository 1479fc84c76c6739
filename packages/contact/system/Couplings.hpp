#pragma once

#include "contact/opposite/TraceCoupling.hpp"
#include "contact/problem/Numbering.hpp"
#include "contact/system/ContactProblem.hpp"

namespace epafi::contact {

/// How all multipliers of a system act on each of its bodies: a body's own, and by mortar
/// traces those of the bodies that meet it.  Of the meshes, whatever the time of a path.
class Couplings {
 public:
  /// \throws bem::InputError for a multiplier that shares nodes where contact with another body
  ///   meets a clamp or another contact side.
  Couplings(const std::vector<ContactProblem>& bodies, Numbering numbering);

  /// C_bᵀ on all multipliers.
  Matrix transposed(std::size_t b, const StabilisedBody& form) const;
  /// On all multipliers what a body's displacement does to its own, given, and to all that it
  /// meets.
  Vector gathered(std::size_t b, const Vector& own, const Vector& u) const;
  /// M of all multipliers.
  Matrix multiplierMass(const std::vector<ContactProblem>& bodies) const;
  /// Cᵀ λ of the multipliers of all other bodies against this one; empty: it meets none.
  Vector pressOn(std::size_t b, const std::vector<State>& states) const;

 private:
  /// A coupling to the multiplier of one body, and whose that is.
  struct OppositeCoupling {
    std::size_t carrier = 0;
    Index displacements = 0;
    TraceCoupling coupling;
  };

  Numbering numbering_;
  std::vector<std::vector<OppositeCoupling>> opposite_;  // of each body
};

}  // namespace epafi::contact
