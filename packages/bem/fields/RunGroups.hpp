#pragma once

#include "bem/base/Box.hpp"
#include "bem/moments/ElementRuns.hpp"

#include <algorithm>
#include <vector>

namespace epafi::bem {

/// Consecutive runs and a circle around them.
struct RunGroup {
  int first = 0;  ///< runs first ... last - 1
  int last = 0;
  int children[2] = {-1, -1};
  Complex centre;
  double radius = 0;
};

/// Binary division of the runs of a mesh into groups, down to so many runs that what stands for a group
/// far away costs as much as they do.  Group: a RunGroup.
template <class Group>
class RunGroups {
 public:
  /// What stands for the whole mesh at points of a circle: far(group) for groups that it is
  /// far from, near(r) for the runs of the others.
  template <class Far, class Near>
  void visit(Complex centre, double radius, const Far& far, const Near& near) const {
    if (groups_.empty())
      for (int r = 0; r < runs_.size(); ++r)
        near(r);
    else
      visit(0, centre, radius, far, near);
  }

 protected:
  /// From the middle of a group [its radius] to what is far from it.
  static constexpr double separation = 2.5;

  /// Refers to the runs.  \param smallest  runs that a group has at least; there are no groups of a
  /// mesh with less than four times as many
  RunGroups(const ElementRuns& runs, int smallest) : runs_(runs) {
    if (runs.size() >= 4 * smallest)
      divide(0, runs.size(), smallest);
  }

  const ElementRuns& runs_;
  std::vector<Group>
      groups_;  ///< the first one is the whole mesh, which nothing is far from

 private:
  template <class Far, class Near>
  void visit(std::size_t number, Complex centre, double radius, const Far& far,
             const Near& near) const {
    const Group& group = groups_[number];
    if (number > 0 &&
        std::abs(centre - group.centre) - radius >= separation * group.radius)
      far(group);
    else if (group.children[0] >= 0)
      for (const int child : group.children)
        visit(at(child), centre, radius, far, near);
    else
      for (int r = group.first; r < group.last; ++r)
        near(r);
  }

  int divide(int first, int last, int smallest) {
    const auto number = static_cast<int>(groups_.size());
    Group group;
    group.first = first;
    group.last = last;
    encircle(group);
    groups_.push_back(std::move(group));
    if (last - first < 2 * smallest)
      return number;
    const int left = divide(first, (first + last) / 2, smallest);
    const int right = divide((first + last) / 2, last, smallest);
    groups_[at(number)].children[0] = left;
    groups_[at(number)].children[1] = right;
    return number;
  }

  /// Elements on an axis of revolution do nothing, wherever they are.
  void encircle(Group& group) const {
    const Mesh& mesh = runs_.mesh();
    const auto forEach = [&](const auto& action) {
      for (int e = runs_[group.first].first; e < runs_[group.last - 1].last; ++e)
        if (!mesh.isAxis(e))
          action(mesh[e].curve.frame().middle, mesh[e].half);
    };
    Box box;
    forEach([&](Vec2 middle, double /*half*/) { box.add(middle); });
    group.centre = asComplex(box.middle());
    forEach([&](Vec2 middle, double half) {
      group.radius =
          std::max(group.radius, std::abs(asComplex(middle) - group.centre) + half);
    });
  }
};

}  // namespace epafi::bem
