#pragma once

#include "bem/base/Error.hpp"
#include "drivers/scene/Scene.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// Returns work(); puts the name of the scene's file before the message of an InputError that begins
/// neither with it nor with an option, as --output.
template <class Work>
auto naming(const std::string& file, const Work& work) {
  try {
    return work();
  } catch (const bem::InputError& error) {
    const std::string what = error.what();
    if (what.rfind(file + ": ", 0) == 0 || what.rfind("--", 0) == 0)
      throw;
    throw bem::InputError(file, ": ", what);
  }
}

/// Reads and validates a scene (XML or YAML).
///
/// `overrides`: assignments "A->B->Key=value" of --set, applied in order before
/// validation.
/// \throws bem::InputError with the error, its place (file: A->B->Key) and what is
///   allowed.
Scene readScene(const std::string& file, const std::vector<std::string>& overrides = {});

/// The same from the text of a file.
Scene sceneOf(const std::string& text, const std::string& file,
              const std::vector<std::string>& overrides = {});

/// The scene with overrides and defaults, and the versions that compute it; the text of used.xml.
/// Reading it gives the same scene, bit by bit.
Teuchos::ParameterList usedList(const Scene& scene);
std::string usedXml(const Scene& scene);

/// The complete scene in numbers: an expression that is the same everywhere is its value at
/// the end of the path, another one its text.
Teuchos::ParameterList numbersOf(const Scene& scene);

}  // namespace epafi::drivers
