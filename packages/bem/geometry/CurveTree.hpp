#pragma once

#include "bem/geometry/Curve.hpp"

#include <limits>
#include <vector>

namespace epafi::bem {

/// A disc of the plane.
struct Disc {
  Vec2 middle;
  double radius = 0;

  /// May points of both be closer than this, up to rounding?
  bool isNear(const Disc& other, double distance = 0) const {
    constexpr double rounding = 1 + 1e-9;
    return norm(middle - other.middle) <= rounding * (radius + other.radius) + distance;
  }
};

/// Contains the curve.
inline Disc discOf(const Curve& curve) { return {curve.frame().middle, curve.half()}; }

/// Curves in a binary tree of discs that contain them.  Curves that follow each other share discs,
/// so that a search along a boundary of n of them looks at some log n discs.
class CurveTree {
 public:
  CurveTree() = default;
  explicit CurveTree(std::vector<Curve> curves);

  const std::vector<Curve>& curves() const { return curves_; }

  /// A place t in [-1, 1] on a curve, at a distance from x.
  struct Foot {
    std::size_t curve = 0;
    double t = 0;
    double distance = std::numeric_limits<double>::infinity();
  };
  /// The nearest to x.  \pre there are curves
  Foot nearest(Vec2 x) const;

  /// Calls visit(k), ascending, for all curves with mayMatter(disc) of their discs; it must be true of
  /// a disc if it is of one inside of it.
  template <class MayMatter, class Visit>
  void search(const MayMatter& mayMatter, const Visit& visit) const {
    if (!curves_.empty())
      search(0, {0, curves_.size()}, mayMatter, visit);
  }

  /// Calls visit(k) for all curves that may be closer to x than reach(), which a visit may shorten:
  /// nearer halves first, after which others are mostly too far off.
  template <class Reach, class Visit>
  void approach(Vec2 x, const Reach& reach, const Visit& visit) const {
    if (!curves_.empty())
      approach(x, 0, {0, curves_.size()}, reach, visit);
  }

 private:
  /// Numbers of curves below a node; children of node i: 2i + 1 with its first half, 2i + 2.
  struct Range {
    std::size_t begin;
    std::size_t end;
    std::size_t middle() const { return begin + (end - begin) / 2; }
    bool isOne() const { return end - begin == 1; }
  };
  void enclose(std::size_t node, Range range);

  template <class MayMatter, class Visit>
  void search(std::size_t node, Range range, const MayMatter& mayMatter,
              const Visit& visit) const {
    if (!mayMatter(discs_[node]))
      return;
    if (range.isOne()) {
      visit(range.begin);
      return;
    }
    search(2 * node + 1, {range.begin, range.middle()}, mayMatter, visit);
    search(2 * node + 2, {range.middle(), range.end}, mayMatter, visit);
  }

  template <class Reach, class Visit>
  void approach(Vec2 x, std::size_t node, Range range, const Reach& reach,
                const Visit& visit) const {
    if (!discs_[node].isNear({x, 0}, reach()))
      return;
    if (range.isOne()) {
      visit(range.begin);
      return;
    }
    const auto gap = [&](std::size_t child) {
      return norm(x - discs_[child].middle) - discs_[child].radius;
    };
    const std::size_t child = 2 * node + 1;
    const Range halves[2] = {{range.begin, range.middle()}, {range.middle(), range.end}};
    const std::size_t first = gap(child) <= gap(child + 1) ? 0 : 1;
    for (const std::size_t k : {first, 1 - first})
      approach(x, child + k, halves[k], reach, visit);
  }

  std::vector<Curve> curves_;
  std::vector<Disc> discs_;
};

}  // namespace epafi::bem
