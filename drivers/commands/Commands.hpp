#pragma once

#include "drivers/scene/Scene.hpp"

#include <iosfwd>
#include <string>
#include <vector>

namespace epafi::drivers {

/// `epafi check`: solves nothing, but makes loads, obstacle and bounds on the first mesh as
/// a run does, so that every expression is evaluated where the run's first level does, and
/// tells what the scene is.  (The estimate's own points follow from the solution.)
/// \throws bem::InputError where an expression is not one finite number, where a bound is
/// negative, or for a mesh that cannot be made.
std::string checkScene(const Scene& scene);

/// `epafi parameters --format text|xml|markdown`: the whole schema.
/// \throws bem::InputError for another format.
std::string parametersText(const std::string& format);

/// The commands with the arguments that follow their name; they return the exit code.
/// \throws bem::InputError for wrong arguments and wrong scenes.
int checkCommand(const std::vector<std::string>& arguments, std::ostream& out);
int parametersCommand(const std::vector<std::string>& arguments, std::ostream& out);

}  // namespace epafi::drivers
