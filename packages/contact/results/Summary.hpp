#pragma once

#include "contact/results/Resolution.hpp"

#include <map>
#include <string>

namespace epafi::contact {

/// Forces on the body and their moment about the origin of the user's coordinates.
struct Resultant {
  double x = 0;
  double y = 0;
  double moment = 0;
};

/// The scalar results of a solved problem, per unit thickness, in the user's units:
/// energies [stress length²], forces [stress length], moment [stress length²], lengths.
struct Summary {
  double energyStrain = 0;  ///< ½ <W u, u> + ½ <V ψ, ψ>; without Form Density ½ uᵀ S u
  double energyLoad = 0;       ///< fᵀ u, body loads included
  double forceNormal = 0;      ///< ∫ λₙ over all contact sides
  double forceTangential = 0;  ///< ∫ λₜ
  Resultant load;              ///< of the Neumann data
  Resultant inside;            ///< of body loads
  Resultant contact;           ///< of all contact sides: ∫ -λₙ n - λₜ t
  /// Part of `contact` by obstacles and rigid bodies.
  Resultant obstacle;
  Resultant reaction;        ///< of clamps, supports and fixed rigid motions
  RigidMotion motion;        ///< mean of u over the boundary, see RigidModes
  double contactLength = 0;  ///< where λₙ > 0
  /// Half of each element in which contact ends: its end may lie anywhere there.
  double contactLengthError = 0;
  double slipLength = 0;  ///< where |λₜ| reaches its bound
  PeakPressure peak;      ///< largest λₙ
  double wornVolume = 0;  ///< ∫ w [length²]
  double dissipated = 0;  ///< friction's work so far on a path, of one contact
};

/// Reactions are computed from the residual of the discrete equations at constrained unknowns
/// times rigid motions, contact forces from the multiplier as a function, loads from the data.
/// Since these are independent,
///
///   load + inside + contact + reaction = 0    in x, y and moment
///
/// tests the whole solution.
Summary summarize(const Solved& solved);

/// Summaries of all bodies.  A force between two bodies is in `contact` of both; lengths and
/// energies of their contact are those of the body that carries the multiplier.
std::vector<Summary> summarizeAll(const std::vector<Solved>& bodies);

/// Sums over all bodies, where forces between them cancel: `contact` is that of obstacles.
Summary sumOf(const std::vector<Summary>& bodies);

/// Contributions of contact sides to a Summary, by name of the contact, see nameOf.
std::map<std::string, Summary> summarizeContacts(const Solved& solved);
/// contactLength by name of the contact.
std::map<std::string, double> contactLengths(const Solved& solved);

/// Number of displacements that no Dirichlet condition prescribes.
Index freeDisplacements(const bem::Space& space, const Conditions& conditions);

}  // namespace epafi::contact
