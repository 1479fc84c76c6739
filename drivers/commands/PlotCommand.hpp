#pragma once

#include "drivers/commands/Command.hpp"

#include <string>
#include <vector>

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
/// `more`: --field with one of fieldNames() that fields.vtu shall be drawn of, --window.
int drawPictures(const std::string& folder, Words words,
                 const std::vector<std::string>& more = {});

/// Draws a scene, given as csv (sceneCsv), into a file.  Returns the exit code.
int drawScene(const std::string& csv, const std::string& title, const std::string& file);

/// `epafi plot DIR`; the first rank draws.
int plotCommand(const Given& given, std::ostream& out, const Ranks& ranks);

}  // namespace epafi::drivers
