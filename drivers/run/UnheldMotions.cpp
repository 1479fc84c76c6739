#include "drivers/run/UnheldMotions.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"
#include "contact/equation/Equilibrium.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace epafi::drivers {

namespace {

using bem::Vector;

/// Takes from a vector what orthonormal ones have of it; twice, for rounding.
void orthogonalise(const std::vector<Vector>& basis, Vector& v) {
  for (int pass = 0; pass < 2; ++pass)
    for (const Vector& q : basis)
      bem::axpy(-bem::dot(q, v), q, v);
}

}  // namespace

void checkResistance(const Scene& scene, const contact::ContactSystem& system) {
  if (!scene.hasSeveral())
    return;
  constexpr double rounding = 1e-9;
  const bem::Matrix& motions = system.numbers().rigid;
  double largest = 0;
  for (bem::Index k = 0; k < motions.columns(); ++k) {
    const Vector column = bem::columnOf(motions, k);
    largest = std::max(largest, std::sqrt(bem::dot(column, column)));
  }
  std::vector<Vector> basis;
  bem::Index k = 0;
  const auto resist = [&](const std::string& name, const char* advice) {
    Vector rest = bem::columnOf(motions, k++);
    orthogonalise(basis, rest);
    const double size = std::sqrt(bem::dot(rest, rest));
    if (!(size > rounding * largest))
      throw bem::InputError("Bodies->", name,
                            ": can move as a rigid body in a way that nothing resists; ",
                            advice);
    for (double& x : rest)
      x /= size;
    basis.push_back(std::move(rest));
  };
  for (std::size_t b = 0; b < system.size(); ++b)
    for (bem::Index own = 0; own < system.body(b).freeMotions(); ++own)
      resist(scene.bodies[b].name,
             "hold it by a Dirichlet condition, Rigid Motions->Fix, contact or friction");
  for (const RigidBody& body : scene.rigid)
    for (const RigidBody::Component& component : body.components)
      if (component.free)
        resist(body.name,
               "give it a Displacement or a Rotation instead of a Force or a Moment, or "
               "contact or friction");
}

namespace {

struct Moved {
  double size = 0;    ///< of the largest displacement, scaled
  std::string words;  ///< "drives Bodies->pad in the direction (0, 1)"
};

/// To three digits of a unit, zero without a sign.
double tidy(double x, double unit) {
  return std::round(1000 * x / unit) / 1000 * unit + 0.0;
}

std::string direction(bem::Vec2 u) {
  const double size = norm(u);
  return bem::message(" in the direction (", tidy(u.x / size, 1), ", ",
                      tidy(u.y / size, 1), ")");
}

/// Of a rigid displacement: U + θ e_z x (x - c), c the nodes' mean.
Moved movedBy(const Vector& u, const bem::Space& space, const Body& body) {
  const bem::Mesh& mesh = space.mesh();
  bem::Vec2 centre;
  bem::Vec2 mean;
  for (int e = 0; e < mesh.size(); ++e) {
    centre = centre + (1.0 / mesh.size()) * mesh.scaledPoint(e, -1);
    mean = mean + (1.0 / mesh.size()) * space.displacementAt(u, e, -1);
  }
  double turn = 0;
  double squares = 0;
  double farthest = 0;
  for (int e = 0; e < mesh.size(); ++e) {
    const bem::Vec2 arm = mesh.scaledPoint(e, -1) - centre;
    turn += cross(arm, space.displacementAt(u, e, -1) - mean);
    squares += dot(arm, arm);
    farthest = std::max(farthest, norm(arm));
  }
  turn /= squares;
  const double arc = std::abs(turn) * farthest;
  const bool turns = arc > 1e-6 * norm(mean);
  std::string how = direction(mean);
  if (turns) {
    const bem::Vec2 pole = body.outline->physical(centre + (1 / turn) * turnLeft(mean));
    const double length = body.outline->diameter();
    how = bem::message(" about (", tidy(pole.x, length), ", ", tidy(pole.y, length), ")");
  }
  return {norm(mean) + arc,
          (turns ? "turns Bodies->" : "drives Bodies->") + body.name + how};
}

Moved movedBy(const std::array<double, 3>& components, const RigidBody& body) {
  const bem::Vec2 slide{components[0], components[1]};
  const double turn = std::abs(components[2]);
  return {norm(slide) + turn, turn > 1e-6 * norm(slide)
                                  ? "turns Bodies->" + body.name
                                  : "drives Bodies->" + body.name + direction(slide)};
}

}  // namespace

std::string unresisted(const Scene& scene, const BodySpaces& spaces,
                       const contact::ContactSystem& system) {
  const Vector motion = contact::unresistedMotion(system.numbers());
  if (motion.empty())
    return "";
  Moved most;
  const auto keepLarger = [&](Moved moved) {
    if (moved.size > most.size)
      most = std::move(moved);
  };
  const double* next = motion.data();
  for (std::size_t b = 0; b < system.size(); ++b) {
    keepLarger(movedBy(system.body(b).moved(next), spaces.space(b), scene.bodies[b]));
    next += system.body(b).freeMotions();
  }
  for (const RigidBody& body : scene.rigid) {
    std::array<double, 3> components{};
    for (std::size_t c = 0; c < 3; ++c)
      if (body.components[c].free)
        components[c] = *next++;
    keepLarger(movedBy(components, body));
  }
  return "the load " + most.words +
         ", a rigid motion in which neither contact nor friction can balance it";
}

}  // namespace epafi::drivers
