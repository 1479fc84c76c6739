#pragma once

#include "bem/geometry/NormalRay.hpp"
#include "contact/opposite/Opposite.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace epafi::contact {

/// Boundary of the opposite body of a contact side.
struct OppositeSide {
  int body = -1;                   ///< index of a deformable body; -1: rigid
  int rigid = -1;                  ///< index of a rigid body
  std::vector<bem::Curve> curves;  ///< elements or edges, in the scaling of that body
  std::vector<int> elements;  ///< their numbers in its mesh; empty: it does not deform
  std::vector<int> degrees;   ///< likewise
  bem::Vec2 shift;            ///< a place there less the same place on the side
  double reach = 0;           ///< how far along a normal it is looked for
  bem::Vec2 pole{};           ///< reference point of what does not deform
};

/// Opposite sides in a scene with several bodies: outlines of other bodies, found along the
/// normals of the contact side, and fixed obstacles elsewhere.
///
/// The gap is the distance along the normal plus the gap of the condition; on bonded sides
/// only the latter.  Breaks are the projections of the opposite nodes.
///                                                    [doc/theory/contact.md, Several bodies]
class FacingBodies final : public Opposite {
 public:
  /// \param sides by the contacts' names.  Refers to the mesh.
  FacingBodies(const bem::Mesh& mesh, const MultiplierSpace& multiplier, double length,
               std::map<std::string, OppositeSide> sides);

  Point at(const MultiplierSpace::ContactElement& element, double t) const override;
  Vector breaks(const MultiplierSpace::ContactElement& element) const override;
  int degree(const MultiplierSpace::ContactElement& element) const override;
  bool isStill() const override { return sides_.empty(); }
  std::vector<int> bodies() const override;
  std::vector<Source> sources(int body, int element, double t) const override;
  Vector sourceBreaks(int body, int element) const override;

 private:
  struct Sight {
    const OppositeSide* side = nullptr;
    std::vector<bem::Facing> stretches;
    const MultiplierSpace::ContactElement* element = nullptr;
  };
  const Sight& sight(const MultiplierSpace::ContactElement& element) const {
    return sights_[element.element];
  }
  /// visit(sight, stretch) of all that face an element of a body, in the order of the side.
  template <class Visit>
  void forEachFacing(int body, int element, const Visit& visit) const;

  std::map<std::string, OppositeSide> sides_;
  std::vector<Sight> sights_;  ///< by element of the mesh
  /// By body and element: indices into sights_ and their stretches that face it.
  std::map<std::pair<int, int>, std::vector<std::pair<std::size_t, std::size_t>>> facing_;
};

}  // namespace epafi::contact
