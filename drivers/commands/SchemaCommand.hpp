#pragma once

#include "drivers/commands/Command.hpp"
#include "drivers/scene/Schema.hpp"

namespace epafi::drivers {

/// A kind of file that the program reads, by its table of keys.
struct Grammar {
  std::string name;  ///< "scene"
  const bem::SchemaRows* rows;
};

/// Scenes and studies.
std::vector<Grammar> grammars();
/// One of them, or all for an empty name.
std::vector<Grammar> grammars(const std::string& name);

/// RELAX NG of the XML files, for editors and xmllint: names, types, words and ranges.  What
/// depends on other keys, and what is required, the program checks.
std::string relaxNg(const std::vector<Grammar>& grammars);

/// JSON Schema (draft 7) of the YAML files: the same, and what is required whatever other
/// keys say.  Keys that depend on others (a law's, a condition's) stand side by side in it.
std::string jsonSchema(const std::vector<Grammar>& grammars);

/// `epafi schema [--format rng|json] [--of scene|study]`
int schemaCommand(const Given& given, std::ostream& out);

}  // namespace epafi::drivers
