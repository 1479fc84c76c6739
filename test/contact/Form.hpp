#pragma once

#include "contact/multiplier/MultiplierBasis.hpp"
#include "contact/stabilization/Stabilization.hpp"

namespace epafi::test {

inline contact::Stabilization ofForm(contact::Stabilization::Form form) {
  contact::Stabilization stabilization;
  stabilization.form = form;
  return stabilization;
}

/// The stabilisation of the paper, which asks nothing of the stiffness and the space: one S
/// serves several problems.
inline contact::Stabilization projected() {
  return ofForm(contact::Stabilization::Form::Projected);
}

/// The default, or none of a basis that is stable by itself.
inline contact::Stabilization suited(const std::string& basis) {
  using Form = contact::Stabilization::Form;
  return contact::multiplierBasis(basis).sharesNodes ? ofForm(Form::None)
                                                     : contact::Stabilization();
}

}  // namespace epafi::test
