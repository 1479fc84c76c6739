#include "contact/opposite/Obstacle.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"
#include "contact/opposite/SidePoints.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace epafi::contact {

namespace {

using bem::Vec2;
using ContactElement = MultiplierSpace::ContactElement;

const bem::Rule* ruleOfGiven(const ContactElement& contact, const Opposite::Point&) {
  return &bem::gaussForGiven(contact.degree);
}

template <class Law>
Vector fieldsAt(const LawOnBoundary<Law>& law, const char* kind,
                const ContactElement& contact, const bem::SurfacePoint& x,
                bool orZero = true) {
  Vector fields = law.fieldsAt(x);
  for (const double value : fields)
    if (!(value > 0 || (orZero && value == 0)) || !std::isfinite(value))
      throw bem::InputError(placeOf(contact), ": a field of the ", kind, " law is ",
                            value, " at (", x.x, ", ", x.y, "); it must be finite and ",
                            orZero ? ">= 0" : "> 0");
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

/// \throws bem::InputError where the surfaces' laws do not go with the basis or with a bond
void checkSurface(const ContactElement& contact, const MultiplierBasis& basis) {
  const Conditions::Contact& condition = *contact.condition;
  const Normal& normal = condition.normal;
  if (basis.sharesNodes && (normal || condition.friction.compliance || condition.wear))
    throw bem::InputError(placeOf(contact),
                          ": contacts under the multiplier 'Biorthogonal' do not yield "
                          "or wear; use Gauss-Legendre-Lagrange");
  if (contact.ties() && normal && !normal.law->isLinear())
    throw bem::InputError(
        placeOf(contact),
        ": a bond yields by the normal law 'Linear' alone; use that or none");
}

/// What a side yields and wears by at one of its Gauss points.  A law that is not linear acts on
/// values there: other bases would lose their order.
void addSurface(const SidePoint& point, const bem::SurfacePoint& x, bem::Units units,
                Obstacle& obstacle) {
  const ContactElement& contact = point.contact;
  const Conditions::Contact& condition = *contact.condition;
  Surface& surface = obstacle.surface;
  if (condition.sliding)
    obstacle.slid[point.gaussPoint()] = condition.sliding(x) / units.length;
  if (condition.wear)
    obstacle.wear[point.gaussPoint()] =
        condition.cycles * condition.wear(x) * units.stress;
  if (const bem::Function& ofShear = condition.friction.compliance)
    addLinear(
        point.weight * ofShear(x) * units.stress / units.length, point.chi,
        [&](int i) { return contact.tangentialOf(i); }, surface.linear);
  const Normal& normal = condition.normal;
  if (!normal)
    return;
  const Vector fields = fieldsAt(normal, "normal", contact, x, normal.law->isLinear());
  const PointClosing law(normal.law, fields, units);
  if (normal.law->isLinear()) {
    addLinear(
        point.weight * law.slope(0), point.chi,
        [&](int i) { return contact.normalOf(i); }, surface.linear);
    return;
  }
  if (point.chi[at(point.number)] != 1 ||
      std::count(point.chi.begin(), point.chi.end(), 0) != contact.degree)
    throw bem::InputError(placeOf(contact),
                          ": only coefficients that are values at Gauss points follow a "
                          "normal law that is not linear; use the multiplier "
                          "Gauss-Legendre-Lagrange");
  surface.places.push_back({contact.normalOf(point.number), point.weight, law});
}

/// \throws bem::InputError where the bound is found to decrease with the pressure
void checkIncreases(const PointLaw& law, const ContactElement& contact) {
  try {
    law.steepest();
  } catch (const bem::InputError& error) {
    throw bem::InputError(placeOf(contact), "->Friction->Coefficient: ", error.what());
  }
}

void addBodyLoads(const Obstacle& obstacle, Vector& r) {
  const MultiplierSpace& multiplier = obstacle.multiplier;
  const auto insideOf = [&](int body) -> const BodyLoadSolution& {
    return multiplier.conditions(at(body)).inside;
  };
  bool anywhere = false;
  for (std::size_t b = 0; b < multiplier.bodies(); ++b)
    anywhere = anywhere || multiplier.conditions(b).inside;
  if (!anywhere)
    return;
  forEachSidePoint(
      multiplier, *obstacle.opposite, ruleOfGiven, [&](const SidePoint& point) {
        const ContactElement& contact = point.contact;
        const Opposite::Point& there = point.opposite;
        Vec2 u;
        if (const BodyLoadSolution& inside = insideOf(contact.body))
          u = inside->displacement(*contact.mesh, contact.element, point.t);
        if (there.element >= 0)
          if (const BodyLoadSolution& inside = insideOf(there.body))
            u = u - inside->displacement(multiplier.mesh(at(there.body)), there.element,
                                         there.t);
        point.forEachCoefficient([&](Index i, double chi, const Direction& direction) {
          r[at(i)] += point.weight * chi * dot(u, direction.unit);
        });
      });
}

void setFriction(const ContactElement& contact, bem::Units units, Obstacle& obstacle) {
  const MultiplierSpace& multiplier = obstacle.multiplier;
  const auto tangential = [&](Index k) -> Tangential& {
    return obstacle.tangentials[k - multiplier.normals()];
  };
  if (contact.ties()) {
    for (int i = 0; i < contact.coefficients(); ++i)
      tangential(contact.numberOf(i)) = Tangential::tied();
    return;
  }
  std::vector<Index> normals;
  for (int i = 0; i <= contact.degree; ++i)
    normals.push_back(contact.normalOf(i));
  const Friction& friction = contact.condition->friction;
  std::vector<Tangential> tangentials = elementTangentials(
      multiplier.basis(), normals, friction.law,
      [&](double t) {
        const bem::SurfacePoint x = contact.mesh->physicalPoint(contact.element, t);
        return friction.law->knowsPlace() ? friction.fieldsAt(x)
                                          : fieldsAt(friction, "friction", contact, x);
      },
      units.stress);
  for (int i = 0; i <= contact.degree; ++i)
    if (contact.tangential.isOwn(i)) {
      if (friction.law->knowsPlace())
        checkIncreases(tangentials[i], contact);
      tangential(contact.tangentialOf(i)) = std::move(tangentials[i]);
    }
}

}  // namespace

Obstacle makeObstacle(const MultiplierSpace& multiplier,
                      const std::shared_ptr<const Opposite>& opposite, bem::Units units) {
  Obstacle obstacle{multiplier, opposite};
  obstacle.gap.assign(at(multiplier.normals()), 0.0);
  obstacle.jump.assign(at(multiplier.size()), 0.0);
  obstacle.tangentials.resize(at(multiplier.size() - multiplier.normals()));
  obstacle.slid.assign(at(multiplier.points()), 0.0);
  obstacle.wear = obstacle.slid;
  forEachSidePoint(multiplier, *opposite, ruleOfGiven, [&](const SidePoint& point) {
    const ContactElement& contact = point.contact;
    const double gap = point.opposite.gap;
    Vector& numbers = contact.ties() ? obstacle.jump : obstacle.gap;
    for (int i = 0; i <= contact.degree; ++i)
      if (!contact.normal.holdsNothing(i))
        numbers[at(contact.normalOf(i))] += point.weight * gap * point.chi[at(i)];
    const bem::Function& sliding = contact.condition->sliding;
    if (!sliding || !contact.shears())
      return;
    const double m =
        sliding(contact.mesh->physicalPoint(contact.element, point.t)) / units.length;
    for (int i = 0; i <= contact.degree; ++i)
      if (!contact.tangential.holdsNothing(i))
        obstacle.jump[at(contact.tangentialOf(i))] += point.weight * m * point.chi[at(i)];
  });
  multiplier.forEachElement([&](const ContactElement& contact) {
    if (contact.shears() || contact.ties())
      setFriction(contact, units, obstacle);
    checkSurface(contact, multiplier.basis());
  });
  forEachGaussPoint(multiplier, [&](const SidePoint& point) {
    const ContactElement& contact = point.contact;
    addSurface(point, contact.mesh->physicalPoint(contact.element, point.t), units,
               obstacle);
  });
  return obstacle;
}

Vector Obstacle::given() const {
  Vector r = bem::times(-1, jump);
  for (std::size_t i = 0; i < gap.size(); ++i)
    r[i] -= gap[i];
  addBodyLoads(*this, r);
  return r;
}

}  // namespace epafi::contact
