#pragma once

#include "bem/space/CauchyData.hpp"
#include "drivers/run/Level.hpp"
#include "drivers/scene/Scene.hpp"

#include <array>
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
struct Snapshot {
  std::vector<BodySnapshot> bodies;
  double energy = 0;  ///< strain energy - fᵀ u + friction's work [stress length²]
};

/// Of a level just solved or read from a file; `energy`: see energyOf.
Snapshot takeSnapshot(const Scene& scene, const Level& level, double energy);

/// How far a level is from a reference.
struct TrueError {
  double energyNorm = 0;  ///< (<W d, d> + <V δ, δ>)^½, absolute [(stress length²)^½]
  double relative = 0;    ///< the same over that of the reference
  /// (Σ h/p ‖λ - λ_ref‖² / μ)^½ over the elements of the level, over the reference's
  /// energy norm: the scaled L² norm that stands for H^-1/2 [P sec. 8], comparable to
  /// `relative`.
  double multiplier = 0;
  double energy = 0;  ///< |difference of the energies| over the reference's
};

/// On the union of the two meshes, without further error.
TrueError trueError(const Snapshot& level, const Snapshot& reference, const Scene& scene);

}  // namespace epafi::drivers
