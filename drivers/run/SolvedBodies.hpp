#pragma once

#include "bem/base/Processes.hpp"
#include "contact/system/ContactSystem.hpp"
#include "drivers/run/BodySpaces.hpp"
#include "drivers/run/Level.hpp"
#include "drivers/scene/Scene.hpp"

#include <memory>
#include <vector>

namespace epafi::drivers {

/// What the states of a mesh are solved on; all outlive it.
struct Ground {
  const Scene& scene;
  int level;
  const BodySpaces& spaces;
  const std::vector<bem::Lame>& lames;
  const std::vector<bem::SteklovPoincare>& stiffness;  ///< of each body
  const bem::Processes& processes;
};

/// Displacements before the first step of a path, or behind one, and what acted there.
struct Placement {
  std::vector<bem::Vector> displacements;
  contact::Motions motions;              ///< of these
  std::vector<contact::State> states{};  ///< of each body; none: nothing acted
  /// Those there, which outlive this; null: none.
  const std::vector<contact::Conditions>* conditions = nullptr;

  Placement(const BodySpaces& spaces, std::vector<bem::Vector> all,
            const std::vector<contact::RigidMotion>& rigid,
            const std::vector<contact::Conditions>* there = nullptr)
      : displacements(std::move(all)),
        motions(spaces.motions(displacements, rigid)),
        conditions(there) {
    if (conditions != nullptr)
      for (const contact::Conditions& ofBody : *conditions)
        motions.inside.push_back(ofBody.inside);
  }
  Placement(const Placement&) = delete;
  Placement& operator=(const Placement&) = delete;
};

/// A state of all bodies with all that results are made from.  Refers to the ground, to the
/// system and to the conditions that it was solved under.
class SolvedBodies {
 public:
  /// `before`: where the bodies were before a step of a path; null: there is no path.  `wear`:
  /// of each body behind it.
  SolvedBodies(const Ground& ground, const contact::ContactSystem& system,
               const std::vector<contact::Conditions>& conditions,
               contact::Configuration at, const Placement* before = nullptr,
               std::vector<contact::Wear> wear = {});
  SolvedBodies(const SolvedBodies&) = delete;
  SolvedBodies& operator=(const SolvedBodies&) = delete;

  const contact::Configuration& at() const { return at_; }
  const Placement& placement() const { return placement_; }
  const std::vector<bem::Vector>& densities() const { return densities_; }
  const std::vector<contact::Solved>& bodies() const { return bodies_; }

  /// Of each body's coefficients.
  std::vector<contact::ContactState> states() const;

  /// Everything of a level but its status, indicators and path.
  Level level(int number) const;

  /// In the user's units, of one step the work of its own.
  double frictionWork() const;
  /// What the surfaces of contacts store, likewise.
  double interfaceEnergy() const;
  std::vector<RigidRow> rigidRows() const;

 private:
  const Ground& ground_;
  const contact::ContactSystem& system_;
  contact::Configuration at_;
  Placement placement_;
  std::vector<bem::Vector> densities_;
  std::vector<contact::Wear> wear_;
  std::vector<contact::Solved> bodies_;
};

}  // namespace epafi::drivers
