#pragma once

#include "drivers/scene/Scene.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// Reads and validates a scene, XML or YAML.
///
/// `overrides` are the "A->B->Key=value" of --set, applied in their order before
/// validation.
/// \throws bem::InputError saying what is wrong, where (file: A->B->Key) and what is
///   allowed.
Scene readScene(const std::string& file, const std::vector<std::string>& overrides = {});

/// The same for the text of a file.
Scene sceneOf(const std::string& text, const std::string& file,
              const std::vector<std::string>& overrides = {});

/// What used.xml says: the scene with overrides and defaults, and the versions of what
/// runs it.  Read again, it gives the same scene, bit by bit.
std::string usedXml(const Scene& scene);

}  // namespace epafi::drivers
