#pragma once

#include "drivers/process/Ranks.hpp"
#include "drivers/run/BodySpaces.hpp"

#include <optional>
#include <string>

namespace epafi::drivers {

/// How a level's operators are to be known, and what that takes.
struct Plan {
  bool compressed = false;
  double memory = 0;  ///< at the peak, all processes together [MiB]
  /// Of dense operators, which may take the place of compressed ones that fail: under Method
  /// "Automatic" where they fit.
  std::optional<double> denseInstead{};
  /// What another Method or Form would save, or keep; empty: nothing to speak of.
  std::string advice{};
  double allowed = 0;  ///< Maximum Memory, or else what is free [MiB]
};

/// Up to so many multipliers of all bodies D is formed where operators are compressed, once
/// for all steps of a path: beyond, eliminations in the tree cost less.
int formedUpTo(int steps);

/// As Solver->Linear->Method wants it; "Automatic": compressed where the scene allows it, from
/// 3100 unknowns of one body on, some 7300 of two that meet, for meshes that are not graded to
/// rounding, of bodies that are not slender: by sizes and shape, alike on every machine
/// (decision 71).  Collective.
/// \param allowedBefore  `allowed` of an earlier level; 0 if there is none.
Plan planOf(const Scene& scene, const BodySpaces& spaces, const Ranks& ranks,
            double allowedBefore);

/// Why a level is not begun that would not fit into Maximum Memory, or else into what is
/// free, or whose heat is conducted on too fine a mesh; nothing if it does.
std::optional<std::string> tooLarge(int level, const Size& size, const Plan& plan,
                                    const Scene& scene, const BodySpaces& spaces,
                                    const Ranks& ranks);

}  // namespace epafi::drivers
