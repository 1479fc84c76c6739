#pragma once

#include "contact/opposite/NormalRay.hpp"
#include "contact/opposite/Opposite.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace epafi::contact {

/// The boundary of another body that a contact side meets.
struct MetSide {
  int body = -1;                   ///< which of the bodies that deform; -1: it does not
  int rigid = -1;                  ///< which of those that do not
  std::vector<bem::Curve> curves;  ///< elements or edges, in the scaling of that body
  std::vector<int> elements;  ///< their numbers in its mesh; empty: it does not deform
  std::vector<int> degrees;   ///< likewise
  bem::Vec2 shift;            ///< a place there less the same place on the side
  double reach = 0;           ///< how far along a normal it is looked for
  bem::Vec2 pole{};           ///< reference point of what does not deform
};

/// What the contact sides of a body meet where a scene has several: the outlines of other
/// bodies, found along the side's normals, and obstacles at a distance elsewhere.
///
/// The gap is the distance along the normal plus what the condition adds, the latter alone
/// where sides are bonded: as they are drawn.  Breaks are the feet of the nodes opposite.
///                                                    [doc/theory/contact.md, Several bodies]
class FacingBodies final : public Opposite {
 public:
  /// \param met by the contacts' names.  Refers to the mesh.
  FacingBodies(const bem::Mesh& mesh, const MultiplierSpace& multiplier, double length,
               std::map<std::string, MetSide> met);

  Point at(const MultiplierSpace::ContactElement& element, double t) const override;
  Vector breaks(const MultiplierSpace::ContactElement& element) const override;
  int degree(const MultiplierSpace::ContactElement& element) const override;
  bool isStill() const override { return met_.empty(); }
  std::vector<int> bodies() const override;
  std::vector<Source> sources(int body, int element, double t) const override;
  Vector sourceBreaks(int body, int element) const override;

 private:
  struct Sight {
    const MetSide* side = nullptr;
    std::vector<Facing> stretches;
    const MultiplierSpace::ContactElement* element = nullptr;
  };
  const Sight& sight(const MultiplierSpace::ContactElement& element) const {
    return sights_[element.element];
  }
  /// visit(sight, stretch) of all that face an element of a body, in the order of the side.
  template <class Visit>
  void forEachFacing(int body, int element, const Visit& visit) const;

  const bem::Mesh& mesh_;
  double length_;
  DistantObstacle distant_;
  std::map<std::string, MetSide> met_;
  std::vector<Sight> sights_;  ///< by element of the mesh
  /// By body and its element: what faces it, of sights_ and of their stretches.
  std::map<std::pair<int, int>, std::vector<std::pair<std::size_t, std::size_t>>> facing_;
};

}  // namespace epafi::contact
