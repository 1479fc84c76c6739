#pragma once

#include "contact/results/Solved.hpp"
#include "drivers/output/Table.hpp"
#include "drivers/run/SolvedStep.hpp"

#include <optional>
#include <string>
#include <vector>

namespace epafi::drivers {

/// A point of contact.csv.
struct ContactRow {
  std::string boundary{};  ///< as it is told
  std::string body{};
  std::string contact{};
  int element = 0;
  double s = 0;  ///< arc length from the side's start [length]
  contact::ContactPoint point{};
  contact::MultiplierSpace::Value shown{};  ///< λ without arbitrary jumps [stress]
  contact::MultiplierSpace::Value doubt{};  ///< by how much λ may be wrong [stress]
};
/// What a path adds to it.                             [doc/theory/paths.md, Fretting]
struct ContactHistory {
  double slip = 0;  ///< uₜ - given sliding, since the end of the first step
  double work = 0;  ///< work of friction per length of surface [stress length]
  double amplitude =
      0;  ///< half of the range of the slip since the end of the first step
  double along =
      0;  ///< stress along the surface, E/(1-ν²) uₜ' - ν/(1-ν) λₙ in plane strain
  double shear = 0;                ///< largest |λₜ|
  double tension = 0;              ///< largest tensile stress along the surface
  std::optional<double> around{};  ///< hoop stress of solids of revolution
};
Cells cellsOf(const ContactRow& row, const std::optional<ContactHistory>& history);

/// contact.csv: on each contact element the points t = -1 + (2k+1)/samples, k < samples; of the
/// steps of a path on one mesh with columns for the history of each point.
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

  ContactHistory historyAt(const contact::Solved& solved, const bem::Material& material,
                           const bem::Vector& work,
                           const contact::ContactFields::Element& element, double t,
                           const contact::ContactPoint& p);

  std::vector<Trace> traces_;
  std::size_t point_ = 0;  ///< of the next one in them
};

}  // namespace epafi::drivers
