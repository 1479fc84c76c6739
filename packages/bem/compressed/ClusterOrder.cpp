#include "bem/compressed/ClusterOrder.hpp"

#include "bem/compressed/Slices.hpp"

#include <algorithm>
#include <map>

namespace epafi::bem {

namespace {

/// Where an element stands.
struct Standing {
  int zone = -1;  ///< a stretch of carriers; -1: none
  double place = 0;
};

/// Stretches of carriers with what they meet.
class Zones {
 public:
  Zones(const std::vector<const Space*>& spaces, const std::vector<Link>& links)
      : spaces_(spaces), links_(links) {
    for (const Space* space : spaces)
      standings_.emplace_back(space->mesh().size());
    findCarriers();
    addOpposite();
    for (std::vector<BodyElement>& zone : zones_)
      std::stable_sort(zone.begin(), zone.end(),
                       [&](const BodyElement& a, const BodyElement& b) {
                         return of(a).place < of(b).place;
                       });
  }

  /// All elements body by body, a zone where its first one is.
  std::vector<ClusterPlace> order() {
    std::vector<ClusterPlace> order;
    std::vector<char> isPlaced(zones_.size());
    int stretch = 0;
    forAll([&](const BodyElement& now) {
      const int zone = of(now).zone;
      if (zone < 0) {
        const BodyElement before{now.body, now.element - 1};
        const bool goesOn = !order.empty() && order.back().body == now.body &&
                            order.back().element == before.element &&
                            of(before).zone < 0 && loopOf(before) == loopOf(now);
        order.push_back({now.body, now.element, goesOn ? stretch : ++stretch});
      } else if (isPlaced[zone] == 0) {
        isPlaced[zone] = 1;
        ++stretch;
        for (const BodyElement& other : zones_[zone])
          order.push_back({other.body, other.element, stretch});
      }
    });
    return order;
  }

  /// Places of elements in an order; opposite elements at the place of their carriers.
  std::vector<Vec2> placesOf(const std::vector<ClusterPlace>& order) {
    std::vector<Vec2> places;
    for (const ClusterPlace& place : order) {
      const Standing& standing = standings_[place.body][place.element];
      const BodyElement at =
          standing.zone < 0
              ? BodyElement{place.body, place.element}
              : BodyElement{bodies_[standing.zone], static_cast<int>(standing.place)};
      places.push_back(spaces_[at.body]->mesh().physicalPoint(at.element, 0));
    }
    return places;
  }

 private:
  Standing& of(const BodyElement& e) { return standings_[e.body][e.element]; }
  int loopOf(const BodyElement& e) const {
    const Mesh& mesh = spaces_[e.body]->mesh();
    return mesh.outline().edge(mesh[e.element].piece.edge).loop;
  }
  template <class Visit>
  void forAll(const Visit& visit) {
    for (std::size_t b = 0; b < spaces_.size(); ++b)
      for (int e = 0; e < spaces_[b]->mesh().size(); ++e)
        visit(BodyElement{static_cast<int>(b), e});
  }

  void findCarriers() {
    constexpr int carries = 0;
    for (const Link& link : links_)
      of(link.carrier).zone = carries;
    forAll([&](const BodyElement& now) {
      if (of(now).zone < 0)
        return;
      const BodyElement before{now.body, now.element - 1};
      if (now.element == 0 || of(before).zone < 0 || loopOf(before) != loopOf(now)) {
        zones_.emplace_back();
        bodies_.push_back(now.body);
      }
      zones_.back().push_back(now);
      of(now) = {static_cast<int>(zones_.size()) - 1, static_cast<double>(now.element)};
    });
  }

  /// Assigns each opposite element to the zone with the largest links to it.
  void addOpposite() {
    struct Share {
      double size = 0;
      double moment = 0;
    };
    std::map<std::pair<int, int>, std::map<int, Share>> opposite;
    for (const Link& link : links_)
      if (of(link.opposite).zone < 0) {
        Share& share =
            opposite[{link.opposite.body, link.opposite.element}][of(link.carrier).zone];
        share.size += link.size;
        share.moment += link.size * of(link.carrier).place;
      }
    for (const auto& [key, shares] : opposite) {
      const auto most = std::max_element(
          shares.begin(), shares.end(),
          [](const auto& a, const auto& b) { return a.second.size < b.second.size; });
      if (!(most->second.size > 0))
        continue;
      const BodyElement e{key.first, key.second};
      of(e) = {most->first, most->second.moment / most->second.size};
      zones_[most->first].push_back(e);
    }
  }

  const std::vector<const Space*>& spaces_;
  const std::vector<Link>& links_;
  std::vector<std::vector<Standing>> standings_;
  std::vector<std::vector<BodyElement>> zones_;
  std::vector<int> bodies_;  ///< of their carriers
};

}  // namespace

std::vector<ClusterPlace> clusterOrder(const std::vector<const Space*>& spaces,
                                       const std::vector<Link>& links) {
  Zones zones(spaces, links);
  const std::vector<ClusterPlace> order = zones.order();
  return inSlices(spaces, order, zones.placesOf(order));
}

}  // namespace epafi::bem
