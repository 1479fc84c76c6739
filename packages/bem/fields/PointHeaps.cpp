#include "bem/fields/PointHeaps.hpp"

#include "bem/base/Box.hpp"
#include "bem/base/Matrix.hpp"
#include "bem/simd/Pack.hpp"

#include <algorithm>
#include <numeric>

namespace epafi::bem {

PointHeaps::PointHeaps(const std::vector<Vec2>& points, std::size_t largest)
    : points_(points), order_(points.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  if (!points.empty())
    divide(0, points.size(), largest);
}

std::size_t PointHeaps::packsOf(std::size_t heap) const {
  return (pointsOf(heap) + lanes - 1) / lanes;
}

std::size_t PointHeaps::number(std::size_t heap, std::size_t k) const {
  return order_[std::min(ends_[heap] + k, ends_[heap + 1] - 1)];
}

namespace {

Box boxOf(const std::vector<Vec2>& points, const PointHeaps& heaps, std::size_t heap) {
  Box box;
  for (std::size_t k = 0; k < heaps.pointsOf(heap); ++k)
    box.add(points[heaps.number(heap, k)]);
  return box;
}

}  // namespace

Complex PointHeaps::centre(std::size_t heap) const {
  return asComplex(boxOf(points_, *this, heap).middle());
}

double PointHeaps::radius(std::size_t heap) const {
  return 0.5 * norm(boxOf(points_, *this, heap).size());
}

void PointHeaps::divide(std::size_t first, std::size_t last, std::size_t largest) {
  if (last - first <= largest) {
    ends_.push_back(last);
    return;
  }
  Box box;
  for (std::size_t k = first; k < last; ++k)
    box.add(points_[order_[k]]);
  const bool isWide = box.size().x > box.size().y;
  const auto from = order_.begin() + static_cast<Index>(first);
  const std::size_t half = ((last - first) / 2 + lanes - 1) / lanes * lanes;
  std::nth_element(
      from, from + static_cast<Index>(half), order_.begin() + static_cast<Index>(last),
      [&](std::size_t a, std::size_t b) {
        return isWide ? points_[a].x < points_[b].x : points_[a].y < points_[b].y;
      });
  divide(first, first + half, largest);
  divide(first + half, last, largest);
}

}  // namespace epafi::bem
