#pragma once

#include "drivers/process/Ranks.hpp"
#include "drivers/run/BodySpaces.hpp"

#include <optional>
#include <string>

namespace epafi::drivers {

/// Choice of dense or compressed operators for a level, with a forecast of memory.
struct Plan {
  bool compressed = false;
  double memory = 0;  ///< at the peak, all processes together [MiB]
  /// Memory of dense operators [MiB] if they may replace compressed ones that fail: Method
  /// "Automatic", and they fit.
  std::optional<double> denseInstead{};
  /// Advice on another Method or Form, or another remark for history.csv; may be empty.
  std::string advice{};
  double allowed = 0;                ///< Maximum Memory, else the free memory [MiB]
  bool insteadOfCompressed = false;  ///< have compressed operators failed?
};

/// Largest number of multipliers of all bodies for which D is formed with compressed
/// operators, once for all `steps`; with more, eliminations in the tree cost less.
int formedUpTo(int steps);

/// By Solver->Linear->Method.  "Automatic": compressed if the scene allows it, from 3100
/// unknowns of one body on, some 7300 of two bodies in contact, unless bodies are slender
/// or meshes are graded to rounding; independent of the machine (decision 71).
/// Collective.
/// \param allowedBefore  `allowed` of an earlier level; 0 if there is none.
Plan planOf(const Scene& scene, const BodySpaces& spaces, const Ranks& ranks,
            double allowedBefore);

/// Reason why a level is not begun: more unknowns than Maximum Degrees of Freedom; empty if
/// there is none.  \throws bem::InputError for level 0
std::string aboveCap(int level, const Size& size, const Scene& scene);

/// Reason why a level is not begun: more memory than allowed, or heat conduction on too
/// fine a mesh; empty if there is none.
std::optional<std::string> tooLarge(int level, const Size& size, const Plan& plan,
                                    const Scene& scene, const BodySpaces& spaces,
                                    const Ranks& ranks);

}  // namespace epafi::drivers
