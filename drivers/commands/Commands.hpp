#pragma once

#include "drivers/commands/SchemaCommand.hpp"
#include "drivers/scene/Scene.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// `epafi check`: solves nothing, but makes loads, obstacle and bounds on the first mesh as
/// a run does, so that every expression is evaluated where the run's first level does, and
/// tells what the scene is.  (The estimate's own points follow from the solution.)
/// \throws bem::InputError where an expression is not one finite number, where a bound is
/// negative, or for a mesh that cannot be made.
std::string checkScene(const Scene& scene);

/// `epafi parameters`: all keys of the grammars as text or markdown; as xml a list of the
/// first one that Teuchos can read: every key, with its default or a sample value.
std::string parametersText(const std::vector<Grammar>& grammars,
                           const std::string& format);

/// What `epafi check --plot` draws, as csv: points along the first meshes with the loads and
/// gaps there.
std::string sceneCsv(const Scene& scene);

/// The commands; they return the exit code.
/// \throws bem::InputError for wrong scenes.
int checkCommand(const Given& given, std::ostream& out);
int parametersCommand(const Given& given, std::ostream& out);

}  // namespace epafi::drivers
