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
  const auto number = static_cast<int>(any.problem.number());
  for (std::size_t e = 0; e < fields.size(); ++e)
    for (const bem::BoundaryValue& value : fields[e]) {
      if (touches[e])
        break;
      std::vector<Source>& own = sources_[e].emplace_back();
      for (const contact::Opposite::Source& source :
           opposite.sources(number, static_cast<int>(e), value.place.t))
        own.push_back({source, opposite.at(*source.element, source.t).direction.unit});
    }
}

bem::Vec2 SidePlaces::pressed(const contact::Solved& solved, int element,
                              std::size_t point) const {
  bem::Vec2 sum;
  for (const auto& [source, across] : sources_[bem::at(element)][point]) {
    const auto stress = solved.problem.multiplier().at(solved.state.multiplier,
                                                       *source.element, source.t);
    sum = sum + source.stretching *
                    (stress.normal * across + stress.tangential * turnLeft(across));
  }
  return sum;
}

}  // namespace epafi::adaptivity
