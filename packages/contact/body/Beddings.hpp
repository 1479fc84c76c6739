#pragma once

#include "contact/body/ElasticBody.hpp"

namespace epafi::contact {

/// What bodies stand on that bend too easily to be solved alone, see Bedding.
struct Beddings {
  std::vector<Bedding> of;  ///< by body; without rows: none
  std::vector<std::size_t>
      order;      ///< of bodies, each behind the one that its bedding stands on
  int depth = 0;  ///< most beddings on top of each other
};

/// A body gets a bedding on its bond with the stiffest body or support that it is bonded to, if it is more
/// compliant than that by a factor of 1e5 and more; what is bonded to it in turn counts as held as well.
/// Springs are a thousandth as stiff as what they stand on in the end: a step of defect correction leaves
/// a thousandth of what the feet would add, behind as many steps as beddings stand on each other.
/// Compliances by moduli and slenderness: (1 + s³) / E, s = 1 for a square.
/// \param couplings  without stabilisation
Beddings makeBeddings(const std::vector<const bem::Space*>& spaces,
                      const std::vector<bem::Lame>& lames,
                      const MultiplierSpace& multiplier,
                      const std::vector<Coupling>& couplings);

}  // namespace epafi::contact
