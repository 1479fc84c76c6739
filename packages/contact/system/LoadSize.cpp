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

/// The bed of springs and surfaces, a convex function of α.
class Bed {
 public:
  Bed(const Problem& problem, const Vector& given, const Vector& lengths, Vector pulls,
      Vector bounds, double touching = 0)
      : problem_(problem),
        given_(given),
        bounds_(std::move(bounds)),
        touching_(touching),
        pulls_(std::move(pulls)),
        lengths_(lengths),
        compliances_(given.size(), 1.0),
        laws_(given.size()),
        rows_(given.size()) {
    const Surface& surface = problem.surface;
    Vector closing(given.size());  // L 1
    addTimes(1,
             {surface.linear.begin(),
              surface.linear.end() - static_cast<std::ptrdiff_t>(surface.wearing)},
             Vector(given.size(), 1.0), closing);
    for (std::size_t i = 0; i < given.size(); ++i)
      if (lengths[i] > 0)
        compliances_[i] += std::max(closing[i], 0.0) / lengths[i];
    for (const Surface::Place& place : surface.places)
      laws_[at(place.coefficient)] = &place;
    for (Index j = 0; j < problem.rigidMotions(); ++j)
      for (Index i = 0; i < problem.size(); ++i)
        if (const double g = problem.rigid(i, j); g != 0)
          rows_[at(i)].push_back({j, g});
  }

  struct Point {
    Vector alpha;
    Vector pressures;
    Vector slopes;       ///< of pressures by r
    double closing = 0;  ///< the largest of springs and surfaces
    double energy = 0;
  };
  Point pointAt(Vector alpha) const {
    Point point{std::move(alpha), Vector(rows_.size()), Vector(rows_.size())};
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      double r = given_[i];
      for (const auto& [j, g] : rows_[i])
        r += g * point.alpha[at(j)];
      if (!(lengths_[i] > 0))
        continue;
      const Spring spring = springAt(i, r / lengths_[i]);
      point.pressures[i] = spring.pressure;
      point.slopes[i] = spring.slope / lengths_[i];
      point.closing = std::max(point.closing, spring.closing);
      point.energy += lengths_[i] * spring.energy;
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
          hessian(j, k) += g * h * point.slopes[i];
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
    bem::choleskySolve(hessian, bem::MatrixView(step));
    return step;
  }

 private:
  struct Spring {
    double pressure = 0;
    double slope = 0;
    double closing = 0;
    double energy = 0;
  };
  /// With the surface on it, compressed by z.
  Spring springAt(std::size_t i, double z) const {
    if (laws_[i] != nullptr) {
      const double share = laws_[i]->length / lengths_[i];
      const PointClosing& law = laws_[i]->law;
      const double p = law.resolvent(share, z);
      if (!(p > 0))
        return {};
      return {p, 1 / (1 + share * law.slope(p)), z, p * p / 2 + share * law.energy(p)};
    }
    const double most = mostOf(i);
    const double least = i < at(problem_.normals) ? 0 : -most;
    const double free = z / compliances_[i];
    const double p = std::clamp(free, least, most);
    return {p, least - touching_ < free && free < most ? 1 / compliances_[i] : 0,
            std::abs(p) * compliances_[i], p * (z - compliances_[i] * p / 2)};
  }
  double mostOf(std::size_t i) const {
    return i < at(problem_.normals) ? std::numeric_limits<double>::infinity()
                                    : bounds_[i - at(problem_.normals)];
  }

  const Problem& problem_;
  const Vector& given_;
  Vector bounds_;
  double touching_;  ///< sides closer than this are as stiff as closed ones
  Vector pulls_;
  const Vector& lengths_;
  Vector compliances_;                       ///< of springs with linear surfaces
  std::vector<const Surface::Place*> laws_;  ///< of others, or null
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

double loadSize(const Problem& problem, const Vector& given, const Vector& lengths,
                double moved, double own, const RigidDrives& drives) {
  constexpr double rounding = 1e-13;
  const auto motions = at(problem.rigidMotions());
  const auto ofRigid = at(drives.freeMotions());
  Vector pulls(motions - ofRigid);
  const Vector bySprings = drives.pulls();
  pulls.insert(pulls.end(), bySprings.begin(), bySprings.end());
  const Bed::Point point = settled(
      Bed(problem, given, lengths, std::move(pulls), problem.slipBounds({})), motions);
  for (const double alpha : point.alpha)
    moved = std::max(moved, std::abs(alpha));
  const double pressed = largestEntry(point.pressures);
  return own + drives.loadSize(point.alpha.data() + (motions - ofRigid)) +
         (point.closing > rounding * moved ? pressed : 0);
}

Vector placement(const Problem& problem, const Vector& given, const Vector& lengths) {
  constexpr double touching = 1e-12;  // rounding of gaps, dimensionless
  Vector bounds = problem.slipBounds({});
  for (std::size_t t = 0; t < bounds.size(); ++t)
    if (problem.tangentials[t].followsPressure() && problem.tangentials[t].carries())
      bounds[t] = std::numeric_limits<double>::infinity();
  return settled(
             Bed(problem, given, lengths, problem.rigidLoad, std::move(bounds), touching),
             at(problem.rigidMotions()))
      .alpha;
}

}  // namespace epafi::contact
