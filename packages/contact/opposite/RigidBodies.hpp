#pragma once

#include "contact/opposite/Opposite.hpp"

#include <array>

namespace epafi::contact {

/// How a body that does not deform is moved in x, in y and about its reference point: by a
/// given motion, or freely under a force and, where there is a stiffness, a spring to an end that is
/// moved.  Dimensionless.
struct Drive {
  struct Component {
    bool free = false;
    double value = 0;   ///< the force or moment of a free component; else the motion
    double inside = 0;  ///< force or moment of what acts inside
    double stiffness =
        0;           ///< k of a free component's spring, whose force is k (end - motion)
    double end = 0;  ///< motion of its other end
  };
  std::array<Component, 3> components{};
};

/// What the motions m_k of a body that does not deform, (1, 0), (0, 1) and the rotation
/// e_z x (y - y₀) over `lever`, do to a multiplier:
///
///   traces_ik = ∫ χ_i d_i · m_k∘P ds,   d_i: n or t of the side, P: Opposite::at
///
/// With components m of the motion, the last one times `lever`, contact has the
/// displacement u - traces m, and the body feels the forces tracesᵀ λ.
struct RigidTraces {
  Matrix traces;      ///< multiplier x 3
  double lever = 0;   ///< largest |y - y₀| where it is met; zero: it is met nowhere
  double length = 0;  ///< of the side that meets it
};

/// Of the rigid body of this number.
RigidTraces rigidTraces(const bem::Mesh& side, const MultiplierSpace& multiplier,
                        const Opposite& opposite, int body);

}  // namespace epafi::contact
