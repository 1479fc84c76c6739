#include "contact/system/Wear.hpp"

#include "bem/quadrature/Gauss.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::contact {

namespace {

using ContactElement = MultiplierSpace::ContactElement;

constexpr double closed = 1e-9;  // of the load, as in ContactFields

/// visit(element, number of the point, t, weight)
template <class Visit>
void forEachPoint(const BodyParts& body, const Visit& visit) {
  const bem::Mesh& mesh = body.space.mesh();
  for (const ContactElement& element : body.multiplier.elements()) {
    const bem::Rule& rule = bem::gaussLegendre(element.degree + 1);
    for (int q = 0; q < rule.size(); ++q)
      visit(element, at(element.point + q), rule.points[q],
            mesh[element.element].half * rule.weights[q]);
  }
}

}  // namespace

bool wears(const MultiplierSpace& multiplier) {
  const auto& elements = multiplier.elements();
  return std::any_of(elements.begin(), elements.end(), [](const ContactElement& element) {
    return static_cast<bool>(element.condition->wear);
  });
}

Vector slips(const BodyParts& body, const Wear& before, const Vector& slip) {
  Vector result = body.obstacle.slid;
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k] -= before.slid.empty() ? 0 : before.slid[k];
  // values of a polynomial with these moments are restless unless the basis has them
  const Vector lengths =
      slip.empty() ? Vector{} : tested(body, Vector(result.size(), 1.0));
  forEachPoint(body, [&](const ContactElement& element, std::size_t k, double t, double) {
    if (element.tangential >= 0 && !slip.empty()) {
      const Vector chi = body.multiplier.basis().values(element.degree, t);
      result[k] = 0;
      for (int i = 0; i <= element.degree; ++i)
        result[k] += chi[at(i)] * std::abs(slip[at(element.tangentialOf(i))]) /
                     lengths[at(element.normalOf(i))];
      result[k] = std::max(result[k], 0.0);
    }
    result[k] = element.ties() ? 0 : std::abs(result[k]);
  });
  return result;
}

Vector wearRate(const BodyParts& body, Vector slips) {
  for (std::size_t k = 0; k < slips.size(); ++k)
    slips[k] *= body.obstacle.wear[k];
  return slips;
}

std::vector<bem::Entry> wearing(const BodyParts& body, const Vector& rate) {
  std::vector<bem::Entry> entries;
  forEachPoint(body, [&](const ContactElement& element, std::size_t k, double t,
                         double weight) {
    const Vector chi = body.multiplier.basis().values(element.degree, t);
    for (int i = 0; i <= element.degree; ++i)
      for (int j = 0; j <= element.degree; ++j)
        if (const double value = weight * rate[k] * chi[at(i)] * chi[at(j)]; value != 0)
          entries.push_back({element.normalOf(i), element.normalOf(j), value});
  });
  return entries;
}

Vector tested(const BodyParts& body, const Vector& values) {
  Vector result(at(body.multiplier.size()), 0.0);
  forEachPoint(
      body, [&](const ContactElement& element, std::size_t k, double t, double weight) {
        const Vector chi = body.multiplier.basis().values(element.degree, t);
        for (int i = 0; i <= element.degree; ++i)
          result[at(element.normalOf(i))] += weight * values[k] * chi[at(i)];
      });
  return result;
}

Wear wearBehind(const BodyParts& body, const Wear& before, const Vector& slips,
                const Vector& rate, const Vector& multiplier) {
  Wear now = before;
  now.depth.resize(slips.size());
  now.distance.resize(slips.size());
  now.slid = body.obstacle.slid;
  now.rate = rate;
  const double least = closed * body.numbers.stress;
  forEachPoint(body, [&](const ContactElement& element, std::size_t k, double t, double) {
    const double pressure = body.multiplier.at(multiplier, element, t).normal;
    now.depth[k] += rate[k] * pressure;
    if (pressure > least)
      now.distance[k] += element.condition->cycles * slips[k];
  });
  return now;
}

}  // namespace epafi::contact
