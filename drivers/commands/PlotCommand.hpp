#pragma once

#include "drivers/commands/Command.hpp"

#include <string>

namespace epafi::drivers {

/// What a helper may say.
enum class Words { All, Errors };

/// Draws the pictures of a run's or a study's folder by the Python package python/epafi/plot,
/// which lies in ../lib/python3.<n>/dist-packages seen from this program.
///
/// Its words go where this program's go.  Returns its exit code: 0, or 1 where matplotlib
/// or the folder's files are missing.
/// \throws bem::InputError if the program or Python is not there.
///
/// `field`: one of fieldNames() that fields.vtu shall be drawn of, or empty.
int drawPictures(const std::string& folder, Words words, const std::string& field = "");

/// `epafi plot DIR`; the first rank draws.
int plotCommand(const Given& given, std::ostream& out, const Ranks& ranks);

}  // namespace epafi::drivers
