#pragma once

#include "bem/space/CauchyData.hpp"
#include "drivers/run/Level.hpp"
#include "drivers/scene/Scene.hpp"

#include <array>
#include <optional>
#include <vector>

namespace epafi::drivers {

/// The solution of a body as functions on its boundary, between which true errors are
/// measured.  Dimensionless; remains valid after the operators of the level are deleted.
struct BodySnapshot {
  bem::CauchyData data;
  /// λₙ + i λₜ on each element as a Legendre series of the degree of the element; zero
  /// without contact.
  std::vector<std::array<bem::Complex, bem::largestDegree + 1>> multiplier;
  std::vector<bool> contact;  ///< of each element
};

/// The solution of all bodies at one time.
struct Snapshot {
  double t = 1;
  std::vector<BodySnapshot> bodies;
  double dissipated = 0;  ///< work of friction up to t on a path [stress length²]
};

/// A solved level: on a path every requested step, else one state.
struct Snapshots {
  std::vector<Snapshot> steps;
  double energy = 0;  ///< see energyOf, at the end [stress length²]
};

/// The snapshots of a level that was solved or read from a file.  `energy`: see energyOf;
/// `dissipated`: for each requested step, see dissipatedOf.
Snapshots takeSnapshots(const Scene& scene, const Level& level, double energy,
                        const std::vector<double>& dissipated);

/// The reference solution of a scene.
struct Reference {
  Reference(Snapshots snapshots, double estimate, const Scene& scene);

  Snapshots solution;
  std::vector<double> norms;  ///< energy norm of each step, dimensionless
  double estimate;            ///< estimated error [(stress length²)^½]
};

/// The error of a level against a reference.
struct TrueError {
  double energyNorm = 0;  ///< (<W d, d> + <V δ, δ>)^½, absolute [(stress length²)^½]
  double relative = 0;    ///< energyNorm over the energy norm of the reference
  /// (Σ h/p ‖λ - λ_ref‖² / μ)^½ over the elements of the level, over the energy norm of
  /// the reference: the scaled L² norm in place of H^-1/2 [P sec. 8], comparable to
  /// `relative`.
  double multiplier = 0;
  double energy = 0;  ///< |difference of the energies| over that of the reference

  double largest = 0;  ///< `energyNorm`; on a path the largest of all steps

  /// Largest errors over the steps of a path whose times the reference has, too.
  struct Path {
    double relative = 0;    ///< energyNorm over the largest norm of all steps
    double multiplier = 0;  ///< the same for the multiplier
    double friction = 0;    ///< of friction's work so far, over the reference's total
    int step = 0;           ///< step of `relative`: 1, 2, ...
  };
  std::optional<Path> path{};  ///< empty without a History
};

/// Computed on the union of the two meshes, without further approximation.
TrueError trueError(const Snapshots& level, const Reference& reference,
                    const Scene& scene);

}  // namespace epafi::drivers
