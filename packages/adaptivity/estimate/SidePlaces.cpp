#include "adaptivity/estimate/SidePlaces.hpp"

namespace epafi::adaptivity {

KnownPlaces::KnownPlaces(const Element& element)
    : condition_(*element.condition), element_(element) {
  condition_.gap = nullptr;
  element_.condition = &condition_;
}

contact::ContactPlace KnownPlaces::at(const contact::Solved& solved,
                                      const Element& element, double t) {
  constexpr std::size_t most = 256;  // later ones are where a single state has a kink
  const auto found = known_.find(t);
  const Place here = found != known_.end()
                         ? found->second
                         : Place{element.mesh->physicalPoint(element.element, t),
                                 solved.problem.opposite().at(element_, t)};
  if (found == known_.end() && known_.size() < most)
    known_.emplace(t, here);
  contact::ContactPlace place{solved, element, t, here.point, here.opposite};
  if (const bem::Function& gap = element.condition->gap)
    place.opposite.gap += gap(place.place) / solved.units.length;
  return place;
}

SidePlaces::SidePlaces(const contact::Solved& any, const Fields& fields)
    : sources_(fields.size()) {
  const contact::Opposite& opposite = any.problem.opposite();
  std::vector<bool> touches(fields.size());
  for (const KnownPlaces::Element& element : any.problem.elements()) {
    touches[bem::at(element.element)] = true;
    known_.emplace_back(element);
    std::vector<bem::Vec2>& own = directions_.emplace_back();
    for (const bem::BoundaryValue& value : fields[bem::at(element.element)])
      own.push_back(opposite.at(element, value.place.t).direction.unit);
  }
  for (std::size_t e = 0; e < fields.size(); ++e)
    if (!touches[e])
      for (const bem::BoundaryValue& value : fields[e])
        sources_[e].push_back(any.problem.sources(static_cast<int>(e), value.place.t));
}

}  // namespace epafi::adaptivity
