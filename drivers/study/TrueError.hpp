#pragma once

#include "bem/space/CauchyData.hpp"
#include "drivers/run/Level.hpp"
#include "drivers/scene/Scene.hpp"

#include <array>
#include <optional>
#include <vector>

namespace epafi::drivers {

/// A body on a solved level as functions on its boundary: what true errors are measured between.
/// Dimensionless, and good after the level's operators are gone.
struct BodySnapshot {
  bem::CauchyData data;
  /// λₙ + i λₜ on each element as a Legendre series of the element's degree; zero where
  /// there is no contact.
  std::vector<std::array<bem::Complex, bem::largestDegree + 1>> multiplier;
  std::vector<bool> contact;  ///< of each element
};

/// All bodies at a time.
struct Snapshot {
  double t = 1;
  std::vector<BodySnapshot> bodies;
  double dissipated = 0;  ///< on a path: friction's work so far [stress length²]
};

/// A solved level: of a path each step that was asked for, else one state.
struct Snapshots {
  std::vector<Snapshot> steps;
  double energy =
      0;  ///< of the last: strain energy - fᵀ u + friction's work [stress length²]
};

/// Of a level just solved or read from a file; `energy`: see energyOf; `dissipated`: of each
/// step that was asked for, see dissipatedOf.
Snapshots takeSnapshots(const Scene& scene, const Level& level, double energy,
                        const std::vector<double>& dissipated);

/// What true errors of a scene are measured against.
struct Reference {
  Reference(Snapshots snapshots, double estimate, const Scene& scene);

  Snapshots solution;
  std::vector<double> norms;  ///< of each step in the energy norm, dimensionless
  double estimate;            ///< its own [(stress length²)^½]
};

/// How far a level is from a reference.
struct TrueError {
  double energyNorm = 0;  ///< (<W d, d> + <V δ, δ>)^½, absolute [(stress length²)^½]
  double relative = 0;    ///< the same over that of the reference
  /// (Σ h/p ‖λ - λ_ref‖² / μ)^½ over the elements of the level, over the reference's
  /// energy norm: the scaled L² norm that stands for H^-1/2 [P sec. 8], comparable to
  /// `relative`.
  double multiplier = 0;
  double energy = 0;  ///< |difference of the energies| over the reference's

  double largest = 0;  ///< `energyNorm`, on a path the largest of any step

  /// The largest over the steps of a path that have their time in common with the reference.
  struct Path {
    double relative = 0;    ///< as above, over the largest norm of any step
    double multiplier = 0;  ///< likewise
    double friction = 0;    ///< of friction's work so far, over all of the reference's
    int step = 0;           ///< that of `relative`: 1, 2, ...
  };
  std::optional<Path> path{};  ///< nothing without a History
};

/// On the union of the two meshes, without further error.
TrueError trueError(const Snapshots& level, const Reference& reference,
                    const Scene& scene);

}  // namespace epafi::drivers
