#include "contact/system/LoadSize.hpp"

#include "bem/algebra/SmallAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace epafi::contact {

using bem::axpy;
using bem::largestEntry;

namespace {

/// The bed of springs, a convex and piecewise quadratic function of α.
class Bed {
 public:
  Bed(const Problem& problem, const Vector& given, const Vector& lengths, Vector pulls)
      : problem_(problem),
        given_(given),
        bounds_(problem.slipBounds({})),
        pulls_(std::move(pulls)),
        rows_(given.size()) {
    for (const double length : lengths)
      compliances_.push_back(length > 0 ? 1 / length : 0);
    for (Index j = 0; j < problem.rigidMotions(); ++j)
      for (Index i = 0; i < problem.size(); ++i)
        if (const double g = problem.rigid(i, j); g != 0)
          rows_[at(i)].push_back({j, g});
  }

  struct Point {
    Vector alpha;
    Vector pressures;
    std::vector<char> yields;  ///< do they change with r?
    double energy = 0;
  };
  Point pointAt(Vector alpha) const {
    Point point{std::move(alpha), Vector(rows_.size()), std::vector<char>(rows_.size())};
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      double r = given_[i];
      for (const auto& [j, g] : rows_[i])
        r += g * point.alpha[at(j)];
      const double z = r * compliances_[i];
      const double most = mostOf(i);
      const double least = i < at(problem_.normals) ? 0 : -most;
      const double pressure = std::clamp(z, least, most);
      point.pressures[i] = pressure;
      point.yields[i] = static_cast<char>(least < z && z < most);
      if (compliances_[i] > 0)
        point.energy += pressure * (z - pressure / 2) / compliances_[i];
    }
    for (std::size_t j = 0; j < point.alpha.size(); ++j)
      point.energy +=
          point.alpha[j] *
          (problem_.stiffness(bem::Index(j)) * point.alpha[j] / 2 - pulls_[j]);
    return point;
  }

  /// Newton's step, of least length in directions that nothing holds; empty at the minimum.
  Vector stepFrom(const Point& point) const {
    constexpr double little = 1e-13;
    constexpr double free = 1e-12;
    const std::size_t n = point.alpha.size();
    Vector step(n);
    Vector sizes(n);
    Matrix hessian(static_cast<Index>(n), static_cast<Index>(n));
    for (std::size_t i = 0; i < rows_.size(); ++i)
      for (const auto& [j, g] : rows_[i]) {
        step[at(j)] -= g * point.pressures[i];
        sizes[at(j)] += std::abs(g * point.pressures[i]);
        for (const auto& [k, h] : rows_[i])
          hessian(j, k) += point.yields[i] != 0 ? g * h * compliances_[i] : 0;
      }
    double largest = 0;
    bool rests = true;
    for (std::size_t j = 0; j < n; ++j) {
      const auto k = static_cast<Index>(j);
      const double spring = problem_.stiffness(k) * point.alpha[j];
      step[j] += pulls_[j] - spring;
      sizes[j] += std::abs(pulls_[j]) + std::abs(spring);
      rests = rests && std::abs(step[j]) <= little * sizes[j];
      hessian(k, k) += problem_.stiffness(k);
      largest = std::max(largest, hessian(k, k));
    }
    if (rests)
      return {};
    for (Index k = 0; k < hessian.rows(); ++k)
      hessian(k, k) += free * largest;
    if (bem::cholesky(hessian) != 0)
      return {};
    bem::choleskySolve(hessian, step.data());
    return step;
  }

 private:
  double mostOf(std::size_t i) const {
    return i < at(problem_.normals) ? std::numeric_limits<double>::infinity()
                                    : bounds_[i - at(problem_.normals)];
  }

  const Problem& problem_;
  const Vector& given_;
  Vector compliances_;  ///< 1 / w
  Vector bounds_;
  Vector pulls_;
  std::vector<std::vector<std::pair<Index, double>>> rows_;  ///< of G
};

Bed::Point settled(const Bed& bed, std::size_t motions) {
  constexpr int most = 100;
  constexpr int halvings = 30;
  Bed::Point point = bed.pointAt(Vector(motions));
  for (int k = 0; k < most; ++k) {
    const Vector step = bed.stepFrom(point);
    if (step.empty())
      break;
    Bed::Point next = point;
    double share = 1;
    for (int h = 0; h < halvings; ++h, share /= 2) {
      Vector alpha = point.alpha;
      axpy(share, step, alpha);
      next = bed.pointAt(std::move(alpha));
      if (next.energy < point.energy)
        break;
    }
    if (!(next.energy < point.energy))
      break;
    point = std::move(next);
  }
  return point;
}

}  // namespace

Vector lengthsOf(const std::vector<ContactSide>& sides, const Numbering& numbering) {
  Vector all(at(numbering.size()));
  for (std::size_t b = 0; b < sides.size(); ++b)
    for (const auto& element : sides[b].multiplier.elements()) {
      const double share =
          2 * sides[b].space.mesh()[element.element].half / (element.degree + 1);
      for (int i = 0; i <= element.degree; ++i) {
        all[at(numbering(b, element.normalOf(i)))] += share;
        if (element.shears())
          all[at(numbering(b, element.tangentialOf(i)))] += share;
      }
    }
  return all;
}

double loadSize(const Problem& problem, const Vector& given, const Vector& lengths,
                double moved, double own, const RigidDrives& drives) {
  constexpr double rounding = 1e-13;
  const auto motions = at(problem.rigidMotions());
  const auto ofRigid = at(drives.freeMotions());
  Vector pulls(motions - ofRigid);
  const Vector bySprings = drives.pulls();
  pulls.insert(pulls.end(), bySprings.begin(), bySprings.end());
  const Bed::Point point =
      settled(Bed(problem, given, lengths, std::move(pulls)), motions);
  for (const double alpha : point.alpha)
    moved = std::max(moved, std::abs(alpha));
  const double pressed = largestEntry(point.pressures);
  return own + drives.loadSize(point.alpha.data() + (motions - ofRigid)) +
         (pressed > rounding * moved ? pressed : 0);
}

}  // namespace epafi::contact
