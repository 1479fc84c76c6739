#pragma once

#include "drivers/commands/Command.hpp"
#include "drivers/output/Table.hpp"
#include "drivers/scene/Scene.hpp"
#include "drivers/scene/SceneFile.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// The commands; they return the exit code, and throw bem::InputError for what is wrong with
/// their arguments and files.  Those without ranks run where CommandTable says.

/// `epafi run SCENE.xml [options]`: solves a scene level by level and writes its files.
///
/// Returns 0, or 3 if a level is not converged.
/// \throws bem::InputError, bem::NumericalError, Interrupted: files of the levels before
///   are written.
/// Collective; `out` and the files belong to the first rank.
int runCommand(const Given& given, std::ostream& out, const Ranks& ranks);

/// What --smallest-eigenvalue adds to history.csv, empty.
Cells eigenvalueColumn();

/// `epafi version`
int versionCommand(const Given& given, std::ostream& out);

/// `epafi study STUDY.xml [--output DIR] [--threads N] [--force] [--no-plot] [--quiet]`:
/// reads the study and becomes python/epafi/study.py, which solves its variants by `epafi run`.
/// Does not return.
/// \throws bem::InputError for wrong arguments and studies.
int studyCommand(const Given& given, std::ostream& out, const Ranks& ranks);
/// All parameters of a study; parameters() has those of a scene.
const std::vector<Parameter>& studyParameters();

/// `epafi fields DIR`: displacement and stress inside a body, after a run.
///
/// Evaluates at the centres of a grid, at the points of a file (empty rows outside), or
/// along a boundary at a depth, as csv; with --vtk on triangles of the whole inside.
/// --step chooses a step of a path, with --vtk also all steps.
/// \throws bem::InputError for a folder without a solution and for boundaries and steps that
///   there are not.
int fieldsCommand(const Given& given, std::ostream& out);
/// All columns of fields.csv.
Cells columnsOfFields();

/// `epafi plot DIR`: pictures of a run or a study by the Python package python/epafi/plot.
/// Returns 0, or 1 if matplotlib or files of the folder are missing.  The package starts `epafi
/// fields` for fields, and `epafi check` for the scene of a report.
/// \throws bem::InputError if the package or Python is not there.
int plotCommand(const Given& given, std::ostream& out);
/// `epafi report DIR`: a page of HTML with the scene, the numbers and the pictures of a run.
int reportCommand(const Given& given, std::ostream& out);
/// Draws a scene, given as csv, into a file by the Python package, which lies in
/// ../lib/python3.<n>/dist-packages seen from this program.  Returns the exit code.
int drawScene(const std::string& csv, const std::string& title, const std::string& file);

/// `epafi check`: solves nothing, but makes loads, obstacle and bounds on the first mesh as
/// a run does, so that every expression is evaluated where the run's first level does, and
/// tells what the scene is.  (The estimate's own points follow from the solution.)
/// \throws bem::InputError where an expression is not one finite number, where a bound is
/// negative, or for a mesh that cannot be made.
int checkCommand(const Given& given, std::ostream& out);
std::string checkScene(const Scene& scene);

/// A kind of file that the program reads, by its table of keys.
struct Grammar {
  std::string name;  ///< "scene"
  const bem::SchemaRows* rows;
};
/// Scenes and studies; one of them, or both for an empty name.
std::vector<Grammar> grammars(const std::string& name = "");

/// The type of a key in listings: "string: expression".
std::string typeOf(const Parameter& row);
/// Its default, "required", or "may be left out": keys of such a list have their defaults then.
std::string standardOf(const Parameter& row);
/// "only with Law 'Tresca'"
std::string restriction(const Parameter& row);

/// `epafi parameters`: all keys of the grammars as text, with what a program has added, or
/// as markdown; as xml a list of the first one: every key, with its default or a sample value.
int parametersCommand(const Given& given, std::ostream& out);

/// `epafi schema [--format rng|json] [--of scene|study]`: RELAX NG of the XML files or JSON
/// Schema of the YAML files.
int schemaCommand(const Given& given, std::ostream& out);

/// A file that was generated with this program when it was built, in share/.
/// \throws bem::InputError if it is not there.
std::string madeWithProgram(const std::string& file);

}  // namespace epafi::drivers
