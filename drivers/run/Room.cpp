#include "drivers/run/Room.hpp"

#include "bem/base/Error.hpp"
#include "bem/quadrature/Gauss.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace epafi::drivers {

namespace {

/// By how much the area of a body may grow.
struct Room {
  double area = 0;  ///< ∫ gap ds over contacts + ∫ u·n ds over clamps, ds scaled
  double size = 0;  ///< of the same, absolute values
  bool isLimited = true;   ///< by conditions all around
  bool isContact = false;  ///< at least on a part

  bool isKnown() const { return isLimited && isContact; }
  bool isMissing() const { return area < -1e-6 * size; }  // the rest is quadrature's
};

Room roomOf(const bem::Mesh& mesh, const contact::Conditions& conditions) {
  Room room;
  room.isLimited = conditions.inside == nullptr && !conditions.heat;
  const bem::Rule& rule = bem::gaussLegendre(8);
  for (int e = 0; e < mesh.size() && room.isLimited; ++e) {
    const auto clamp = conditions.dirichlet.find(mesh.boundary(e));
    const auto contact = conditions.contact.find(mesh.boundary(e));
    const bool meets = contact != conditions.contact.end();
    if (meets ? !contact->second.name.empty() || contact->second.normal ||
                    contact->second.wear
              : clamp == conditions.dirichlet.end())
      room.isLimited = false;
    else
      for (std::size_t q = 0; q < rule.points.size() && room.isLimited; ++q) {
        const bem::SurfacePoint x = mesh.physicalPoint(e, rule.points[q]);
        double outwards = meets && contact->second.gap ? contact->second.gap(x) : 0;
        if (!meets) {
          for (const auto& [given, along] : {std::pair(&clamp->second.x, x.normal.x),
                                             std::pair(&clamp->second.y, x.normal.y)})
            if (*given)
              outwards += (*given)(x)*along;
            else if (std::abs(along) > 1e-12)
              room.isLimited = false;
        }
        const double share = rule.weights[q] * mesh.measure(e, rule.points[q]);
        room.area += share * outwards;
        room.size += share * std::abs(outwards);
        room.isContact = room.isContact || (meets && !contact->second.isSupport);
      }
  }
  return room;
}

}  // namespace

void checkRoom(const BodySpaces& spaces, double t) {
  const Scene& scene = spaces.scene();
  const auto isIncompressible = [](const Body& body) {
    return body.material.poissonsRatio >= 0.5 && !body.material.planeStress;
  };
  if (std::none_of(scene.bodies.begin(), scene.bodies.end(), isIncompressible))
    return;
  const std::vector<contact::Conditions> conditions = scene.conditionsAt(t);
  for (std::size_t b = 0; b < spaces.size(); ++b)
    if (const Room room = roomOf(spaces.space(b).mesh(), conditions[b]);
        isIncompressible(scene.bodies[b]) && room.isKnown() && room.isMissing())
      throw bem::InputError(
          "Bodies->", scene.bodies[b].name,
          ": is incompressible (Poisson's Ratio 1/2) and enclosed: contact and "
          "prescribed "
          "displacements take ",
          -room.area * scene.symmetry.copies() * scene.units().length,
          scene.history ? bem::message(" at t = ", t) : "",
          " of its area, and it has none to give; leave it a free side or room, or take "
          "a smaller Poisson's Ratio");
}

}  // namespace epafi::drivers
