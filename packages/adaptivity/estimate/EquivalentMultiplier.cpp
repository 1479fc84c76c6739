#include "adaptivity/estimate/EquivalentMultiplier.hpp"

#include "bem/base/Parallel.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace epafi::adaptivity {

using bem::Vec2;

namespace {

/// A contact element at a node: its end there, and the sign of w on it.
struct Arm {
  std::size_t contact = 0;
  Vec2 AtEnds::*end = nullptr;
  double sign = 1;  ///< 1 before the node, -1 after it

  void move(Vec2 change, AtEnds& factors) const {
    factors.*end = factors.*end + sign * change;
  }
};

/// A node that has a w.
struct Joint {
  std::vector<Arm> arms;
  Vec2 free;         ///< 1 for each component with a w, else 0
  double reach = 0;  ///< size of steps that are tried in both directions
};

std::vector<Joint> findJoints(const bem::Mesh& mesh,
                              const contact::Conditions& conditions,
                              const std::vector<ContactElement>& elements) {
  constexpr auto none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> contactOf(static_cast<std::size_t>(mesh.size()), none);
  for (std::size_t k = 0; k < elements.size(); ++k)
    contactOf[static_cast<std::size_t>(elements[k].element)] = k;
  std::vector<Joint> joints;
  for (int e = 0; e < mesh.size(); ++e) {
    const int previous = mesh[e].previous;
    const std::size_t before = contactOf[static_cast<std::size_t>(previous)];
    const std::size_t after = contactOf[static_cast<std::size_t>(e)];
    Joint joint;
    if (before != none)
      joint.arms.push_back({before, &AtEnds::end, 1});
    if (after != none)
      joint.arms.push_back({after, &AtEnds::start, -1});
    joint.free = joint.arms.size() == 2
                     ? Vec2{1, 1}
                     : conditions.given(mesh.boundary(after == none ? e : previous));
    if (!joint.arms.empty() && joint.free != Vec2{})
      joints.push_back(std::move(joint));
  }
  return joints;
}

constexpr double ofCost = 100;  // ns, of an element

/// Corrections of all contact elements, and their costs.
struct Corrections {
  std::vector<AtEnds> factors;
  std::vector<double> costs;
  double total = 0;

  Corrections(const std::vector<ContactCost>& elements, std::vector<AtEnds> all)
      : factors(std::move(all)) {
    const auto size = static_cast<bem::Index>(elements.size());
    costs.resize(elements.size());
    bem::parallelFor({size, ofCost * static_cast<double>(size), 16}, [&](bem::Index k) {
      costs[bem::at(k)] = elements[bem::at(k)](factors[bem::at(k)]);
    });
    total = std::accumulate(costs.begin(), costs.end(), 0.0);
  }
};

/// The cost as a function of the change of one joint.
class Neighbourhood {
 public:
  Neighbourhood(const Joint& joint, const std::vector<ContactCost>& costs,
                const Corrections& now)
      : joint_(joint), costs_(costs), factors_(now.factors) {
    for (const Arm& arm : joint.arms) {
      const ContactCost& cost = costs[arm.contact];
      unchanged_ += now.costs[arm.contact];
      slope_ = slope_ + arm.sign * (cost.slope(factors_[arm.contact]).*arm.end);
      curvature_ += cost.curvature();
      scale_ += cost.scale();
      for (const Vec2 d : cost.directions())
        if (const Vec2 possible{joint.free.x * d.x, joint.free.y * d.y};
            possible != Vec2{} && std::find(directions_.begin(), directions_.end(),
                                            possible) == directions_.end())
          directions_.push_back(possible);
    }
  }

  double cost(Vec2 change) const {
    double sum = 0;
    for (const Arm& arm : joint_.arms) {
      AtEnds factors = factors_[arm.contact];
      arm.move(change, factors);
      sum += costs_[arm.contact](factors);
    }
    return sum;
  }

  double unchanged() const { return unchanged_; }  ///< cost({})
  const std::vector<Vec2>& directions() const { return directions_; }
  /// Size of the part of the cost that changes can reduce.
  double scale() const { return scale_; }

  /// Distance along a direction to the minimum of h/p |λ̃ + S u|².
  double distance(Vec2 direction) const {
    return -dot(slope_, direction) / (curvature_ * dot(direction, direction));
  }

 private:
  const Joint& joint_;
  const std::vector<ContactCost>& costs_;
  const std::vector<AtEnds>& factors_;
  std::vector<Vec2> directions_;
  Vec2 slope_;
  double curvature_ = 0;
  double scale_ = 0;
  double unchanged_ = 0;
};

/// The best of several changes; the mean of equally good ones, so that results do not
/// depend on their order (mirror images).  Gains below 1e-4 of the scale do not count, so
/// that rounding errors decide nothing.
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
  constexpr double enough = 1e-3;  // of the total gain; the bound holds for all c
  std::vector<Joint> joints = findJoints(mesh, conditions, elements);
  const auto size = static_cast<bem::Index>(joints.size());
  std::vector<Step> steps(joints.size());
  constexpr double ofStep = 20 * ofCost;
  Corrections best(costs, std::vector<AtEnds>(elements.size()));
  const double start = best.total;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    // All joints at once, so that their order does not matter, with half steps: each cost
    // depends on two joints and is convex where pressure and shear keep their signs.
    std::vector<AtEnds> factors = best.factors;
    bem::parallelFor({size, ofStep * static_cast<double>(size), 16}, [&](bem::Index j) {
      const Joint& joint = joints[bem::at(j)];
      steps[bem::at(j)] = bestStep(joint.reach, {joint, costs, best});
    });
    for (std::size_t j = 0; j < joints.size(); ++j) {
      joints[j].reach = steps[j].reach;
      for (const Arm& arm : joints[j].arms)
        arm.move(0.5 * steps[j].change, factors[arm.contact]);
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
                          const bem::Processes& processes) {
  bem::Vector numbers;
  for (const AtEnds& c : factors)
    numbers.insert(numbers.end(), {c.start.x, c.start.y, c.end.x, c.end.y});
  numbers = processes.broadcast(std::move(numbers));
  std::vector<AtEnds> agreed;
  for (std::size_t k = 0; k < numbers.size(); k += 4)
    agreed.push_back({{numbers[k], numbers[k + 1]}, {numbers[k + 2], numbers[k + 3]}});
  return agreed;
}

std::vector<AtEnds> corrections(const contact::Solved& solved, const bem::Lame& lame,
                                const Contributions& factors,
                                const std::vector<AtEnds>& moments, SidePlaces& places,
                                const bem::Processes& processes) {
  const auto& elements = solved.problem.elements();
  Vector numbers;
  for (const AtEnds& m : moments)
    numbers.insert(numbers.end(), {m.start.x, m.start.y, m.end.x, m.end.y});
  numbers = processes.sum(std::move(numbers));
  std::vector<ContactCost> costs;
  const double* next = numbers.data();
  for (const ContactElement& element : elements) {
    costs.emplace_back(solved, element, AtEnds{{next[0], next[1]}, {next[2], next[3]}},
                       factors, lame.mu, places.known(costs.size()));
    next += 4;
  }
  return agree(
      equivalentMultiplier(solved.space.mesh(), solved.conditions, elements, costs),
      processes);
}

}  // namespace epafi::adaptivity
