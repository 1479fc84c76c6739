#pragma once

#include "drivers/commands/Command.hpp"

namespace epafi::drivers {

/// `epafi study STUDY.xml [--output DIR] [--threads N] [--force] [--quiet]`: solves every
/// variant of every scene of a study and compares them.
///
/// Writes study.csv after every level, a folder per variant with the files of a run (of
/// sweeps below sweep/, the contact alone), reference-<scene>.hdf, and pictures.  A variant that fails is listed with
/// the reason and the study goes on; --force keeps references that still fit.  Returns 0, 3
/// if a variant failed or did not converge, or 1 if nothing did but pictures cannot be
/// drawn.
/// \throws bem::InputError for wrong arguments, studies and scenes, before anything is
/// solved; Interrupted.
int studyCommand(const Given& given, std::ostream& out, const Ranks& ranks);

}  // namespace epafi::drivers
