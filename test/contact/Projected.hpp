#pragma once

#include "contact/stabilization/Stabilization.hpp"

namespace epafi::test {

/// The stabilisation of the paper, which asks nothing of the stiffness and the space: one S
/// serves several problems.
inline contact::Stabilization projected() {
  contact::Stabilization stabilization;
  stabilization.form = contact::Stabilization::Form::Projected;
  return stabilization;
}

}  // namespace epafi::test
