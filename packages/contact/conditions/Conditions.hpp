#pragma once

#include "bem/base/Function.hpp"
#include "contact/conditions/ParticularSolution.hpp"
#include "contact/law/FrictionLaw.hpp"
#include "contact/law/NormalLaw.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace epafi::contact {

/// What a scene says about heat on a body's boundaries: temperatures, and flows into the body
/// [temperature conductivity / length].  One that is not mentioned is insulated.
struct ThermalConditions {
  std::map<std::string, bem::Function> temperatures;
  std::map<std::string, bem::Function> flows;
  double conductivity = 1;
  std::string path = "Thermal Conditions";  ///< of the list that says so, for messages
};

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

    bem::Vec2 at(bem::Vec2 place) const {
      return {x ? x(place) : 0.0, y ? y(place) : 0.0};
    }
  };
  /// A part of an edge of the outline, between two distances from its start, in lengths of
  /// the outline's scaling.
  struct Part {
    int edge = 0;
    double from = 0;
    double to = 0;
  };
  /// Unilateral contact with a rigid obstacle at distance `gap` along the outward normal, or
  /// with the outline of another body, which `gap` is added to the distance of.
  struct Contact {
    bem::Function gap;
    Friction friction;
    std::string name{};         ///< the scene's for contact with another body; else empty
    std::vector<Part> parts{};  ///< of the boundary that meets it; else all of it does
    Normal normal{};            ///< how far the sides yield
    /// Motion of what is met along t since the path's beginning, where its geometry stays
    /// [length]; none: it stands still.
    bem::Function sliding{};
    /// Depth that a pressure wears off per slip [1/stress]; none: nothing wears.
    bem::Function wear{};
    double cycles = 1;  ///< how many times a step of a path happens, for what wears

    bool holds(int edge, double place) const {
      return name.empty() ||
             std::any_of(parts.begin(), parts.end(), [&](const Part& part) {
               return part.edge == edge && part.from <= place && place <= part.to;
             });
    }
  };

  std::map<std::string, Dirichlet> dirichlet;
  std::map<std::string, Neumann> neumann;
  std::map<std::string, Contact> contact;

  /// Of `dirichlet` those on a line of symmetry, where a body goes on as its mirror image: they
  /// bound what is drawn, not the body.
  std::set<std::string> symmetry;
  bool isBoundary(const std::string& name) const { return symmetry.count(name) == 0; }

  /// Which components of the displacement are given on a boundary: 1 or 0 each.
  bem::Vec2 given(const std::string& boundary) const {
    const auto found = dirichlet.find(boundary);
    if (found == dirichlet.end())
      return {};
    return {found->second.x ? 1.0 : 0.0, found->second.y ? 1.0 : 0.0};
  }

  /// The contact of a boundary where it is in the middle of a piece of an edge, if any.
  const Contact* contactOn(const std::string& boundary, int edge, double place) const {
    const auto found = contact.find(boundary);
    return found != contact.end() && found->second.holds(edge, place) ? &found->second
                                                                      : nullptr;
  }

  /// Rigid motions held by  ∫ u·r ds = 0  over the whole boundary but lines of symmetry; the reaction acts as a
  /// uniform traction of that mode.  Rotation is about the boundary's centroid.
  struct Fix {
    bool x = false;
    bool y = false;
    bool rotation = false;
    std::string path = "Rigid Motions";  ///< of the list that says so, for messages
  } fix;

  /// Edges without load, one of each closed line without multiplier, that hold ψ at ν = 1/2
  /// (doc/theory/contact.md, "ν = 1/2").
  std::vector<int> pins{};

  /// What acts inside the body; none: nothing does.
  Inside inside{};
  /// Where `inside` is without its temperature as long as a mesh is not known (Conduction).
  std::shared_ptr<const ThermalConditions> heat{};
};

}  // namespace epafi::contact
