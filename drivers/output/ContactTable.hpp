#pragma once

#include "contact/results/Solved.hpp"
#include "drivers/output/Csv.hpp"
#include "drivers/run/SolvedStep.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// contact.csv: on each contact element the points t = -1 + (2k+1)/samples, k < samples; of the
/// steps of a path on one mesh with columns for the history of each point:
///                                                        [doc/theory/paths.md, Fretting]
///
///   slip            uₜ - given sliding, since the end of the first step
///   work            work of friction per length of surface [stress length]
///   slip_amplitude  half of the range of the slip since the end of the first step
///   stress_t        normal stress along the surface, E/(1-ν²) uₜ' - ν/(1-ν) λₙ in plane strain
///   ruiz_1          largest |λₜ| times slip_amplitude
///   ruiz_2          largest tensile stress_t times ruiz_1
///   worn_depth      worn depth
///   slip_distance   Σ |slip| while closed
class ContactTable {
 public:
  /// contact.csv of a load, or of the next step.  Call it once per step, in the order of the path.
  std::string next(const SolvedStep& step);

 private:
  /// History of a point.
  struct Trace {
    double first = 0;  ///< slip at the end of the first step
    double least = 0;
    double most = 0;
    double shear = 0;    ///< largest |λₜ|
    double tension = 0;  ///< largest tensile stress_t, or 0
  };

  CsvRow pathCells(const contact::Solved& solved, const bem::Material& material,
                   const bem::Vector& work,
                   const contact::ContactFields::Element& element, double t,
                   const contact::ContactPoint& p);

  std::vector<Trace> traces_;
  std::size_t point_ = 0;  ///< of the next one in them
};

}  // namespace epafi::drivers
