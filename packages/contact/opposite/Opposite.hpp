#pragma once

#include "bem/base/Matrix.hpp"
#include "bem/base/Vec2.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"

namespace epafi::contact {

/// A small motion of a body that does not deform, `slide` + `turn` e_z x arm, the arm from
/// its reference point.
struct RigidMotion {
  bem::Vec2 slide{};
  double turn = 0;  ///< [radian]

  bem::Vec2 at(bem::Vec2 arm) const { return slide + turn * turnLeft(arm); }
};

using bem::Matrix;

/// What the side that carries the multiplier meets, seen from its points.
class Opposite {
 public:
  virtual ~Opposite() = default;

  struct Point {
    double gap = 0;    ///< along the side's outward normal, dimensionless
    int element = -1;  ///< of the body that is met; -1: nothing that deforms
    double t = 0;      ///< where on it
    int body = 0;      ///< which of the bodies that deform
    int rigid = -1;    ///< which of those that do not; -1: none that moves
    bem::Vec2 arm{};   ///< on it from its reference point, dimensionless
  };
  /// \pre -1 <= t <= 1.
  virtual Point at(const MultiplierSpace::ContactElement& element, double t) const = 0;

  /// Where at() bends or jumps inside an element, increasing within (-1, 1).
  virtual Vector breaks(const MultiplierSpace::ContactElement& /*element*/) const {
    return {};
  }

  /// The largest degree of what is met on an element; 0 where it does not deform.
  virtual int degree(const MultiplierSpace::ContactElement& /*element*/) const {
    return 0;
  }

  /// The places of the side that are opposite to a place on an element of a body that
  /// deforms, for what acts on that: the side's length there per length of what is met.
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

  /// Does nothing that is met move at all?
  virtual bool isStill() const { return true; }

  /// Which bodies that deform are met, each once.
  virtual std::vector<int> bodies() const { return {}; }
};

/// The parts of an element, t = middle + half s, |s| <= 1, on which at() is smooth.
struct Stretch {
  double middle = 0;
  double half = 1;
};
std::vector<Stretch> stretches(const Opposite& opposite,
                               const MultiplierSpace::ContactElement& element);

/// A rigid obstacle that the scene gives by its distance; it may bend anywhere.
class DistantObstacle final : public Opposite {
 public:
  /// \param length of 1, in the user's units.  Refers to the mesh.
  DistantObstacle(const bem::Mesh& mesh, double length) : mesh_(mesh), length_(length) {}
  Point at(const MultiplierSpace::ContactElement& element, double t) const override;

 private:
  const bem::Mesh& mesh_;
  double length_;
};

/// How the bodies of a scene move: what contact between them is measured by.
struct Motions {
  std::vector<const bem::Space*> spaces;
  std::vector<const Vector*> displacements;
  std::vector<RigidMotion> rigid{};  ///< of bodies that do not deform, dimensionless
  Vector shearModuli;                ///< dimensionless
  std::vector<Inside> inside{};      ///< what acts inside each; none: nothing does
};

/// Of what is met at a point, dimensionless; null: it stands still.
bem::Vec2 motionAt(const Motions* motions, const Opposite::Point& point);

}  // namespace epafi::contact
