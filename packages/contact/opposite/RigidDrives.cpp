#include "contact/opposite/RigidDrives.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/opposite/SidePoints.hpp"
#include "contact/opposite/TraceCoupling.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace epafi::contact {

using bem::Vec2;

std::vector<RigidDrives::Traces> RigidDrives::tracesOf(std::size_t bodies,
                                                       const MultiplierSpace& multiplier,
                                                       const Opposite& opposite) {
  std::vector<Traces> all(bodies);
  for (Traces& own : all)
    own.values = Matrix(multiplier.size(), 3);
  forEachSidePoint(
      multiplier, opposite,
      [&](const auto& contact, const Opposite::Point& middle) {
        const bool isOne = middle.rigid >= 0 && at(middle.rigid) < bodies;
        return isOne ? &ruleOfForces(contact, middle) : nullptr;
      },
      [&](const SidePoint& point) {
        Traces& own = all[at(point.opposite.rigid)];
        const bool hasAll = !point.contact.mesh->outline().isAxisymmetric();
        const Vec2 arm = hasAll ? point.opposite.arm : Vec2{};
        own.length += point.weight;
        own.lever = std::max(own.lever, norm(arm));
        const std::array<Vec2, 3> motions = {Vec2{hasAll ? 1.0 : 0.0, 0}, Vec2{0, 1},
                                             turnLeft(arm)};
        point.forEachCoefficient([&](Index i, double chi, const Direction& direction) {
          for (Index k = 0; k < 3; ++k)
            own.values(i, k) += chi * dot(point.weight * motions[k], direction.unit);
          if (hasAll)
            own.values(i, 2) -= chi * point.weight * direction.oppositeTurn;
        });
      });
  for (Traces& own : all) {
    if (!(own.lever > 0))
      continue;
    Vector turned = bem::columnOf(own.values, 2);
    dropRounding(bem::columnOf(own.values, 0), bem::columnOf(own.values, 1), {own.lever},
                 turned);
    for (Index i = 0; i < multiplier.size(); ++i)
      own.values(i, 2) = turned[at(i)] / own.lever;
  }
  return all;
}

RigidDrives::RigidDrives(std::vector<Drive> drives, const MultiplierSpace& multiplier,
                         const Opposite& opposite)
    : drives_(std::move(drives)),
      traces_(std::make_shared<const std::vector<Traces>>(
          tracesOf(drives_.size(), multiplier, opposite))) {}

RigidDrives RigidDrives::under(std::vector<Drive> drives) const {
  RigidDrives result = *this;
  result.drives_ = std::move(drives);
  return result;
}

Index RigidDrives::freeMotions() const {
  Index count = 0;
  forEachFree([&](std::size_t, std::size_t) { ++count; });
  return count;
}

double RigidDrives::given(std::size_t k, std::size_t c) const {
  const Drive::Component& drive = drives_[k].components[c];
  const double stiff = stiffness(k, c);
  return drive.free ? stiff / (1 + stiff) * drive.end : drive.value;
}

double RigidDrives::force(std::size_t k, std::size_t c) const {
  const Drive::Component& drive = drives_[k].components[c];
  return drive.value + drive.inside + drive.stiffness / (1 + stiffness(k, c)) * drive.end;
}

Vector RigidDrives::pulls() const {
  Vector result;
  forEachFree([&](std::size_t k, std::size_t c) {
    const double stiff = stiffness(k, c);
    result.push_back(stiff / (1 + stiff) * scaleOf(k, c) * drives_[k].components[c].end);
  });
  return result;
}

double RigidDrives::loadSize(const double* alpha) const {
  double load = 0;
  const Vector pull = pulls();
  std::size_t free = 0;
  forEachFree([&](std::size_t k, std::size_t c) {
    const Drive::Component& drive = drives_[k].components[c];
    const double ofSpring = pull[free] - stiffness(k, c) * alpha[free];
    const double given = (drive.value + drive.inside) / scaleOf(k, c);
    if (const double length = (*traces_)[k].length; length > 0)
      load += (std::abs(given) + std::abs(ofSpring)) / length;
    ++free;
  });
  return load;
}

void RigidDrives::setMotions(std::vector<Vector> columns, Problem& problem) const {
  forEachFree([&](std::size_t k, std::size_t c) {
    Vector& column = columns.emplace_back(at((*traces_)[k].values.rows()));
    std::transform(trace(k, c), trace(k, c) + column.size(), column.begin(),
                   std::negate<>());
  });
  problem.rigid = Matrix(problem.size(), static_cast<Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k)
    std::copy(columns[k].begin(), columns[k].end(),
              problem.rigid.column(static_cast<Index>(k)));
}

void RigidDrives::addGiven(Vector& penetration) const {
  for (std::size_t k = 0; k < drives_.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) {
      const double motion = given(k, c);
      for (std::size_t i = 0; motion != 0 && i < penetration.size(); ++i)
        penetration[i] -= scaleOf(k, c) * motion * trace(k, c)[i];
    }
}

void RigidDrives::addForces(Problem& problem) const {
  Vector springs(problem.rigidLoad.size(), 0.0);
  forEachFree([&](std::size_t k, std::size_t c) {
    problem.rigidLoad.push_back(force(k, c) / scaleOf(k, c));
    springs.push_back(stiffness(k, c));
  });
  if (std::any_of(springs.begin(), springs.end(), [](double k) { return k > 0; }))
    problem.rigidStiffness = std::move(springs);
}

void RigidDrives::append(const std::vector<RigidMotion>& motions, Vector& alpha) const {
  forEachFree([&](std::size_t k, std::size_t c) {
    const RigidMotion motion = motions.empty() ? RigidMotion{} : motions[k];
    const double components[] = {motion.slide.x, motion.slide.y, motion.turn};
    alpha.push_back(motions.empty() ? 0 : scaleOf(k, c) * (components[c] - given(k, c)));
  });
}

std::vector<RigidMotion> RigidDrives::motions(const double* alpha) const {
  std::vector<RigidMotion> result;
  for (std::size_t k = 0; k < drives_.size(); ++k) {
    double components[3];
    for (std::size_t c = 0; c < 3; ++c) {
      components[c] = given(k, c);
      if (drives_[k].components[c].free)
        components[c] += *alpha++ / scaleOf(k, c);
    }
    result.push_back({{components[0], components[1]}, components[2]});
  }
  return result;
}

std::vector<std::array<double, 3>> RigidDrives::forces(const Vector& multiplier) const {
  std::vector<std::array<double, 3>> result(drives_.size());
  for (std::size_t k = 0; k < result.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c)
      result[k][c] =
          scaleOf(k, c) *
          std::inner_product(multiplier.begin(), multiplier.end(), trace(k, c), 0.0);
  return result;
}

double RigidDrives::energyOfSprings(const Vector& multiplier) const {
  const auto ofContact = forces(multiplier);
  double energy = 0;
  forEachFree([&](std::size_t k, std::size_t c) {
    const Drive::Component& drive = drives_[k].components[c];
    const double spring = ofContact[k][c] + drive.value + drive.inside;
    if (drive.stiffness > 0)
      energy += spring * spring / (2 * drive.stiffness);
  });
  return energy;
}

}  // namespace epafi::contact
