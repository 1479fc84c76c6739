#include "contact/system/BodyLoadTerms.hpp"

#include "bem/quadrature/Gauss.hpp"
#include "contact/opposite/SidePoints.hpp"
#include "contact/system/ContactBody.hpp"

namespace epafi::contact {

Vector bodyLoadTerms(const std::vector<ContactBody>& bodies, const Numbering& numbering) {
  const auto insideOf = [&](std::size_t b) -> const BodyLoadSolution& {
    return bodies[b].multiplier().conditions().inside;
  };
  Vector terms;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (insideOf(b))
      terms.resize(at(numbering.size()));
  for (std::size_t b = 0; b < bodies.size() && !terms.empty(); ++b) {
    const ContactBody& own = bodies[b];
    const Vector& stabilised = own.ofInside().terms;
    for (std::size_t i = 0; i < stabilised.size(); ++i)
      terms[at(numbering(b, static_cast<Index>(i)))] += stabilised[i];
    const bem::Mesh& mesh = own.space().mesh();
    forEachSidePoint(
        mesh, own.multiplier(), own.opposite(),
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
                        ->displacement(bodies[at(there.body)].space().mesh(),
                                       there.element, there.t);
          point.forEachCoefficient([&](Index i, double chi, bem::Vec2 direction) {
            terms[at(numbering(b, i))] += point.weight * chi * dot(u, direction);
          });
        });
  }
  return terms;
}

}  // namespace epafi::contact
