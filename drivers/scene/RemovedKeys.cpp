#include "drivers/scene/RemovedKeys.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/SchemaRow.hpp"

namespace epafi::drivers {

namespace {

struct RemovedKey {
  const char* list;  ///< A->B, not below a name of the scene's choice
  const char* name;
  const char* standard;  ///< the default that it had
  const char* instead;
};

constexpr RemovedKey removedKeys[] = {
    {"Solver", "Load Steps", "1",
     "a History applies a load in steps, and halves one that fails"},
    {"Solver", "Complementarity", "Projection",
     "Newton's steps are the projection's; Fischer-Burmeister's function is the merit of "
     "NOX's line searches"},
    {"Adaptivity->Grading", "Reach", "1",
     "nodes stay where refinement made them: use Transitions Node"},
};

[[noreturn]] void refuse(const RemovedKey& key) {
  throw bem::InputError(bem::join(key.list, key.name), ": is no longer a key; ",
                        key.instead);
}

}  // namespace

void dropRemovedKeys(Teuchos::ParameterList& scene) {
  for (const RemovedKey& key : removedKeys) {
    Teuchos::ParameterList* list = &scene;
    const std::string path = std::string(key.list) + bem::arrow;
    for (std::size_t at = 0, end = 0; list != nullptr && at < path.size(); at = end + 2) {
      end = path.find(bem::arrow, at);
      const std::string name = path.substr(at, end - at);
      list = list->isSublist(name) ? &list->sublist(name) : nullptr;
    }
    if (list == nullptr || !list->isParameter(key.name))
      continue;
    if (Teuchos::toString(list->getEntry(key.name).getAny()) != key.standard)
      refuse(key);
    list->remove(key.name);
  }
}

void refuseRemovedKey(const std::string& path) {
  for (const RemovedKey& key : removedKeys)
    if (path == bem::join(key.list, key.name))
      refuse(key);
}

}  // namespace epafi::drivers
