#include "drivers/commands/SchemaCommand.hpp"

#include "drivers/study/Study.hpp"

#include <ostream>

namespace epafi::drivers {

std::vector<Grammar> grammars() {
  return {{"scene", &parameters()}, {"study", &studyParameters()}};
}

std::vector<Grammar> grammars(const std::string& name) {
  if (name.empty())
    return grammars();
  for (const Grammar& grammar : grammars())
    if (grammar.name == name)
      return {grammar};
  return {};
}

int schemaCommand(const Given& given, std::ostream& out) {
  const std::vector<Grammar> wanted = grammars(given.value("--of"));
  out << (given.value("--format", "rng") == "rng" ? relaxNg(wanted) : jsonSchema(wanted));
  return 0;
}

}  // namespace epafi::drivers
