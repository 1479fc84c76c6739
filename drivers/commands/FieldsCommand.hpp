#pragma once

#include "drivers/commands/Command.hpp"

#include <string>

namespace epafi::drivers {

/// `epafi fields DIR`: displacement and stress inside a body, after a run.
///
/// On a grid of cells' middles over the body's box, at points of a file, or along a boundary
/// at a depth, as csv; with --vtk on triangles of the whole inside for ParaView; with --step
/// at a step of a load path.  The first rank works.
/// \throws bem::InputError for a folder without a solution, for points that are not inside
///   and for boundaries and steps that there are not.
int fieldsCommand(const Given& given, std::ostream& out, const Ranks& ranks);

/// Writes the folder's fields.vtu; `step`: as --step gives it, empty: the last one.
void writeInside(const std::string& folder, const std::string& step);

/// Writes fields-window.csv: a fine grid over a window "X0,Y0,X1,Y1" of the bodies.
/// \throws bem::InputError for what is no window, or one beside the bodies.
void writeWindow(const std::string& folder, const std::string& step,
                 const std::string& window);

}  // namespace epafi::drivers
