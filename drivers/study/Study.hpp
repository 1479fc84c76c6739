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
  /// What a sweep sets here; NaN outside of sweeps and for values that are no numbers.
  double sweepValue = std::numeric_limits<double>::quiet_NaN();
  bool swept = false;
};

/// A scene and the ways of solving it that are compared.
struct StudiedScene {
  std::string name;
  std::optional<Scene> reference;  ///< an overkill discretisation of the same problem
  std::vector<Variant> variants;
};

/// A study, read and validated: every variant's scene is known to be right.
struct Study {
  std::string title;
  bool smallestEigenvalue = false;  ///< of the stabilised stiffness, wanted as a column
  bool keepSolutions = false;       ///< a solution.hdf for every variant
  std::vector<StudiedScene> scenes;
  Teuchos::ParameterList used;  ///< complete, scenes by absolute paths: repeats the study
};

/// All parameters of a study, as parameters() has those of a scene.
const std::vector<Parameter>& studyParameters();

/// Reads STUDY.xml and all scenes that it names; their paths are relative to the study's.
/// \throws bem::InputError saying what is wrong, where (file: A->B->Key) and what is
///   allowed; also for a reference whose estimate is not weighted as an energy.
Study readStudy(const std::string& file);

}  // namespace epafi::drivers
