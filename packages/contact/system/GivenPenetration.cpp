#include "contact/system/GivenPenetration.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "contact/opposite/SidePoints.hpp"

namespace epafi::contact {

using bem::axpy;

void addObstacle(const Obstacle& obstacle, const Numbering& numbering, std::size_t b,
                 Problem& problem, Vector& r) {
  for (const Tangential& tangential : obstacle.tangentials)
    problem.tangentials.push_back(tangential.shifted(numbering(b, 0)));
  for (Index i = 0; i < numbering.sizeOf(b); ++i)
    r[at(numbering(b, i))] -=
        obstacle.jump[at(i)] + (i < numbering.normalsOf(b) ? obstacle.gap[at(i)] : 0);
  for (const auto& [row, column, value] : obstacle.surface.linear)
    problem.surface.linear.push_back({numbering(b, row), numbering(b, column), value});
  for (const auto& [i, length, law] : obstacle.surface.places)
    problem.surface.places.push_back({numbering(b, i), length, law});
}

void addBodyLoads(const std::vector<ContactSide>& sides, const Numbering& numbering,
                  Vector& r) {
  const auto insideOf = [&](std::size_t b) -> const BodyLoadSolution& {
    return sides[b].multiplier.conditions().inside;
  };
  bool anywhere = false;
  for (std::size_t b = 0; b < sides.size(); ++b)
    anywhere = anywhere || insideOf(b);
  for (std::size_t b = 0; b < sides.size() && anywhere; ++b) {
    const bem::Mesh& mesh = sides[b].space.mesh();
    forEachSidePoint(
        mesh, sides[b].multiplier, sides[b].opposite,
        [](const auto& contact, const Opposite::Point&) {
          return &bem::gaussForGiven(contact.degree);
        },
        [&](const SidePoint& point) {
          const Opposite::Point& there = point.opposite;
          bem::Vec2 u;
          if (insideOf(b))
            u = insideOf(b)->displacement(mesh, point.contact.element, point.t);
          if (there.element >= 0 && insideOf(at(there.body)))
            u = u - insideOf(at(there.body))
                        ->displacement(sides[at(there.body)].space.mesh(), there.element,
                                       there.t);
          point.forEachCoefficient([&](Index i, double chi, const Direction& direction) {
            r[at(numbering(b, i))] += point.weight * chi * dot(u, direction.unit);
          });
        });
  }
}

void addRigidPart(const Loads& loads, const Numbering& numbering, std::size_t b,
                  const TraceCoupling& own, const TraceCoupling& opposite, Vector& r) {
  if (!loads.rigidPart.empty())
    axpy(1,
         onAllMultipliers(numbering, b, own.apply(loads.rigidPart), opposite,
                          loads.rigidPart),
         r);
}

}  // namespace epafi::contact
