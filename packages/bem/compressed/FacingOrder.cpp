#include "bem/compressed/FacingOrder.hpp"

#include <algorithm>
#include <map>

namespace epafi::bem {

namespace {

/// Where an element stands.
struct Standing {
  int zone = -1;  ///< a stretch of carriers; -1: none
  double place = 0;
};

}  // namespace

std::vector<ClusterPlace> facingOrder(const std::vector<const Space*>& spaces,
                                      const std::vector<Link>& links) {
  std::vector<std::vector<Standing>> standings;
  for (const Space* space : spaces)
    standings.emplace_back(space->mesh().size());
  const auto of = [&](const BodyElement& e) -> Standing& {
    return standings[e.body][e.element];
  };
  const auto loopOf = [&](const BodyElement& e) {
    const Mesh& mesh = spaces[e.body]->mesh();
    return mesh.outline().edge(mesh[e.element].piece.edge).loop;
  };
  constexpr int carries = 0;
  for (const Link& link : links)
    of(link.carrier).zone = carries;
  // zones, numbered anew
  std::vector<std::vector<BodyElement>> zones;
  for (std::size_t b = 0; b < spaces.size(); ++b)
    for (int e = 0; e < spaces[b]->mesh().size(); ++e) {
      const BodyElement now{static_cast<int>(b), e};
      const BodyElement before{now.body, e - 1};
      if (of(now).zone < 0)
        continue;
      if (e == 0 || of(before).zone < 0 || loopOf(before) != loopOf(now))
        zones.emplace_back();
      zones.back().push_back(now);
      of(now) = {static_cast<int>(zones.size()) - 1, static_cast<double>(e)};
    }
  // what is met goes to the zone that it has most to do with
  struct Share {
    double size = 0;
    double moment = 0;
  };
  std::map<std::pair<int, int>, std::map<int, Share>> met;
  for (const Link& link : links)
    if (of(link.met).zone < 0) {
      Share& share = met[{link.met.body, link.met.element}][of(link.carrier).zone];
      share.size += link.size;
      share.moment += link.size * of(link.carrier).place;
    }
  for (const auto& [key, shares] : met) {
    const auto most = std::max_element(
        shares.begin(), shares.end(),
        [](const auto& a, const auto& b) { return a.second.size < b.second.size; });
    if (!(most->second.size > 0))
      continue;
    const BodyElement e{key.first, key.second};
    of(e) = {most->first, most->second.moment / most->second.size};
    zones[most->first].push_back(e);
  }
  for (std::vector<BodyElement>& zone : zones)
    std::stable_sort(zone.begin(), zone.end(),
                     [&](const BodyElement& a, const BodyElement& b) {
                       return of(a).place < of(b).place;
                     });

  std::vector<ClusterPlace> order;
  std::vector<char> isPlaced(zones.size());
  int stretch = 0;
  for (std::size_t b = 0; b < spaces.size(); ++b)
    for (int e = 0; e < spaces[b]->mesh().size(); ++e) {
      const BodyElement now{static_cast<int>(b), e};
      const int zone = of(now).zone;
      if (zone < 0) {
        const bool goesOn = !order.empty() && order.back().body == now.body &&
                            order.back().element == e - 1 &&
                            of({now.body, e - 1}).zone < 0 &&
                            loopOf({now.body, e - 1}) == loopOf(now);
        order.push_back({now.body, e, goesOn ? stretch : ++stretch});
      } else if (isPlaced[zone] == 0) {
        isPlaced[zone] = 1;
        ++stretch;
        for (const BodyElement& other : zones[zone])
          order.push_back({other.body, other.element, stretch});
      }
    }
  return order;
}

}  // namespace epafi::bem
