#include "drivers/run/UnheldMotions.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"

#include <algorithm>
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
      throw bem::InputError(bem::message(
          "Bodies->", name, ": can move as a rigid body in a way that nothing resists; ",
          advice));
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

}  // namespace epafi::drivers
