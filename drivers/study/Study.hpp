#pragma once

#include "drivers/scene/Scene.hpp"
#include "drivers/scene/Schema.hpp"

#include <limits>
#include <optional>

namespace epafi::drivers {

/// One way of solving one scene.
struct Variant {
  std::string name;
  Scene scene;  ///< with the variant's settings
  /// Value of the sweep; NaN without a sweep and for values that are not numbers.
  double sweepValue = std::numeric_limits<double>::quiet_NaN();
  bool swept = false;
};

/// A scene and the variants that are compared on it.
struct StudiedScene {
  std::string name;
  std::optional<Scene> reference;  ///< a much finer discretisation of the same problem
  std::vector<Variant> variants;
};

/// A validated study: all scenes of its variants are valid.
struct Study {
  std::string title;
  bool smallestEigenvalue = false;  ///< add it as a column, see smallest_eigenvalue
  bool keepSolutions = false;       ///< write solution.hdf for every variant
  std::vector<StudiedScene> scenes;
  Teuchos::ParameterList used;  ///< complete list with absolute paths; repeats the study
};

/// All parameters of a study; parameters() has those of a scene.
const std::vector<Parameter>& studyParameters();

/// Reads a study and all scenes that it names; their paths are relative to its folder.
/// \throws bem::InputError with error, place (file: A->B->Key) and what is allowed; also
///   for a reference without Weights = Energy and Residual Factor = 1.
Study readStudy(const std::string& file);

}  // namespace epafi::drivers
