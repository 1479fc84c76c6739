#pragma once

#include "bem/base/Vec2.hpp"

#include <cstddef>
#include <vector>

namespace epafi::bem {

/// Points in heaps of neighbours: each half of the points across the longer side of their box, in
/// whole packs of eight, until a heap is small.
class PointHeaps {
 public:
  /// Refers to the points.  \param largest number of points of a heap, a multiple of `lanes`
  PointHeaps(const std::vector<Vec2>& points, std::size_t largest);

  std::size_t size() const { return ends_.size() - 1; }
  /// Number of points of a heap, and of its packs.
  std::size_t pointsOf(std::size_t heap) const { return ends_[heap + 1] - ends_[heap]; }
  std::size_t packsOf(std::size_t heap) const;
  /// The number among all points of one of a heap; behind the last that one again.
  std::size_t number(std::size_t heap, std::size_t k) const;
  /// A circle around a heap.
  Complex centre(std::size_t heap) const;
  double radius(std::size_t heap) const;

 private:
  void divide(std::size_t first, std::size_t last, std::size_t largest);

  const std::vector<Vec2>& points_;
  std::vector<std::size_t> order_;
  std::vector<std::size_t> ends_ = {0};
};

}  // namespace epafi::bem
