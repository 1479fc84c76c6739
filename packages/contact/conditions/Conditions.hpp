#pragma once

#include "bem/base/Function.hpp"
#include "bem/geometry/NormalRay.hpp"
#include "contact/conditions/ParticularSolution.hpp"
#include "contact/law/FrictionLaw.hpp"
#include "contact/law/NormalLaw.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace epafi::contact {

/// Thermal boundary conditions of a body by boundary: temperatures, and heat fluxes into the body
/// [temperature conductivity / length].  All other boundaries are insulated.
struct ThermalConditions {
  std::map<std::string, bem::Function> temperatures;
  std::map<std::string, bem::Function> flows;
  double conductivity = 1;
  std::string path = "Thermal Conditions";  ///< of the list that says so, for messages
};

/// Boundary conditions of a body by boundary, in the user's units.  All other boundaries are
/// free.
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

    bem::Vec2 at(const bem::SurfacePoint& place) const {
      return {x ? x(place) : 0.0, y ? y(place) : 0.0};
    }
  };
  /// A part of an edge of the outline, between two distances from its start, in lengths of
  /// the outline's scaling.
  struct Part {
    int edge = 0;
    double from = 0;
    double to = 0;
    bool closed = false;                     ///< the gap as drawn counts as zero
    bem::Normals along = bem::Normals::Own;  ///< along which it sees what is opposite

    bool holds(int onEdge, double place) const {
      return edge == onEdge && from <= place && place <= to;
    }
  };
  /// Unilateral contact with a rigid obstacle at distance `gap` along the outward normal, or
  /// with the outline of another body, where `gap` is added to the distance; or a support, which
  /// holds the normal displacement at `gap` and leaves the tangent to loads of `neumann`.
  struct Contact {
    bem::Function gap;
    Friction friction;
    std::string name{};         ///< of a contact with another body; else empty
    std::vector<Part> parts{};  ///< parts of the boundary in contact; empty: all of it
    Normal normal{};            ///< normal compliance of the surfaces
    /// Tangential motion (along t) of the opposite side since the beginning of the path, without
    /// change of its geometry [length]; empty: none.
    bem::Function sliding{};
    /// Worn depth per pressure and slip [1/stress]; empty: no wear.
    bem::Function wear{};
    double cycles = 1;   ///< number of repetitions of a step of a path, for wear
    std::string path{};  ///< of the list that says so, for messages
    bool isSupport = false;

    /// Is the pressure of any sign, and the gap of the condition the normal displacement against what
    /// is opposite?
    bool ties() const { return isSupport || friction.ties(); }

    /// Along whose normals a place sees what is opposite.
    bem::Normals along(int edge, double place) const {
      const auto part = std::find_if(parts.begin(), parts.end(), [&](const Part& each) {
        return each.holds(edge, place);
      });
      return part == parts.end() ? bem::Normals::Own : part->along;
    }

    bool holds(int edge, double place) const {
      return name.empty() ||
             std::any_of(parts.begin(), parts.end(),
                         [&](const Part& part) { return part.holds(edge, place); });
    }
  };

  std::map<std::string, Dirichlet> dirichlet;
  std::map<std::string, Neumann> neumann;
  std::map<std::string, Contact> contact;

  /// Parts of the boundary that sides in contact of other elastic bodies see; no load, support or
  /// contact of its own acts there.
  std::vector<Part> facing{};
  /// Does half of the interval belong to a part, or the middle of a part to the interval?
  bool faces(int edge, double from, double to) const {
    return std::any_of(facing.begin(), facing.end(), [&](const Part& part) {
      return part.holds(edge, 0.5 * (from + to)) ||
             Part{edge, from, to}.holds(part.edge, 0.5 * (part.from + part.to));
    });
  }

  /// Of `dirichlet` those on a line of symmetry, where a body goes on as its mirror image: they
  /// bound what is drawn, not the body.
  std::set<std::string> symmetry;
  bool isBoundary(const std::string& name) const { return symmetry.count(name) == 0; }

  /// Corners, by the edge that begins there, where a roller makes the other edge go on as its mirror
  /// image, with all that acts on it.
  std::set<int> images{};

  /// 1 for each component of the displacement that is prescribed on a boundary, else 0.
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

  /// Rigid motions fixed by  ∫ u·r ds = 0  over the whole boundary, lines of symmetry excluded; the
  /// reaction is a traction proportional to r.  The rotation is about the centroid of the boundary.
  struct Fix {
    bool x = false;
    bool y = false;
    bool rotation = false;
    std::string path = "Rigid Motions";  ///< of the list that says so, for messages
  } fix;

  /// Edges of known traction, one of each closed line without multiplier, that hold ψ at ν = 1/2
  /// (doc/theory/contact.md, "ν = 1/2").
  std::vector<int> pins{};

  /// Particular solution of the body loads; null: none.
  BodyLoadSolution inside{};
  /// Set if the temperature in `inside` is missing until a mesh exists, see Conduction.
  std::shared_ptr<const ThermalConditions> heat{};
};

}  // namespace epafi::contact
