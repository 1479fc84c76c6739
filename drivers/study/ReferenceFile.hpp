#pragma once

#include "drivers/output/Snapshot.hpp"
#include "drivers/scene/Scene.hpp"

#include <optional>

namespace epafi::drivers {

/// A reference solution as a study keeps it.
struct Reference {
  Snapshot solution;
  double estimate = 0;             ///< its own [(stress length²)^½]
  std::vector<std::string> cells;  ///< its row of history.csv
};

/// The reference as text, with the scene that it solves; every number keeps every bit.
std::string referenceText(const Reference& reference, const Scene& scene);

/// The reference of a text, or nothing if it is of another scene, of another version of
/// the format, or damaged: it is then to be computed again.
std::optional<Reference> parseReference(const std::string& text, const Scene& scene);

}  // namespace epafi::drivers
