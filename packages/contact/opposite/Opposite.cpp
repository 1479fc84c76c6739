#include "contact/opposite/Opposite.hpp"

namespace epafi::contact {

using bem::Vec2;
using ContactElement = MultiplierSpace::ContactElement;

std::vector<Stretch> stretches(const Opposite& opposite, const ContactElement& element) {
  Vector ends = opposite.breaks(element);
  ends.push_back(1);
  std::vector<Stretch> result;
  double start = -1;
  for (const double end : ends) {
    result.push_back({(start + end) / 2, (end - start) / 2});
    start = end;
  }
  return result;
}

double Opposite::givenGap(const ContactElement& element, double t) const {
  const bem::Function& gap = element.condition->gap;
  return gap ? gap(mesh_.physicalPoint(element.element, t)) / length_ : 0.0;
}

Vec2 motionAt(const Motions* motions, const Opposite::Point& point) {
  if (motions == nullptr)
    return {};
  if (point.rigid >= 0)
    return motions->rigid[point.rigid].at(point.arm);
  if (point.element < 0)
    return {};
  const bem::DisplacementField& field = motions->displacements[point.body];
  const Vec2 u = field.at(point.element, point.t);
  const BodyLoadSolution inside =
      motions->inside.empty() ? nullptr : motions->inside[point.body];
  return inside ? u + inside->displacement(field.space().mesh(), point.element, point.t)
                : u;
}

}  // namespace epafi::contact
