#pragma once

#include "contact/opposite/MortarCoupling.hpp"
#include "contact/problem/Numbering.hpp"
#include "contact/system/BodyParts.hpp"

namespace epafi::contact {

using AllBodyParts = std::vector<const BodyParts*>;

/// How all multipliers of a system act on each of its bodies: a body's own, and by mortar
/// traces those of the bodies that meet it.  Of the meshes, whatever the time of a path.
class Couplings {
 public:
  /// \throws bem::InputError for a multiplier that shares nodes where contact with another body
  ///   meets a clamp or another contact side.
  Couplings(const AllBodyParts& bodies, Numbering numbering);

  /// C_bᵀ on all multipliers.
  Matrix transposed(std::size_t b, const BodyParts& body) const;
  /// C_b u on all multipliers.
  Vector pull(std::size_t b, const BodyParts& body, const Vector& u) const;
  /// C_b u less M λ of the own multiplier, likewise.
  Vector contactTerms(std::size_t b, const BodyParts& body, const Vector& u,
                      const Vector& multiplier) const;
  /// M of all multipliers.
  Matrix multiplierMass(const AllBodyParts& bodies) const;
  /// Cᵀ λ of the multipliers of all other bodies against this one; empty: it meets none.
  Vector pressOn(std::size_t b, const BodyParts& body,
                 const std::vector<State>& states) const;

 private:
  /// A coupling to the multiplier of one body, and whose that is.
  struct Met {
    std::size_t carrier = 0;
    MortarCoupling coupling;
  };

  std::size_t size() const { return met_.size(); }
  /// What a body's displacement does to its own multiplier, given, and to all that it meets.
  Vector gathered(std::size_t b, const Vector& own, const Vector& u) const;

  Numbering numbering_;
  std::vector<std::vector<Met>> met_;  // of each body
};

}  // namespace epafi::contact
