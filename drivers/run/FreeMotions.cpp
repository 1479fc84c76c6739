#include "drivers/run/FreeMotions.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"
#include "bem/space/DisplacementField.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace epafi::drivers {

using bem::Vector;

double tidy(double x, double unit) {
  return std::round(1000 * x / unit) / 1000 * unit + 0.0;
}

std::string direction(bem::Vec2 u) {
  const double size = norm(u);
  return bem::message(" in the direction (", tidy(u.x / size, 1), ", ",
                      tidy(u.y / size, 1), ")");
}

RigidPart rigidPart(const Vector& u, const bem::Space& space) {
  const bem::Mesh& mesh = space.mesh();
  const bem::DisplacementField field(space, u);
  RigidPart part;
  for (int e = 0; e < mesh.size(); ++e) {
    part.centre = part.centre + (1.0 / mesh.size()) * mesh.scaledPoint(e, -1);
    part.mean = part.mean + (1.0 / mesh.size()) * field.at(e, -1);
  }
  double squares = 0;
  for (int e = 0; e < mesh.size(); ++e) {
    const bem::Vec2 arm = mesh.scaledPoint(e, -1) - part.centre;
    part.turn += cross(arm, field.at(e, -1) - part.mean);
    squares += dot(arm, arm);
    part.farthest = std::max(part.farthest, norm(arm));
  }
  part.turn /= squares;
  return part;
}

namespace {

Moved movedBy(const Vector& u, const bem::Space& space, const Body& body) {
  const auto [centre, mean, turn, farthest] = rigidPart(u, space);
  const double arc = std::abs(turn) * farthest;
  const bool turns = arc > 1e-3 * norm(mean);  // else about a point far away
  std::string how = direction(mean);
  if (turns) {
    const bem::Vec2 pole = body.outline->physical(centre + (1 / turn) * turnLeft(mean));
    const double length = body.outline->diameter();
    how = bem::message(" about (", tidy(pole.x, length), ", ", tidy(pole.y, length), ")");
  }
  return {norm(mean) + arc, body.name, how, turns ? std::abs(turn) : norm(mean), turns};
}

Moved movedBy(const std::array<double, 3>& components, const RigidBody& body) {
  const bem::Vec2 slide{components[0], components[1]};
  const double turn = std::abs(components[2]);
  const bool turns = turn > 1e-3 * norm(slide);
  return {norm(slide) + turn, body.name, turns ? "" : direction(slide),
          turns ? turn : norm(slide), turns};
}

}  // namespace

std::vector<Moved> movedBy(const Vector& amplitudes, const BodySpaces& spaces,
                           const FreeMotions& free) {
  const Scene& scene = spaces.scene();
  std::vector<Moved> result;
  const double* next = amplitudes.data();
  for (std::size_t b = 0; b < free.size(); ++b) {
    Vector moved(spaces.space(b).displacements());
    for (const Vector& one : free[b])
      bem::axpy(*next++, one, moved);
    result.push_back(movedBy(moved, spaces.space(b), scene.bodies[b]));
  }
  for (const RigidBody& body : scene.rigid) {
    std::array<double, 3> components{};
    for (std::size_t c = 0; c < 3; ++c)
      if (body.components[c].free)
        components[c] = *next++;
    result.push_back(movedBy(components, body));
  }
  return result;
}

}  // namespace epafi::drivers
