#pragma once

#include "bem/base/Material.hpp"
#include "bem/geometry/NormalRay.hpp"
#include "bem/geometry/Outline.hpp"
#include "contact/conditions/Conditions.hpp"
#include "contact/opposite/RigidDrives.hpp"
#include "contact/results/Summary.hpp"
#include "contact/stabilization/Stabilization.hpp"
#include "drivers/scene/Options.hpp"
#include "drivers/scene/Part.hpp"
#include "drivers/scene/Symmetry.hpp"

#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace epafi::drivers {

/// A point on an edge at which a mesh must have a node.
struct RequiredNode {
  int edge = 0;
  double place = 0;  ///< distance from the start of the edge, scaled
};

/// An elastic body, its conditions and its first mesh.
struct Body {
  std::string name;
  bem::Material material;
  std::shared_ptr<const bem::Outline> outline;
  contact::Conditions conditions;  ///< at the end of the path, t = 1 without one

  std::vector<int>
      elementsPerEdge;  ///< one per edge of the outline, holes after the outer loop
  int degree = 1;
  std::vector<RequiredNode> nodes;  ///< of the mesh: where contact with others ends
  std::vector<RequiredNode>
      peaks;  ///< vertices: corners that press, and what they press on
};

/// A rigid body: held, moved, or under a force at its reference point.
struct RigidBody {
  /// A component of the motion: x, y or rotation.
  struct Component {
    using Course = std::function<double(double t)>;
    bool free = false;     ///< unknown: under a force or on a spring
    Course value{};        ///< force or moment if free, else the motion [radian]
    double stiffness = 0;  ///< stiffness of the spring; 0: no spring
    Course end{};          ///< motion of its other end; empty: zero
  };
  std::string name;
  std::shared_ptr<const bem::Outline> outline;
  std::array<Component, 3> components;
  bem::Vec2 pole;  ///< reference point
  /// Resultant of the body loads about the reference point; empty: no loads.
  std::function<contact::Resultant(double t)> inside{};
};

/// A boundary of a body.
struct SideOfBody {
  bool rigid = false;
  std::size_t body = 0;  ///< index among the elastic or the rigid bodies
  std::string boundary{};

  bool isOnBodyOf(const SideOfBody& other) const {
    return rigid == other.rigid && body == other.body;
  }
  bool operator==(const SideOfBody& other) const {
    return isOnBodyOf(other) && boundary == other.boundary;
  }
};

/// Contact between two bodies: `side` carries λ.
struct ContactPair {
  std::string name;
  SideOfBody side;
  SideOfBody opposite;
};

/// A validated scene: all that a run needs, in the user's units.
struct Scene {
  std::string title;
  std::string file;
  Constants constants;  ///< names in expressions
  Tables tables;        ///< likewise

  bool isAxisymmetric = false;  ///< bodies are solids of revolution about x = 0
  Symmetry symmetry;
  std::vector<Body> bodies;
  std::vector<RigidBody> rigid;
  std::vector<ContactPair> contacts;
  double stress = 1;  ///< unit of stresses: the smallest Young's modulus

  History history;
  /// The conditions of all bodies at a time, with pins and body loads but without
  /// conducted temperatures; kinds and boundaries do not depend on time.
  std::function<std::vector<contact::Conditions>(double t)> conditionsAt;

  std::string multiplier;
  contact::Stabilization stabilization;

  SolverOptions solver;
  AdaptivityOptions adaptivity;
  OutputOptions output;

  /// The prescribed motions and loads of the rigid bodies at a time, scaled.
  std::vector<contact::Drive> drivesAt(double t) const;
  double endOfPath() const { return history.times.back(); }

  bem::Units units() const { return bodies.front().outline->units(stress); }
  /// The unit of energies of the whole scene, both halves of a symmetric one included.
  double energy() const { return symmetry.copies() * units().energy(); }
  bem::Lame lame(std::size_t b) const { return {bodies[b].material, stress}; }
  bool hasSeveral() const { return bodies.size() + rigid.size() > 1; }
  /// Are there results per body beside those of the scene (bodies.csv)?
  bool tellsBodies() const {
    return hasSeveral() || bodies.front().conditions.inside != nullptr;
  }
  /// "base", or "block:base" if there are several bodies.
  std::string boundaryName(const SideOfBody& side) const {
    return hasSeveral() ? labelOf(side) : side.boundary;
  }
  /// The names of expressions at t = 1 that do not depend on a boundary.
  Names names() const {
    Names names{constants, 1, tables};
    names.isAxisymmetric = isAxisymmetric;
    return names;
  }
  /// The complete list, which must outlive all Parts of it.
  Part root() const { return {used, {file, ""}, names()}; }

  /// Index of the elastic body that contains a point; the number of bodies if none does.
  std::size_t bodyAt(bem::Vec2 point) const {
    std::size_t b = 0;
    while (b < bodies.size() && !bodies[b].outline->contains(point))
      ++b;
    return b;
  }
  /// About which what is drawn has images: the line of symmetry, the axis of revolution.
  std::vector<Symmetry> mirrors() const;
  /// The point or its mirror image, whichever lies in a drawn body.  A point on such a line is moved to
  /// a point beside it.
  bem::Vec2 drawn(bem::Vec2 point) const;
  /// All bodies, the elastic ones first: sides without boundary.
  std::vector<SideOfBody> everyBody() const;
  const std::string& nameOf(const SideOfBody& side) const {
    return side.rigid ? rigid[side.body].name : bodies[side.body].name;
  }
  /// "block:base"
  std::string labelOf(const SideOfBody& side) const {
    return nameOf(side) + ":" + side.boundary;
  }
  const bem::Outline& outlineOf(const SideOfBody& side) const {
    return side.rigid ? *rigid[side.body].outline : *bodies[side.body].outline;
  }
  /// Difference of the scaled coordinates of a point on the opposite side and on `side`.
  bem::Vec2 shift(const ContactPair& pair) const {
    return (1 / units().length) * (outlineOf(pair.side).scaling().origin -
                                   outlineOf(pair.opposite).scaling().origin);
  }
  /// The opposite side: indices of its edges, and the edges in this scene's length.
  struct OppositeEdges {
    std::vector<int> edges;
    bem::CurveTree curves;
  };
  OppositeEdges oppositeEdges(const ContactPair& pair) const;
  /// What points of `side` see of the opposite body, in its scaled coordinates.
  bem::Visibility visibility(const ContactPair& pair) const;
  bool hasContact() const {
    return std::any_of(bodies.begin(), bodies.end(),
                       [](const Body& body) { return !body.conditions.contact.empty(); });
  }

  /// The complete list, with all defaults.
  std::shared_ptr<Teuchos::ParameterList> used;
  /// The list as given; used.xml repeats expressions from it instead of numbers.
  Teuchos::ParameterList given;
};

/// The names of an outline's boundaries, in the order of its edges.
std::vector<std::string> boundaryNames(const bem::Outline& outline);

}  // namespace epafi::drivers
