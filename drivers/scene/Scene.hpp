#pragma once

#include "adaptivity/estimate/ResidualEstimator.hpp"
#include "adaptivity/mark/Strategy.hpp"
#include "bem/base/Material.hpp"
#include "bem/geometry/Outline.hpp"
#include "contact/conditions/Conditions.hpp"
#include "contact/opposite/RigidBodies.hpp"
#include "contact/results/Summary.hpp"
#include "contact/solve/CoulombIteration.hpp"
#include "contact/stabilization/Stabilization.hpp"
#include "drivers/scene/History.hpp"
#include "drivers/scene/LinearMethod.hpp"
#include "drivers/scene/Part.hpp"
#include "drivers/scene/RunOptions.hpp"
#include "drivers/scene/Symmetry.hpp"

#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace epafi::drivers {

/// A place on an edge that a mesh must have a node at.
struct RequiredNode {
  int edge = 0;
  double place = 0;  ///< from the edge's start, in lengths of the outline's scaling
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
};

/// A body without elasticity: held, moved, or under a force, about its reference point.
struct RigidBody {
  /// Of x, y and the rotation.
  struct Component {
    using Course = std::function<double(double t)>;
    bool free = false;     ///< under a force, by a spring
    Course value{};        ///< the force or moment, or the motion [radian]
    double stiffness = 0;  ///< of the spring; 0: there is none
    Course end{};          ///< the motion of its other end; empty: it stays
  };
  std::string name;
  std::shared_ptr<const bem::Outline> outline;
  std::array<Component, 3> components;
  bem::Vec2 pole;  ///< reference point
  /// Of what acts inside, about that point; empty: nothing does.
  std::function<contact::Resultant(double t)> inside{};
};

/// A boundary of a body.
struct SideOfBody {
  bool rigid = false;
  std::size_t body = 0;  ///< among the elastic ones or among the rigid ones
  std::string boundary;
};

/// Contact between two bodies; the multiplier lives on `side`.
struct ContactPair {
  std::string name;
  SideOfBody side;
  SideOfBody opposite;
};

/// A scene, read and validated: everything that a run needs, in the user's units.
struct Scene {
  std::string title;
  std::string file;
  Constants constants;  ///< that its expressions know
  Tables tables;        ///< likewise

  Symmetry symmetry;
  std::vector<Body> bodies;
  std::vector<RigidBody> rigid;
  std::vector<ContactPair> contacts;
  double stress = 1;  ///< that all of them count in

  History history;
  /// The bodies' conditions at a time, their pins included, what is inside without heat that is
  /// conducted; of the same kinds on the same
  /// boundaries at all times.
  std::function<std::vector<contact::Conditions>(double t)> conditionsAt;

  std::string multiplier;
  contact::Stabilization stabilization;

  /// What a nonlinear solver is assembled from, see solve().
  struct Solver {
    contact::ContactSolverOptions contact;
    contact::CoulombOptions coulomb;
    /// Handed to NOX in every run; null means Epafi's own choice.
    std::shared_ptr<const Teuchos::ParameterList> nox;

    void keys(bem::Keys& keys) {
      coulomb.keys(keys);
      contact.keys(keys);
    }
  } solver;

  LinearOptions linear;

  struct Adaptivity {
    adaptivity::StrategyOptions strategy;
    adaptivity::EstimatorOptions estimator;
    RunLimits limits;

    void keys(bem::Keys& keys) {
      strategy.keys(keys);
      estimator.keys(keys);
      limits.keys(keys);
    }
  } adaptivity;

  OutputOptions output;

  /// How bodies without elasticity are moved at a time.
  std::vector<contact::Drive> drivesAt(double t) const;
  double endOfPath() const { return history ? history.times.back() : 1; }

  bem::Units units() const { return bodies.front().outline->units(stress); }
  /// The unit of energies of the whole scene, of which the half may be drawn.
  double energy() const {
    return symmetry.copies() * stress * units().length * units().length;
  }
  bem::Lame lame(std::size_t b) const { return {bodies[b].material, stress}; }
  bool hasSeveral() const { return bodies.size() + rigid.size() > 1; }
  /// Do bodies have forces of their own to be told, beside those of the scene?
  bool tellsBodies() const {
    return hasSeveral() || bodies.front().conditions.inside != nullptr;
  }
  /// "base", or among several bodies "block:base".
  std::string boundaryName(std::size_t b, const std::string& boundary) const {
    return !hasSeveral() ? boundary : bodies[b].name + ":" + boundary;
  }
  /// What its expressions know at t = 1, where no boundary is meant.
  Names names() const { return {constants, 1, {}, tables}; }
  /// Its complete list, which must outlive what is made of it.
  Part root() const { return {used, {file, ""}, names()}; }

  /// The body that a point lies inside; their number if there is none.
  std::size_t bodyAt(bem::Vec2 point) const {
    std::size_t b = 0;
    while (b < bodies.size() && !bodies[b].outline->contains(point))
      ++b;
    return b;
  }
  /// What lies inside a body that is drawn where a point or its mirror image does: that one; of a
  /// point on the line of symmetry, which bounds what is drawn, one beside it.
  bem::Vec2 drawn(bem::Vec2 point) const;
  const std::string& nameOf(const SideOfBody& side) const {
    return side.rigid ? rigid[side.body].name : bodies[side.body].name;
  }
  const bem::Outline& outlineOf(const SideOfBody& side) const {
    return side.rigid ? *rigid[side.body].outline : *bodies[side.body].outline;
  }
  /// A scaled place on the opposite side less the same place on the side.
  bem::Vec2 shift(const ContactPair& pair) const {
    return (1 / units().length) * (outlineOf(pair.side).scaling().origin -
                                   outlineOf(pair.opposite).scaling().origin);
  }
  /// The opposite boundary: its edges' numbers, and the edges in this scene's length.
  struct OppositeEdges {
    std::vector<int> edges;
    std::vector<bem::Curve> curves;
  };
  OppositeEdges oppositeEdges(const ContactPair& pair) const;
  /// How far along its normals a side looks: the smaller one's diameter, scaled.
  double reach(const ContactPair& pair) const {
    return std::min(outlineOf(pair.side).diameter(),
                    outlineOf(pair.opposite).diameter()) /
           units().length;
  }
  bool hasContact() const {
    return std::any_of(bodies.begin(), bodies.end(),
                       [](const Body& body) { return !body.conditions.contact.empty(); });
  }

  /// The complete list with every default filled in.
  std::shared_ptr<Teuchos::ParameterList> used;
  /// What it is made of: expressions in place of numbers, which used.xml says.
  Teuchos::ParameterList given;
};

/// The names of an outline's boundaries, in the order of its edges.
std::vector<std::string> boundaryNames(const bem::Outline& outline);

}  // namespace epafi::drivers
