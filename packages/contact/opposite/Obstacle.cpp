#include "contact/opposite/Obstacle.hpp"

#include "bem/base/Error.hpp"
#include "contact/opposite/SidePoints.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::contact {

namespace {

using bem::Vec2;
using ContactElement = MultiplierSpace::ContactElement;

Vector fieldsAt(const ContactElement& contact, Vec2 x) {
  Vector fields = contact.condition->friction.fieldsAt(x);
  for (const double value : fields)
    if (!(value >= 0 && std::isfinite(value)))
      throw bem::InputError("boundary '", *contact.boundary,
                            "': a field of the friction law is ", value, " at (", x.x,
                            ", ", x.y, "); it must be finite and not negative");
  return fields;
}

void setFriction(const bem::Mesh& mesh, const MultiplierSpace& multiplier,
                 const ContactElement& contact, bem::Units units, Obstacle& obstacle) {
  const auto tangential = [&](Index k) -> Tangential& {
    return obstacle.tangentials[k - multiplier.normals()];
  };
  if (contact.ties()) {
    for (int i = 0; i <= contact.degree; ++i) {
      tangential(contact.normalOf(i)) = Tangential::tied();
      tangential(contact.tangentialOf(i)) = Tangential::tied();
    }
    return;
  }
  std::vector<Index> normals;
  for (int i = 0; i <= contact.degree; ++i)
    normals.push_back(contact.normalOf(i));
  std::vector<Tangential> tangentials = elementTangentials(
      multiplier.basis(), normals, contact.condition->friction.law,
      [&](double t) { return fieldsAt(contact, mesh.physicalPoint(contact.element, t)); },
      units.stress);
  for (int i = 0; i <= contact.degree; ++i)
    if (ContactElement::isOwn(contact.tangentialEnds, contact.degree, i))
      tangential(contact.tangentialOf(i)) = std::move(tangentials[i]);
}

}  // namespace

Obstacle makeObstacle(const bem::Mesh& mesh, const MultiplierSpace& multiplier,
                      const Opposite& opposite, bem::Units units) {
  Obstacle obstacle;
  obstacle.gap.assign(multiplier.normals(), 0.0);
  obstacle.jump.assign(multiplier.size(), 0.0);
  obstacle.tangentials.resize(multiplier.size() - multiplier.normals());
  forEachSidePoint(
      mesh, multiplier.elements(), opposite,
      [](const ContactElement& contact, const Opposite::Point&) {
        return &bem::gaussForGiven(contact.degree);
      },
      [&](const SidePoint& point) {
        const ContactElement& contact = point.contact;
        const double gap = point.met.gap;
        obstacle.largestPenetration =
            std::max(obstacle.largestPenetration, contact.ties() ? std::abs(gap) : -gap);
        const Vector chi = multiplier.basis().values(contact.degree, point.t);
        Vector& numbers = contact.ties() ? obstacle.jump : obstacle.gap;
        for (int i = 0; i <= contact.degree; ++i)
          if (!contact.holdsNothing(contact.normalCompletions, i))
            numbers[contact.normalOf(i)] += point.weight * gap * chi[i];
      });
  for (const ContactElement& contact : multiplier.elements())
    if (contact.tangential >= 0)
      setFriction(mesh, multiplier, contact, units, obstacle);
  return obstacle;
}

}  // namespace epafi::contact
