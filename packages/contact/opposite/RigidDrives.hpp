#pragma once

#include "contact/opposite/Opposite.hpp"
#include "contact/problem/Problem.hpp"

#include <algorithm>
#include <array>
#include <memory>

namespace epafi::contact {

/// Given motion of a rigid body, or the force on it, in x, in y and about its reference point; a free
/// component may be held by a spring.  Dimensionless.
struct Drive {
  struct Component {
    bool free = false;
    double value = 0;      ///< force or moment of a free component; else the motion
    double inside = 0;     ///< force or moment of body loads
    double stiffness = 0;  ///< of the spring, whose force is stiffness (end - motion)
    double end = 0;        ///< motion of the spring's other end
  };
  std::array<Component, 3> components{};

  bool isFree() const {
    return std::any_of(components.begin(), components.end(),
                       [](const Component& one) { return one.free; });
  }
};

/// The bodies of a system that do not deform: how they are driven now, and what their motions
/// do to all multipliers.
class RigidDrives {
 public:
  RigidDrives(std::vector<Drive> drives, const MultiplierSpace& multiplier,
              const Opposite& opposite);
  /// The same bodies at another time of a path.
  RigidDrives under(std::vector<Drive> drives) const;

  const std::vector<Drive>& drives() const { return drives_; }
  Index freeMotions() const;
  /// Largest distance of a body's contact from its reference point.
  double lever(std::size_t k) const { return (*traces_)[k].lever; }
  /// Forces with which springs pull at α = 0, entries of q; without springs: zero.
  Vector pulls() const;
  /// Forces, of springs at these α, as pressures on opposite sides: Σ over bodies.
  double loadSize(const double* alpha) const;

  /// Sets G: behind elastic bodies' columns one -T m for each free motion m.
  void setMotions(std::vector<Vector> columns, Problem& problem) const;
  /// What given motions add to r, and the forces of free ones, appended to q, and springs to K.
  void addGiven(Vector& penetration) const;
  void addForces(Problem& problem) const;

  /// Appends what motions of all bodies are as entries of α; none: they stand still.
  void append(const std::vector<RigidMotion>& motions, Vector& alpha) const;
  /// And back, with those that are given.  \param alpha the first free one's
  std::vector<RigidMotion> motions(const double* alpha) const;
  /// What a multiplier does to each: forces in x and y, moment about the reference point.
  std::vector<std::array<double, 3>> forces(const Vector& multiplier) const;
  /// What the springs store under these forces of contact: Σ f² / (2 k), f the spring's.
  double energyOfSprings(const Vector& multiplier) const;

 private:
  /// Coupling of all multipliers with the motions m_k of a rigid body: (1, 0), (0, 1) and the
  /// rotation e_z x (y - y₀) / lever:
  ///
  ///   values_ik = ∫ χ_i d_i · m_k∘P ds,   d_i: n or t of the side, P: Opposite::at
  ///
  /// For a motion m (rotation times `lever`) the contact conditions contain C u - values m, and
  /// the forces on the body are valuesᵀ λ.
  struct Traces {
    Matrix values;      ///< multiplier x 3
    double lever = 0;   ///< largest |y - y₀| at contacts; zero: it has none
    double length = 0;  ///< of the sides that are opposite to it
  };
  static std::vector<Traces> tracesOf(std::size_t bodies,
                                      const MultiplierSpace& multiplier,
                                      const Opposite& opposite);

  /// What a motion about the reference point has in the units of its trace, or a moment.
  double scaleOf(std::size_t k, std::size_t c) const {
    const double lever = (*traces_)[k].lever;
    return c == 2 && lever > 0 ? lever : 1;
  }
  const double* trace(std::size_t k, std::size_t c) const {
    return (*traces_)[k].values.column(static_cast<Index>(c));
  }
  /// K of a spring, whose contact has a stiffness of about one.
  double stiffness(std::size_t k, std::size_t c) const {
    return drives_[k].components[c].stiffness / (scaleOf(k, c) * scaleOf(k, c));
  }
  /// The given motion; where a spring is the one that α counts from, and the force there:
  ///
  ///   α = motion - K/(1+K) end,   q = force + k/(1+K) end,
  ///
  /// where contact of stiffness one would hold the body.  Both are as small as what contact makes of
  /// them, whether the spring is soft and its end far away or it is stiff and its force a small
  /// difference.
  double given(std::size_t k, std::size_t c) const;
  double force(std::size_t k, std::size_t c) const;
  /// visit(body, component) of each free motion.
  template <class Visit>
  void forEachFree(const Visit& visit) const {
    for (std::size_t k = 0; k < drives_.size(); ++k)
      for (std::size_t c = 0; c < 3; ++c)
        if (drives_[k].components[c].free)
          visit(k, c);
  }

  std::vector<Drive> drives_;
  std::shared_ptr<const std::vector<Traces>> traces_;
};

}  // namespace epafi::contact
