#pragma once

#include "drivers/run/Path.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// contact.csv of the steps of a path on one mesh, with columns for what has happened until
/// then at each point:                                     [doc/theory/paths.md, Fretting]
///
///   slip            uₜ since the first step
///   work            friction's work per length
///   slip_amplitude  half of the range of uₜ since the first step
///   stress_t        normal stress along the surface, E/(1-ν²) uₜ' - ν/(1-ν) λₙ in plane strain
///   ruiz_1          largest |λₜ| times the slip amplitude
///   ruiz_2          largest tensile stress_t times that
///   worn_depth      what has worn off
///   slip_distance   how far the sides have slid while closed, forth and back
class PathContact {
 public:
  explicit PathContact(const Scene& scene) : scene_(&scene) {}  ///< must outlive it

  /// The file of the next step, in the order of the path.
  std::string next(const SolvedLevel& level);

 private:
  /// So far at a point.
  struct Trace {
    double first = 0;  ///< uₜ at the end of the first step
    double least = 0;
    double most = 0;
    double shear = 0;    ///< largest |λₜ|
    double tension = 0;  ///< largest stress along the surface, 0 where there is none
  };

  const Scene* scene_;
  std::vector<Trace> traces_;
};

}  // namespace epafi::drivers
