#include "contact/system/Anderson.hpp"

#include "bem/algebra/SmallAlgebra.hpp"

#include <cmath>
#include <utility>

namespace epafi::contact {

using bem::axpy;
using bem::dot;

bem::Vector Anderson::stepBy(bem::Vector change) {
  constexpr double dependent = 1e-6;
  if (!change_.empty()) {
    Difference last{change, std::move(step_)};
    axpy(-1, change_, last.change);
    differences_.push_back(std::move(last));
    if (differences_.size() > kept_)
      differences_.erase(differences_.begin());
  }
  bem::Vector step = change;
  std::vector<Difference> basis;  // of the differences, orthonormal in f
  for (auto own = differences_.rbegin(); own != differences_.rend(); ++own) {
    Difference next = *own;
    for (const Difference& other : basis) {
      const double share = dot(other.change, next.change);
      axpy(-share, other.change, next.change);
      axpy(-share, other.step, next.step);
    }
    const double length = std::sqrt(dot(next.change, next.change));
    if (!(length > dependent * std::sqrt(dot(own->change, own->change))))
      continue;
    next = {bem::times(1 / length, std::move(next.change)),
            bem::times(1 / length, std::move(next.step))};
    const double share = dot(next.change, change);
    axpy(-share, next.change, step);
    axpy(-share, next.step, step);
    basis.push_back(std::move(next));
  }
  change_ = std::move(change);
  step_ = step;
  return step;
}

}  // namespace epafi::contact
