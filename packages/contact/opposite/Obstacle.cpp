#include "contact/opposite/Obstacle.hpp"

#include "bem/base/Error.hpp"
#include "contact/opposite/SidePoints.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace epafi::contact {

namespace {

using bem::Vec2;
using ContactElement = MultiplierSpace::ContactElement;

template <class Law>
Vector fieldsAt(const LawOnBoundary<Law>& law, const char* kind,
                const ContactElement& contact, Vec2 x) {
  Vector fields = law.fieldsAt(x);
  for (const double value : fields)
    if (!(value >= 0 && std::isfinite(value)))
      throw bem::InputError("boundary '", *contact.boundary, "': a field of the ", kind,
                            " law is ", value, " at (", x.x, ", ", x.y,
                            "); it must be finite and not negative");
  return fields;
}

/// L of one component by a point of a rule: weight c χ_i χ_j.
void addLinear(double weight, const Vector& chi, const std::function<Index(int)>& number,
               std::vector<bem::Entry>& linear) {
  for (int i = 0; i < static_cast<int>(chi.size()); ++i)
    for (int j = 0; j < static_cast<int>(chi.size()); ++j)
      if (const double value = weight * chi[i] * chi[j]; value != 0)
        linear.push_back({number(i), number(j), value});
}

/// What an element's side yields and wears by, from the points of a rule by which ∫ χ_i χ_j is
/// exact.
/// A law that is not linear acts on values there: other bases would lose their order.
void setSurface(const bem::Mesh& mesh, const MultiplierSpace& multiplier,
                const ContactElement& contact, bem::Units units, Obstacle& obstacle) {
  Surface& surface = obstacle.surface;
  const Conditions::Contact& condition = *contact.condition;
  const Normal& normal = condition.normal;
  const bem::Function& ofShear = condition.friction.compliance;
  if (!normal && !ofShear && !condition.wear && !condition.sliding)
    return;
  const auto refuse = [&](const char* what, const char* instead) {
    throw bem::InputError("boundary '", *contact.boundary, "': ", what, "; ", instead);
  };
  if (multiplier.basis().sharesNodes && (normal || ofShear || condition.wear))
    refuse("contacts under the multiplier 'Biorthogonal' do not yield or wear",
           "use Gauss-Legendre-Lagrange");
  const bool isLinear = !normal || normal.law->isLinear();
  if (contact.ties() && !isLinear)
    refuse("a bond yields by the normal law 'Linear' alone", "use that or none");
  const bem::Rule& rule = bem::gaussLegendre(contact.degree + 1);
  for (int q = 0; q < rule.size(); ++q) {
    const Vec2 x = mesh.physicalPoint(contact.element, rule.points[q]);
    const double length = mesh[contact.element].half * rule.weights[q];
    const Vector chi = multiplier.basis().values(contact.degree, rule.points[q]);
    if (condition.sliding)
      obstacle.slid[at(contact.point + q)] = condition.sliding(x) / units.length;
    if (condition.wear)
      obstacle.wear[at(contact.point + q)] =
          condition.cycles * condition.wear(x) * units.stress;
    if (ofShear)
      addLinear(
          length * ofShear(x) * units.stress / units.length, chi,
          [&](int i) { return contact.tangentialOf(i); }, surface.linear);
    if (!normal)
      continue;
    const Vector fields = fieldsAt(normal, "normal", contact, x);
    const PointClosing law(normal.law, fields, units);
    if (isLinear) {
      addLinear(
          length * law.slope(0), chi, [&](int i) { return contact.normalOf(i); },
          surface.linear);
      continue;
    }
    if (*std::min_element(fields.begin(), fields.end()) <= 0)
      refuse("a field of the normal law is zero", "it must be positive");
    if (chi[q] != 1 || std::count(chi.begin(), chi.end(), 0) != contact.degree)
      refuse(
          "only coefficients that are values at Gauss points follow a normal law that "
          "is not linear",
          "use the multiplier Gauss-Legendre-Lagrange");
    surface.places.push_back({contact.normalOf(q), length, law});
  }
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
      [&](double t) {
        return fieldsAt(contact.condition->friction, "friction", contact,
                        mesh.physicalPoint(contact.element, t));
      },
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
  obstacle.slid.assign(at(multiplier.points()), 0.0);
  obstacle.wear = obstacle.slid;
  forEachSidePoint(
      mesh, multiplier.elements(), opposite,
      [](const ContactElement& contact, const Opposite::Point&) {
        return &bem::gaussForGiven(contact.degree);
      },
      [&](const SidePoint& point) {
        const ContactElement& contact = point.contact;
        const double gap = point.opposite.gap;
        obstacle.largestPenetration =
            std::max(obstacle.largestPenetration, contact.ties() ? std::abs(gap) : -gap);
        const Vector chi = multiplier.basis().values(contact.degree, point.t);
        Vector& numbers = contact.ties() ? obstacle.jump : obstacle.gap;
        for (int i = 0; i <= contact.degree; ++i)
          if (!contact.holdsNothing(contact.normalCompletions, i))
            numbers[contact.normalOf(i)] += point.weight * gap * chi[i];
        const bem::Function& sliding = contact.condition->sliding;
        if (!sliding || contact.tangential < 0)
          return;
        const double m =
            sliding(mesh.physicalPoint(contact.element, point.t)) / units.length;
        obstacle.largestSliding = std::max(obstacle.largestSliding, std::abs(m));
        for (int i = 0; i <= contact.degree; ++i)
          if (!contact.holdsNothing(contact.tangentialCompletions, i))
            obstacle.jump[contact.tangentialOf(i)] += point.weight * m * chi[i];
      });
  for (const ContactElement& contact : multiplier.elements()) {
    if (contact.tangential >= 0)
      setFriction(mesh, multiplier, contact, units, obstacle);
    setSurface(mesh, multiplier, contact, units, obstacle);
  }
  return obstacle;
}

}  // namespace epafi::contact
