#include "adaptivity/estimate/EquivalentMultiplier.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::adaptivity {

using bem::Vec2;

namespace {

constexpr int none = -1;

/// A node that has a w.
struct Joint {
  int before = none;  ///< contact element that ends there
  int after = none;   ///< contact element that starts there
  Vec2 free;          ///< 1 for each component that has one, else 0
  double reach = 0;   ///< of steps that are tried both ways
};

/// Which components of the displacement conditions prescribe on an element: 1 or 0 each.
Vec2 clamped(const bem::Mesh& mesh, int e, const contact::Conditions& conditions) {
  const auto clamp = conditions.dirichlet.find(mesh.boundary(e));
  if (clamp == conditions.dirichlet.end())
    return {};
  return {clamp->second.x ? 1.0 : 0.0, clamp->second.y ? 1.0 : 0.0};
}

std::vector<Joint> findJoints(const bem::Mesh& mesh,
                              const contact::Conditions& conditions,
                              const std::vector<ContactElement>& elements) {
  std::vector<int> contactOf(static_cast<std::size_t>(mesh.size()), none);
  for (std::size_t k = 0; k < elements.size(); ++k)
    contactOf[static_cast<std::size_t>(elements[k].element)] = static_cast<int>(k);
  std::vector<Joint> joints;
  for (int e = 0; e < mesh.size(); ++e) {
    const int previous = mesh[e].previous;
    const int after = contactOf[static_cast<std::size_t>(e)];
    const int before = contactOf[static_cast<std::size_t>(previous)];
    Vec2 free{1, 1};
    if (after == none)
      free = clamped(mesh, e, conditions);
    else if (before == none)
      free = clamped(mesh, previous, conditions);
    if ((before != none || after != none) && free != Vec2{})
      joints.push_back({before, after, free});
  }
  return joints;
}

void move(const Joint& joint, Vec2 change, std::vector<AtEnds>& factors) {
  if (joint.before != none) {
    Vec2& end = factors[static_cast<std::size_t>(joint.before)].end;
    end = end + change;
  }
  if (joint.after != none) {
    Vec2& start = factors[static_cast<std::size_t>(joint.after)].start;
    start = start - change;
  }
}

/// Corrections of all contact elements, and what each costs.
struct Corrections {
  std::vector<AtEnds> factors;
  std::vector<double> costs;
  double total = 0;

  Corrections(const std::vector<ContactCost>& elements, std::vector<AtEnds> all)
      : factors(std::move(all)) {
    for (std::size_t k = 0; k < elements.size(); ++k) {
      costs.push_back(elements[k](factors[k]));
      total += costs.back();
    }
  }
};

/// Changes of one joint, all others as they are.
class Neighbourhood {
 public:
  Neighbourhood(const Joint& joint, const std::vector<ContactCost>& costs,
                const Corrections& now)
      : joint_(joint), costs_(costs), factors_(now.factors) {
    if (joint.before != none) {
      unchanged_ += now.costs[static_cast<std::size_t>(joint.before)];
      const ContactCost& cost = costAt(joint.before);
      slope_ = slope_ + cost.slope(factorsAt(joint.before)).end;
      curvature_ += cost.curvature();
      scale_ += cost.scale();
      add(cost.directions());
    }
    if (joint.after != none) {
      unchanged_ += now.costs[static_cast<std::size_t>(joint.after)];
      const ContactCost& cost = costAt(joint.after);
      slope_ = slope_ - cost.slope(factorsAt(joint.after)).start;
      curvature_ += cost.curvature();
      scale_ += cost.scale();
      add(cost.directions());
    }
  }

  double cost(Vec2 change) const {
    double sum = 0;
    if (joint_.before != none) {
      AtEnds c = factorsAt(joint_.before);
      c.end = c.end + change;
      sum += costAt(joint_.before)(c);
    }
    if (joint_.after != none) {
      AtEnds c = factorsAt(joint_.after);
      c.start = c.start - change;
      sum += costAt(joint_.after)(c);
    }
    return sum;
  }

  double unchanged() const { return unchanged_; }  ///< cost({})
  const std::vector<Vec2>& directions() const { return directions_; }
  /// The size of the costs that changes can do something about.
  double scale() const { return scale_; }

  /// How far along a direction h/p |λ̃ + S u|² is least.
  double distance(Vec2 direction) const {
    return -dot(slope_, direction) / (curvature_ * dot(direction, direction));
  }

 private:
  const ContactCost& costAt(int k) const { return costs_[static_cast<std::size_t>(k)]; }
  const AtEnds& factorsAt(int k) const { return factors_[static_cast<std::size_t>(k)]; }

  void add(const std::vector<Vec2>& directions) {
    for (const Vec2 d : directions) {
      const Vec2 possible{joint_.free.x * d.x, joint_.free.y * d.y};
      const bool isKnown = std::find(directions_.begin(), directions_.end(), possible) !=
                           directions_.end();
      if (possible != Vec2{} && !isKnown)
        directions_.push_back(possible);
    }
  }

  const Joint& joint_;
  const std::vector<ContactCost>& costs_;
  const std::vector<AtEnds>& factors_;
  std::vector<Vec2> directions_;
  Vec2 slope_;
  double curvature_ = 0;
  double scale_ = 0;
  double unchanged_ = 0;
};

/// The best of some changes; the mean of those that are equally good, since a mirrored
/// scene has them in another order.  What gains less than a part of the scale that
/// rounding cannot reach does not count: choices must not hang on it.
class Best {
 public:
  Best(double cost, double scale)
      : start_(cost - 1e-4 * scale), least_(cost), tie_(1e-6 * scale) {}

  void consider(double cost, Vec2 change) {
    if (!(cost < start_) || cost > least_ + tie_)
      return;
    if (cost < least_ - tie_) {
      least_ = cost;
      sum_ = {};
      count_ = 0;
    }
    sum_ = sum_ + change;
    ++count_;
  }

  bool found() const { return count_ > 0; }
  Vec2 change() const { return found() ? (1.0 / count_) * sum_ : Vec2{}; }

 private:
  double start_;
  double least_;
  double tie_;
  Vec2 sum_;
  int count_ = 0;
};

struct Step {
  Vec2 change;
  double reach = 0;  ///< for the next one
};

Step bestStep(double reach, const Neighbourhood& around) {
  Best best(around.unchanged(), around.scale());
  double largest = 0;
  for (const Vec2 d : around.directions()) {
    const double whole = around.distance(d);
    largest = std::max(largest, std::abs(whole));
    for (const double step : {whole, 0.5 * whole, reach, -reach})
      if (step != 0)
        best.consider(around.cost(step * d), step * d);
  }
  if (reach == 0)
    return {best.change(), 0.5 * largest};
  return {best.change(), best.found() ? reach : 0.5 * reach};
}

}  // namespace

std::vector<AtEnds> equivalentMultiplier(const bem::Mesh& mesh,
                                         const contact::Conditions& conditions,
                                         const std::vector<ContactElement>& elements,
                                         const std::vector<ContactCost>& costs) {
  constexpr int sweeps = 40;
  constexpr double enough = 1e-3;  // of what has been gained; any result is as valid
  std::vector<Joint> joints = findJoints(mesh, conditions, elements);
  Corrections best(costs, std::vector<AtEnds>(elements.size()));
  const double start = best.total;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    // All joints at once, so that their order does not show, and half the way: each cost
    // depends on two joints and is convex where pressure and shear keep their signs.
    std::vector<AtEnds> factors = best.factors;
    for (Joint& joint : joints) {
      const Step step = bestStep(joint.reach, {joint, costs, best});
      joint.reach = step.reach;
      move(joint, 0.5 * step.change, factors);
    }
    Corrections next(costs, std::move(factors));
    if (!(next.total < best.total))
      break;
    const double gain = best.total - next.total;
    best = std::move(next);
    if (gain < enough * (start - best.total))
      break;
  }
  return best.factors;
}

std::vector<AtEnds> agree(const std::vector<AtEnds>& factors,
                          const bem::DenseAlgebra& algebra) {
  bem::Vector numbers;
  for (const AtEnds& c : factors)
    numbers.insert(numbers.end(), {c.start.x, c.start.y, c.end.x, c.end.y});
  numbers = algebra.broadcast(std::move(numbers));
  std::vector<AtEnds> agreed;
  for (std::size_t k = 0; k < numbers.size(); k += 4)
    agreed.push_back({{numbers[k], numbers[k + 1]}, {numbers[k + 2], numbers[k + 3]}});
  return agreed;
}

}  // namespace epafi::adaptivity
