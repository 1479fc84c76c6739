#include "bem/compressed/Slices.hpp"

#include "bem/base/Box.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace epafi::bem {

namespace {

// Of a slice.  A beam of 1 : 16 under contact all along takes a sixth longer in slices, one of
// 1 : 32 as long, one of 1 : 300 a twentieth.
constexpr double stocky = 100;

/// An element of the order.
struct Standing {
  Vec2 place;
  std::size_t number;  ///< in the order
  double unknowns;
};
using Standings = std::vector<Standing>;

Standings::iterator halved(Standings::iterator first, Standings::iterator last) {
  Box box;
  double sum = 0;
  for (auto it = first; it != last; ++it) {
    box.add(it->place);
    sum += it->unknowns;
  }
  const bool isWide = box.size().x > box.size().y;
  std::stable_sort(first, last, [&](const Standing& a, const Standing& b) {
    return isWide ? a.place.x < b.place.x : a.place.y < b.place.y;
  });
  double before = 0;
  return std::find_if(first, last, [&](const Standing& standing) {
    before += standing.unknowns;
    return 2 * before > sum;
  });
}

/// visit(first, last) of each slice.
template <class Visit>
void slice(Standings::iterator first, Standings::iterator last, double slenderness,
           const Visit& visit) {
  if (last - first < 2 || slenderness <= stocky) {
    visit(first, last);
    return;
  }
  const auto middle = halved(first, last);
  slice(first, middle, slenderness / 2, visit);
  slice(middle, last, slenderness / 2, visit);
}

}  // namespace

double slenderness(const Mesh& mesh) {
  double perimeter = 0;
  double area = 0;
  for (int e = 0; e < mesh.size(); ++e) {
    perimeter += 2 * mesh[e].half;
    for (const double t : {-1.0, 0.0}) {
      const Vec2 from = mesh.scaledPoint(e, t);
      const Vec2 to = mesh.scaledPoint(e, t + 1);
      area += 0.5 * (from.x * to.y - from.y * to.x);
    }
  }
  // a coarse polygon of a thin ring may have none
  return area > 0 ? perimeter * perimeter / area : stocky;
}

std::vector<ClusterPlace> inSlices(const std::vector<const Space*>& spaces,
                                   const std::vector<ClusterPlace>& order,
                                   const std::vector<Vec2>& places) {
  double most = 0;
  for (const Space* space : spaces)
    most = std::max(most, slenderness(space->mesh()));
  if (most <= stocky)
    return order;
  Standings standings;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Element& element = spaces[order[k].body]->mesh()[order[k].element];
    standings.push_back({places[k], k, 2.0 * (element.degree + element.densities)});
  }
  std::vector<ClusterPlace> result;
  int stretches = 0;
  const auto append = [&](Standings::iterator first, Standings::iterator last) {
    std::sort(first, last,
              [](const Standing& a, const Standing& b) { return a.number < b.number; });
    int before = -1;
    std::for_each(first, last, [&](const Standing& standing) {
      ClusterPlace place = order[standing.number];
      if (std::exchange(before, place.stretch) != place.stretch)
        ++stretches;
      place.stretch = stretches;
      result.push_back(place);
    });
  };
  slice(standings.begin(), standings.end(), most, append);
  return result;
}

}  // namespace epafi::bem
