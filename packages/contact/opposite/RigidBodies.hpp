#pragma once

#include "contact/opposite/Opposite.hpp"

#include <array>

namespace epafi::contact {

/// Given motion of a rigid body, or the force on it, in x, in y and about its reference point; a free
/// component may be held by a spring.  Dimensionless.
struct Drive {
  struct Component {
    bool free = false;
    double value = 0;      ///< force or moment of a free component; else the motion
    double inside = 0;     ///< force or moment of body loads
    double stiffness = 0;  ///< of the spring, whose force is stiffness (end - motion)
    double end = 0;        ///< motion of the spring's other end
  };
  std::array<Component, 3> components{};
};

/// Coupling of a multiplier with the motions m_k of a rigid body: (1, 0), (0, 1) and the
/// rotation e_z x (y - y₀) / lever:
///
///   traces_ik = ∫ χ_i d_i · m_k∘P ds,   d_i: n or t of the side, P: Opposite::at
///
/// For a motion m (rotation times `lever`) the contact conditions contain C u - traces m, and
/// the forces on the body are tracesᵀ λ.
struct RigidTraces {
  Matrix traces;      ///< multiplier x 3
  double lever = 0;   ///< largest |y - y₀| at contacts; zero: it has none
  double length = 0;  ///< of the side that meets it
};

/// Of the rigid body of this number.
RigidTraces rigidTraces(const bem::Mesh& side, const MultiplierSpace& multiplier,
                        const Opposite& opposite, int body);

}  // namespace epafi::contact
