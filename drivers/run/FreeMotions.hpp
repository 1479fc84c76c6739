#pragma once

#include "drivers/run/BodySpaces.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// The free rigid motions of each elastic body, as displacements.
using FreeMotions = std::vector<std::vector<bem::Vector>>;

/// A rigid motion of a body.
struct Moved {
  double size = 0;  ///< of the largest displacement, scaled
  std::string body{};
  std::string how{};  ///< " in the direction (0, 1)", " about (0, 3)"
  double unit = 1;    ///< of force or moment: the displacement or the angle, scaled
  bool turns = false;
};

/// A rigid displacement U + θ e_z x (x - c), c the nodes' mean, scaled.
struct RigidPart {
  bem::Vec2 centre{};
  bem::Vec2 mean{};  ///< U
  double turn = 0;   ///< θ
  double farthest = 0;
};

RigidPart rigidPart(const bem::Vector& u, const bem::Space& space);

/// The motions of all bodies for amplitudes of the free ones, the elastic bodies first.
std::vector<Moved> movedBy(const bem::Vector& amplitudes, const BodySpaces& spaces,
                           const FreeMotions& free);

/// To three digits of a unit, zero without a sign.
double tidy(double x, double unit);

/// " in the direction (0, 1)"
std::string direction(bem::Vec2 u);

}  // namespace epafi::drivers
