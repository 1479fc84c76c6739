#pragma once

#include "bem/base/Processes.hpp"
#include "bem/operators/SteklovPoincare.hpp"
#include "contact/results/Balance.hpp"
#include "contact/system/ContactSystem.hpp"
#include "drivers/run/BodySpaces.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace epafi::drivers {

/// Displacements of all bodies on their meshes.  Refers to the spaces.
struct SolvedPart {
  using Conditions = std::vector<contact::Conditions>;

  /// At rest, before the first step of a path.
  explicit SolvedPart(const BodySpaces& spaces);
  SolvedPart(const BodySpaces& spaces, std::shared_ptr<const Conditions> conditions,
             contact::Configuration at);
  SolvedPart(const SolvedPart&) = delete;
  SolvedPart& operator=(const SolvedPart&) = delete;

  std::shared_ptr<const Conditions> conditions;  ///< null: at rest
  contact::Configuration at;
  contact::Motions motions;
};

/// A solution with the data for results, in a step of a path or under one load.
struct SolvedStep : SolvedPart {
  /// \param before from where slip is measured, the part before the last one of this step
  /// \param wear after the step
  SolvedStep(const BodySpaces& spaces, std::shared_ptr<const Conditions> conditions,
             std::shared_ptr<const contact::ContactSystem> system,
             contact::Configuration at, std::shared_ptr<const SolvedPart> before,
             contact::Wear wear);

  /// As numbers.
  SolvedState fields() const;
  /// Of each body, without the image of a half; computed on first use.
  const std::vector<contact::Summary>& summaries() const;
  /// Of all elastic bodies' unknowns.
  double largestDisplacement() const;
  /// What strains as large as displacements and loads would store in a body of the scene's size,
  /// in the user's units.
  struct Storable {
    double inside = 0;  ///< μ u_p², of weight, spin and heat
    /// What rounding leaves of all, μ u² or t²/μ, where nothing is strained: 12 digits of u and t,
    /// and of places those that they have, see adaptivity::spacing.
    double rounding = 0;
  };
  Storable storable() const;
  /// Fills what a row says of rigid bodies.
  void addRigid(StepRow& filled) const;
  /// Fills what a row says of contacts.  Of a body that a line of symmetry cuts, the shear of a contact away
  /// from the line is that of both halves, each along t as the drawn half has it.
  void addContacts(StepRow& filled) const;

  const BodySpaces& spaces;
  std::shared_ptr<const SolvedPart> before;
  std::shared_ptr<const contact::ContactSystem> system;
  contact::Wear wear;
  std::vector<bem::Vector> densities;   ///< of each body
  std::vector<contact::Solved> bodies;  ///< likewise

  StepRow row;
  /// So far on a path, one per tangential coefficient, dimensionless.
  bem::Vector frictionWork;
  std::vector<contact::Imbalance>
      imbalances;  ///< see contact::Balance; empty: not asked for

 private:
  mutable std::vector<contact::Summary> summaries_;
};

/// A level, or a path on its way, as it is handed out.  Refers to the spaces.
struct SolvedLevel {
  const std::vector<bem::SteklovPoincare>& stiffness;  ///< of each body
  Level level;
  LevelRow row{};  ///< of a path that is not at its end: its report and times only
  std::vector<std::shared_ptr<const SolvedStep>> steps{};
  std::string
      unbalanced{};    ///< what ends the run, see checkBalance; empty: all is in balance
  std::string ends{};  ///< of a path that ends early: "step 11 of the path ends at ..."

  const SolvedStep& last() const { return *steps.back(); }
};

/// What all levels of a run share.
struct Run {
  const bem::Processes& processes;
  PhaseTimer& timer;
  const bem::SingleLayerSolver* krylov;  ///< solves with V; null: its factor does
  const std::function<void(const SolvedLevel&)>& handOut;      ///< see solveLevels
  const std::function<void(const SolvedLevel&)>& handOutStep;  ///< likewise; may be empty
};

}  // namespace epafi::drivers
