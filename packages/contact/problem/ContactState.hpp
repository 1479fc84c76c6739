#pragma once

#include <algorithm>
#include <functional>
#include <numeric>
#include <vector>

namespace epafi::contact {

/// What contact does, as a coefficient of the multiplier or at a point: of a pressure Open or
/// Closed, of a shear the others.
enum class ContactState {
  Open,
  Closed,
  Frictionless,  ///< the slip bound is zero
  Stick,
  SlipForward,  ///< λₜ = +s
  SlipBackward  ///< λₜ = -s
};

inline bool isOfPressure(ContactState state) { return state <= ContactState::Closed; }
inline bool slips(ContactState state) { return state >= ContactState::SlipForward; }

/// One per coefficient, pressures first.
using ContactStates = std::vector<ContactState>;

/// Number of coefficients whose states differ.
inline int differences(const ContactStates& a, const ContactStates& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0, std::plus<>(),
                            std::not_equal_to<>());
}

}  // namespace epafi::contact
