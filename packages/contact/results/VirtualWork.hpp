#pragma once

#include "contact/system/ContactSystem.hpp"

#include <cmath>

namespace epafi::contact {

/// The discrete equations of a state tested with the state itself: twice the energies that it stores
/// are the work of all that acts, each on its own displacement,
///
///   strain + stabilisation = loads + supports + means + given + surfaces + friction + rigid,
///
/// sums over all bodies.                           [doc/theory/contact.md, Virtual work]
struct VirtualWork {
  double strain = 0;         ///< <W u, u> + <V ψ, ψ>
  double stabilisation = 0;  ///< twice ContactBody::stabilisationEnergy
  double loads = 0;          ///< f · u
  double supports = 0;       ///< of clamps, on what they prescribe
  double means = 0;          ///< of Fix, on ContactBody::fixedMeans
  double given =
      0;  ///< of contact, on gaps, jumps, given sliding and body loads' motions
  double surfaces = 0;  ///< likewise, on what surfaces yield and on what has worn off
  double friction = 0;  ///< likewise, on slip
  double rigid = 0;     ///< of what loads, holds and moves rigid bodies
  double size = 0;      ///< sum of the absolute values, each body's by itself
  double rounding = 0;  ///< what rounding may leave
  double unsolved = 0;  ///< and what the solver leaves

  double missing() const {
    return loads + supports + means + given + surfaces + friction + rigid - strain -
           stabilisation;
  }
  bool isBroken() const { return !(std::abs(missing()) <= rounding + unsolved); }
};

/// Dimensionless.  `rounding`: of springs by their lengths alone; `unsolved`: Σ |λᵢ rᵢ| of what is
/// closed or sticks, where r is zero but for the solver.  See Balance for all of both.
VirtualWork virtualWork(const ContactSystem& system, const Configuration& at);

}  // namespace epafi::contact
