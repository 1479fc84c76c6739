#pragma once

#include "bem/base/Matrix.hpp"
#include "bem/base/Vec2.hpp"
#include "bem/space/DisplacementField.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"

namespace epafi::contact {

/// Small motion `slide` + `turn` e_z x arm of a rigid body; arm: vector from its reference
/// point.
struct RigidMotion {
  bem::Vec2 slide{};
  double turn = 0;  ///< [radian]

  bem::Vec2 at(bem::Vec2 arm) const { return slide + turn * turnLeft(arm); }
};

using bem::Matrix;

/// The opposite side as a function of points of the side that carries the multiplier; this class: a
/// fixed obstacle at the gap of the conditions, which may have kinks anywhere.
class Opposite {
 public:
  /// \param length of 1, in the user's units.  Refers to the mesh.
  Opposite(const bem::Mesh& mesh, double length) : mesh_(mesh), length_(length) {}
  virtual ~Opposite() = default;

  struct Point {
    double gap = 0;    ///< along the outward normal, dimensionless
    int element = -1;  ///< of the opposite body; -1: not deformable
    double t = 0;      ///< parameter on that element
    int body = 0;      ///< index of the deformable body
    int rigid = -1;    ///< index of the rigid body; -1: none, or fixed
    bem::Vec2 arm{};   ///< from its reference point, dimensionless
  };
  /// \pre -1 <= t <= 1.
  virtual Point at(const MultiplierSpace::ContactElement& element, double t) const {
    return {givenGap(element, t)};
  }

  /// Kinks and jumps of at() in an element, ascending in (-1, 1).
  virtual Vector breaks(const MultiplierSpace::ContactElement& /*element*/) const {
    return {};
  }

  /// The largest degree of the elements opposite to an element; 0 if none is deformable.
  virtual int degree(const MultiplierSpace::ContactElement& /*element*/) const {
    return 0;
  }

  /// A point of the side opposite to a point of a deformable body; stretching: ds of the side over
  /// ds of the body.
  struct Source {
    const MultiplierSpace::ContactElement* element;
    double t;
    double stretching;
  };
  virtual std::vector<Source> sources(int /*body*/, int /*element*/, double /*t*/) const {
    return {};
  }
  /// Where these bend or jump inside that element, within [-1, 1], in any order.
  virtual Vector sourceBreaks(int /*body*/, int /*element*/) const { return {}; }

  /// Does nothing opposite move at all?
  virtual bool isStill() const { return true; }

  /// Indices of the opposite deformable bodies, each once.
  virtual std::vector<int> bodies() const { return {}; }

 protected:
  /// The gap of the condition, dimensionless.
  double givenGap(const MultiplierSpace::ContactElement& element, double t) const;

  const bem::Mesh& mesh_;  ///< of the side
  double length_;
};

/// The parts of an element, t = middle + half s, |s| <= 1, on which at() is smooth.
struct Stretch {
  double middle = 0;
  double half = 1;
};
std::vector<Stretch> stretches(const Opposite& opposite,
                               const MultiplierSpace::ContactElement& element);

/// Displacements and motions of all bodies of a scene, for relative displacements.
struct Motions {
  std::vector<bem::DisplacementField> displacements;
  std::vector<RigidMotion> rigid{};        ///< of rigid bodies, dimensionless
  Vector shearModuli;                      ///< dimensionless
  std::vector<BodyLoadSolution> inside{};  ///< body loads; empty: none
};

/// Displacement of the opposite point, dimensionless; zero if `motions` is null.
bem::Vec2 motionAt(const Motions* motions, const Opposite::Point& point);

}  // namespace epafi::contact
