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
#include "drivers/scene/ConstantNumbers.hpp"
#include "drivers/scene/History.hpp"
#include "drivers/scene/LinearMethod.hpp"
#include "drivers/scene/RunOptions.hpp"
#include "drivers/scene/Symmetry.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace epafi::drivers {

/// A point of an edge at which meshes must have a node.
struct RequiredNode {
  int edge = 0;
  double place = 0;  ///< arc length from the edge's start, scaled as the outline
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

/// A rigid body.
struct RigidBody {
  /// Motion in x or y, or rotation about the reference point.
  struct Component {
    using Course = std::function<double(double t)>;
    bool free = false;     ///< under a force or on a spring; else prescribed
    Course value{};        ///< the force or moment, or the motion [radian]
    double stiffness = 0;  ///< of the spring; 0: there is none
    Course end{};          ///< motion of its other end; empty: fixed
  };
  std::string name;
  std::shared_ptr<const bem::Outline> outline;
  std::array<Component, 3> components;
  bem::Vec2 pole;  ///< reference point
  /// Resultant of body loads about the reference point; empty: none.
  std::function<contact::Resultant(double t)> inside{};
};

/// A boundary of a body.
struct SideOfBody {
  bool rigid = false;
  std::size_t body = 0;  ///< index among the elastic or the rigid bodies
  std::string boundary;
};

/// Contact between two bodies; the multiplier lives on `side`.
struct ContactPair {
  std::string name;
  SideOfBody side;
  SideOfBody met;
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
  double stress = 1;  ///< common unit of stresses

  History history;
  /// Conditions of the bodies at a time, with pins and body loads, but without conducted
  /// heat.  Their kinds do not depend on t.
  std::function<std::vector<contact::Conditions>(double t)> conditionsAt;

  std::string multiplier;
  contact::Stabilization stabilization;

  /// Options of the nonlinear solver, see solve().
  struct Solver {
    contact::ContactSolverOptions contact;
    contact::CoulombOptions coulomb;
    /// List for NOX; null: defaults of Epafi.
    std::shared_ptr<const Teuchos::ParameterList> nox;
  } solver;

  LinearOptions linear;

  struct Adaptivity {
    adaptivity::StrategyOptions strategy;
    adaptivity::EstimatorOptions estimator;
    RunLimits limits;
  } adaptivity;

  OutputOptions output;

  /// Motions, forces and springs of rigid bodies at a time.
  std::vector<contact::Drive> drivesAt(double t) const;
  double endOfPath() const { return history ? history.times.back() : 1; }

  bem::Units units() const { return bodies.front().outline->units(stress); }
  /// Unit of energies of the whole scene (twice that of a drawn half).
  double energy() const {
    return symmetry.copies() * stress * units().length * units().length;
  }
  bem::Lame lame(std::size_t b) const { return {bodies[b].material, stress}; }
  bool hasSeveral() const { return bodies.size() + rigid.size() > 1; }
  /// Does the output contain forces by bodies (bodies.csv)?
  bool tellsBodies() const {
    return hasSeveral() || bodies.front().conditions.inside != nullptr;
  }
  /// "base", or among several bodies "block:base".
  std::string boundaryName(std::size_t b, const std::string& boundary) const {
    return !hasSeveral() ? boundary : bodies[b].name + ":" + boundary;
  }
  /// Names for expressions at t = 1, without normal.
  Names names() const { return {constants, 1, {}, tables}; }

  /// Index of the body that contains a point; bodies.size() if there is none.
  std::size_t bodyAt(bem::Vec2 point) const {
    std::size_t b = 0;
    while (b < bodies.size() && !bodies[b].outline->contains(point))
      ++b;
    return b;
  }
  /// The point or its mirror image, whichever is inside a drawn body; for a point on the
  /// line of symmetry a point beside it.
  bem::Vec2 drawn(bem::Vec2 point) const;
  const std::string& nameOf(const SideOfBody& side) const {
    return side.rigid ? rigid[side.body].name : bodies[side.body].name;
  }
  const bem::Outline& outlineOf(const SideOfBody& side) const {
    return side.rigid ? *rigid[side.body].outline : *bodies[side.body].outline;
  }
  /// Scaled coordinates of a point in the opposite body minus those in the body of `side`.
  bem::Vec2 shift(const ContactPair& pair) const {
    return (1 / units().length) *
           (outlineOf(pair.side).scaling().origin - outlineOf(pair.met).scaling().origin);
  }
  /// The opposite boundary: numbers of its edges, and the edges in this scene's length.
  struct MetEdges {
    std::vector<int> edges;
    std::vector<bem::Curve> curves;
  };
  MetEdges metEdges(const ContactPair& pair) const;
  /// Largest distance of opposite points along normals: the smaller diameter, scaled.
  double reach(const ContactPair& pair) const {
    return std::min(outlineOf(pair.side).diameter(), outlineOf(pair.met).diameter()) /
           units().length;
  }
  bool hasContact() const {
    return std::any_of(bodies.begin(), bodies.end(),
                       [](const Body& body) { return !body.conditions.contact.empty(); });
  }

  /// The complete list, with defaults.
  Teuchos::RCP<Teuchos::ParameterList> used;
  /// The expressions in constants that `used` has evaluated; used.xml contains them.
  Entries expressions;
};

/// The names of an outline's boundaries, in the order of its edges.
std::vector<std::string> boundaryNames(const bem::Outline& outline);

}  // namespace epafi::drivers
