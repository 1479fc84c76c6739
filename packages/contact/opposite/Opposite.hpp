#pragma once

#include "bem/base/Matrix.hpp"
#include "bem/base/Vec2.hpp"
#include "bem/geometry/NormalRay.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "bem/space/DisplacementField.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"
#include "contact/opposite/Direction.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace epafi::contact {

/// Small motion `slide` + `turn` e_z x arm of a rigid body; arm: vector from its reference
/// point.
struct RigidMotion {
  bem::Vec2 slide{};
  double turn = 0;  ///< [radian]

  bem::Vec2 at(bem::Vec2 arm) const { return slide + turn * turnLeft(arm); }
};

using bem::Matrix;

/// Boundary of the opposite body of a contact side.
struct OppositeSide {
  int body = -1;              ///< index of a deformable body; -1: rigid
  int rigid = -1;             ///< index of a rigid body
  bem::CurveTree curves;      ///< elements or edges, in the scaling of that body
  std::vector<int> elements;  ///< their numbers in its mesh; empty: it does not deform
  std::vector<int> degrees;   ///< likewise
  std::vector<bem::Continuations> beyond;  ///< the curves; empty: nothing is known
  bem::Vec2 shift;               ///< a place there less the same place on the side
  bem::Visibility visibility{};  ///< of both bodies, in the scaling of that body
  bem::Vec2 pole{};              ///< reference point of what does not deform
};

class Opposite;

/// A part of an element, t = middle + half s, |s| <= 1, on which Opposite::at is smooth.
struct Stretch {
  double middle = 0;
  double half = 1;
  const Opposite* opposite = nullptr;  ///< null: points on it have nothing opposite
};

/// The opposite side as a function of points of the sides that carry the multiplier, of all bodies:
/// outlines of other bodies for contacts with a name, found along the normals of the contact side, beside
/// its apexes along those opposite; fixed obstacles at the gap of the conditions, which may have kinks anywhere, for all others.
///
/// The gap is the way to the opposite point along the direction of contact plus the gap of the
/// condition; on bonded sides only the latter.  The direction is directionBetween the sides, on
/// bonded sides and before obstacles the side's outward normal.  Breaks are the projections of the
/// opposite nodes.                                   [doc/theory/contact.md, Several bodies]
class Opposite {
 public:
  /// Fixed obstacles only.
  /// \param length of 1, in the user's units
  explicit Opposite(double length) : length_(length) {}
  /// \param sides by the contacts' names.  Refers to the multiplier's elements.
  /// \throws bem::InputError for an element that has nothing opposite, if only on a part longer than
  /// what a mesh leaves out between a node and the end of what is opposite
  Opposite(const MultiplierSpace& multiplier, double length,
           const std::map<std::string, OppositeSide>& sides);

  struct Point {
    Direction direction{};
    double gap = 0;  ///< along it, dimensionless
    int turning =
        0;  ///< Gauss points, beyond those for polynomials, for what turns there
    int element = -1;       ///< of the opposite body; -1: not deformable
    int degree = 0;         ///< of that element
    double t = 0;           ///< parameter on that element
    int body = 0;           ///< index of the deformable body
    int rigid = -1;         ///< index of the rigid body; -1: none, or fixed
    bem::Vec2 arm{};        ///< from its reference point, dimensionless
    double stretching = 1;  ///< measure of the side over that of the opposite one; 0: too
                            ///< far away to be pressed on
  };
  /// \pre -1 <= t <= 1.
  Point at(const MultiplierSpace::ContactElement& element, double t) const;

  /// Kinks and jumps of at() in an element, ascending in (-1, 1).
  Vector breaks(const MultiplierSpace::ContactElement& element) const;

  /// The largest degree of the elements opposite to an element; 0 if none is deformable.
  int degree(const MultiplierSpace::ContactElement& element) const;

  /// A point of the side opposite to a point of a deformable body; stretching: measure of the side
  /// over that of the body.
  struct Source {
    const MultiplierSpace::ContactElement* element;
    double t;
    double stretching;
    bem::Vec2 across;  ///< d of contact
  };
  std::vector<Source> sources(int body, int element, double t) const;
  /// Where these bend or jump inside that element, within [-1, 1], in any order.
  Vector sourceBreaks(int body, int element) const;

  /// The parts of contact elements that see an element of a deformable body.
  struct Seen {
    const MultiplierSpace::ContactElement* by;
    Stretch stretch;
    int element;  ///< that is seen
  };
  std::vector<Seen> seen(int body, int element) const;

  /// Does nothing opposite move at all?
  bool isStill() const { return sides_.empty(); }

  /// Does another deformable body lie opposite to sides of this one?
  bool meetsDeformable(std::size_t body) const;

 private:
  struct Sight {
    const OppositeSide* side = nullptr;
    bem::Continuations beyond{};  ///< the element
    std::vector<bem::Facing> stretches{};
    const MultiplierSpace::ContactElement* element = nullptr;
    bem::Normals along = bem::Normals::Own;
  };
  const Sight& sight(const MultiplierSpace::ContactElement& element) const;
  /// The gap of the condition, dimensionless.
  double givenGap(const MultiplierSpace::ContactElement& element, double t) const;
  /// visit(sight, stretch) of all that face an element of a body, in the order of the side.
  template <class Visit>
  void forEachFacing(int body, int element, const Visit& visit) const;

  double length_;
  std::map<std::string, OppositeSide> sides_{};
  std::vector<std::vector<Sight>> sights_{};  ///< by body and element of its mesh
  /// By body and element: what faces it.
  std::map<std::pair<int, int>, std::vector<std::pair<const Sight*, const bem::Facing*>>>
      facing_{};
};

/// The rule for forces on a stretch, by its middle, the same wherever they are summed, so that they
/// balance: exact where sides are straight and parallel, up to rounding where directions turn.
const bem::Rule& ruleOfForces(const MultiplierSpace::ContactElement& element,
                              const Opposite::Point& middle);

/// All of an element.
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

/// Rotation of the opposite body, of which arcs that turn about their centres do not take notice.
double turnAt(const Motions* motions, const Opposite::Point& point);

}  // namespace epafi::contact
