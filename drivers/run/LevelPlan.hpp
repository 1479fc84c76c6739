#pragma once

#include "drivers/process/Ranks.hpp"
#include "drivers/run/BodySpaces.hpp"

#include <string>

namespace epafi::drivers {

/// Degrees of freedom that a level may have.
long capOf(const Scene& scene);

/// Largest number of multipliers of all bodies for which D is formed with compressed
/// operators, once for all `steps`; with more, eliminations in the tree cost less.
int formedUpTo(int steps);

/// The row of a level with sizes, operators, forecasts of memory and advice in its note, by
/// Solver->Linear->Method.  "Automatic": compressed if the scene allows it, from 3100
/// unknowns of one body on, some 7300 of two bodies in contact, unless bodies are slender
/// or meshes are graded to rounding; independent of the machine (decision 71).
/// Collective.
/// \param allowedBefore  memoryAllowed of an earlier level; 0 if there is none.
LevelRow planOf(const BodySpaces& spaces, const Ranks& ranks, double allowedBefore);

/// Reason why a level is not begun: more unknowns than Maximum Degrees of Freedom; empty if
/// there is none.  \throws bem::InputError for level 0
std::string aboveCap(int level, const LevelRow& size, const Scene& scene);

/// Reason why a level is not begun: more memory than allowed, or heat conduction on too
/// fine a mesh; empty if there is none.  \throws bem::InputError for level 0
std::string tooLarge(int level, const LevelRow& planned, const BodySpaces& spaces,
                     const Ranks& ranks);

}  // namespace epafi::drivers
