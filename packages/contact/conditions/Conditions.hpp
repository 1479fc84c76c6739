#pragma once

#include "bem/base/Function.hpp"
#include "contact/law/FrictionLaw.hpp"

#include <map>
#include <string>
#include <vector>

namespace epafi::contact {

/// What a scene says about the boundaries; functions of a point and numbers in the user's
/// units.  A boundary that is not mentioned is free.
struct Conditions {
  /// An empty component is free: a roller.
  struct Dirichlet {
    bem::Function x;
    bem::Function y;
  };
  /// Traction on the body; an empty component is zero.
  struct Neumann {
    bem::Function x;
    bem::Function y;
  };
  /// Unilateral contact with a rigid obstacle at distance `gap` along the outward normal.
  struct Contact {
    bem::Function gap;
    Friction friction;
  };

  std::map<std::string, Dirichlet> dirichlet;
  std::map<std::string, Neumann> neumann;
  std::map<std::string, Contact> contact;

  /// Rigid motions held by  ∫ u·r ds = 0  over the whole boundary; the reaction acts as a
  /// uniform traction of that mode.  Rotation is about the boundary's centroid.
  struct Fix {
    bool x = false;
    bool y = false;
    bool rotation = false;
  } fix;
};

}  // namespace epafi::contact
