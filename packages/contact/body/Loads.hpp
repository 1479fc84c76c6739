#pragma once

#include "bem/base/Material.hpp"
#include "bem/space/Space.hpp"
#include "contact/conditions/Conditions.hpp"

namespace epafi::contact {

using bem::at;
using bem::Index;
using bem::Matrix;
using bem::Vector;

/// Loads and prescribed displacements as numbers, dimensionless.
struct Loads {
  /// f_j = ∫ traction · φ_j ds; with body loads minus that of the traction of the particular
  /// solution, plus its term in the stabilisation.
  Vector load;
  /// A displacement with the clamped values; elsewhere its rigid part, and, with pins, what keeps
  /// the volume.
  Vector prescribed;
  /// The rigid motion next to the clamped values, which deforms nothing; empty: zero.
  Vector rigidPart{};
  double largestTraction = 0;
  double largestDeformation = 0;  ///< of clamped values, less the rigid part

  /// With body loads, of the particular solution u_p, t_p; else empty and zero.
  struct OfInside {
    Vector traction;                ///< ∫ t_p · φ_j ds
    double work = 0;                ///< ∫ given traction · u_p ds
    double largestDeformation = 0;  ///< of u_p on the boundary, less its rigid part
  } inside{};
  Vector given{};  ///< ∫ traction · φ_j ds of the given traction; empty: `load`

  /// What a known traction t, that of body loads less that on supports, does in the residual
  /// λ + t + S u of the stabilisation, independent of u and λ; empty: zero.   [doc/theory/body-loads.md]
  struct InResidual {
    Vector weights;     ///< by G's rows: <γ t, P> as G λ has <γ λ, P>
    Vector force;       ///< to f
    Vector terms;       ///< to C u - M λ, with -<γ t, χ_i>
    Vector means;       ///< to ∫ u·r of the motions r that Fix holds, with <γ t, r>
    Vector density;     ///< to ψ
    Vector compliance;  ///< g = <γ t, P_i> of all densities, K u - (V + G) ψ - N λ = g
  } residual{};

  /// What deforms or presses, however far the body moves.
  double size() const {
    return largestTraction + largestDeformation + inside.largestDeformation;
  }
};

/// \throws bem::InputError for a condition on an unknown boundary, or for two on one boundary,
///   except a displacement along one axis and a traction along the other
Loads makeLoads(const bem::Space& space, const Conditions& conditions, bem::Units units);

/// 1 for each displacement that a Dirichlet condition prescribes, else 0.
std::vector<char> prescribed(const bem::Space& space, const Conditions& conditions);

/// ∫ φ_j · r ds for the rigid motions r of Space::rigidMotions, with the rotation about
/// the boundary's centroid: 3 vectors over the displacements.  Lines of symmetry do not count.
struct RigidModes {
  Matrix motions;      ///< displacements x 3: (1,0), (0,1), rotation about the centroid
  Matrix functionals;  ///< displacements x 3: column k pairs u to ∫ u · r_k ds
  bem::Vec2 centroid;  ///< in scaled coordinates

  /// r_k at a point, in scaled coordinates.
  bem::Vec2 at(Index k, bem::Vec2 x) const {
    return k == 2 ? turnLeft(x - centroid) : k == 1 ? bem::Vec2{0, 1} : bem::Vec2{1, 0};
  }
};

RigidModes makeRigidModes(const bem::Space& space, const Conditions& conditions = {});

/// ∫ u_p · r_k ds for the rigid modes r_k; empty without body loads.
Vector meansOf(const Conditions& conditions, const bem::Mesh& mesh, bem::Vec2 centroid);

}  // namespace epafi::contact
