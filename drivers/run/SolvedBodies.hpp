#pragma once

#include "bem/base/Processes.hpp"
#include "contact/system/ContactSystem.hpp"
#include "drivers/run/BodySpaces.hpp"
#include "drivers/run/Level.hpp"
#include "drivers/scene/Scene.hpp"

#include <memory>
#include <vector>

namespace epafi::drivers {

/// Data for all solves on one mesh.  Refers to them.
struct Ground {
  const Scene& scene;
  int level;
  const BodySpaces& spaces;
  const std::vector<bem::Lame>& lames;
  const std::vector<bem::SteklovPoincare>& stiffness;  ///< of each body
  const bem::Processes& processes;
};

/// Displacements, states and conditions before the first step of a path, or after a step.
struct Placement {
  std::vector<bem::Vector> displacements;
  contact::Motions motions;              ///< of these
  std::vector<contact::State> states{};  ///< by body; empty: no loads
  /// Its conditions, which must outlive this; null: none.
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

/// A solution of all bodies with the data for results.  Refers to ground, system and
/// conditions.
class SolvedBodies {
 public:
  /// \param before placement before the step of a path; null: no path
  /// \param wear by body, after the step
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

  /// Contact states of the coefficients, by body.
  std::vector<contact::ContactState> states() const;

  /// The level without status, indicators and path.
  Level level(int number) const;

  /// Friction's work in this step, in the user's units.
  double frictionWork() const;
  /// Energy stored by contact surfaces, in the user's units.
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
