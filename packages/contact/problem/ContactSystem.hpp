#pragma once

#include "contact/problem/ContactProblem.hpp"

namespace epafi::contact {

/// The numbers that the coefficients of a body's multiplier have in the problem of all
/// bodies: normal ones first.
class Numbering {
 public:
  /// Sizes of MultiplierSpaces.
  struct Count {
    Index normals = 0;
    Index size = 0;
  };
  explicit Numbering(const std::vector<Count>& bodies);

  Index size() const { return size_; }
  Index normals() const { return normals_; }
  Index operator()(std::size_t b, Index own) const {
    const Start& start = starts_[b];
    return own < start.count.normals ? start.normal + own
                                     : start.tangential + own - start.count.normals;
  }
  /// How many coefficients a body has.
  Index sizeOf(std::size_t b) const { return starts_[b].count.size; }
  Index normalsOf(std::size_t b) const { return starts_[b].count.normals; }

 private:
  struct Start {
    Count count;
    Index normal;
    Index tangential;
  };
  std::vector<Start> starts_;
  Index normals_ = 0;
  Index size_ = 0;
};

/// The contact problem of all bodies of a scene, condensed onto all multipliers together:
///
///   λ = (λₙ of body 0, of body 1, ..., λₜ of body 0, of body 1, ...),
///   D = Σ_b C_b A_b⁺ C_bᵀ + M,   C_b = (own coupling of b, - mortar traces of what meets b)
///
/// Bodies count in one length and one stress.                  [doc/theory/contact.md]
class ContactSystem {
 public:
  /// \pre All inputs have the same units and the same algebra; their opposites' points
  ///   number the bodies as they come here.
  /// \throws see ContactProblem, and bem::InputError for a multiplier that shares nodes where
  ///   contact with another body meets a clamp or another contact side.
  explicit ContactSystem(const std::vector<ContactProblem::Input>& bodies);
  ~ContactSystem();
  ContactSystem(ContactSystem&&) noexcept;

  std::size_t size() const;
  const ContactProblem& body(std::size_t b) const;

  /// What the nonlinear solver sees, and see ContactProblem::gap.
  const Problem& numbers() const;
  const Vector& gap() const;

  /// The state as each body's own multiplier and rigid motions, and back.  An empty vector
  /// stays empty.
  std::vector<State> split(const State& state) const;
  State joined(const std::vector<State>& states) const;
  const Numbering& numbering() const;

  /// Cᵀ λ of the multipliers of all other bodies against this one; empty: it meets none.
  Vector met(std::size_t b, const std::vector<State>& states) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace epafi::contact
