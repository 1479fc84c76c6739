#pragma once

#include "bem/fields/Interior.hpp"
#include "bem/fields/RingGroups.hpp"
#include "bem/simd/ComplexPack.hpp"

#include <vector>

namespace epafi::bem {

/// Interior for solids of revolution: u = V ψ - K u and its derivatives by those of the kernels, with
/// Gauss points on elements halved toward x.         [doc/theory/axisymmetric.md, Fields inside]
///
/// The uniform state that has the displacement of the place of the boundary nearest to x is taken
/// off before and added behind, so that no digits are lost close to it.
class RingInterior {
 public:
  /// \param fields  of each element
  RingInterior(const Mesh& mesh, const Lame& lame, std::vector<LocalField> fields);

  /// \pre the points are inside the body or on its axis, off its surface
  std::vector<InteriorValue> at(const std::vector<Vec2>& points) const;

 private:
  /// Eight points of an element, what is there.
  struct alignas(64) Sources {
    AlignedLane weight{};  ///< of ds
    ComplexLanes place{};
    ComplexLanes tangent{};
    ComplexLanes value{};
    ComplexLanes slope{};
    ComplexLanes density{};
  };
  struct Uniform;
  struct Sum;

  static constexpr int packs = 4;  ///< rules have 8, 16, 24 or 32 points

  Sources sources(int e, const double* places, const double* weights) const;
  Uniform uniformOf(double radial, double start, double height) const;
  Uniform uniformNear(Vec2 x) const;
  /// Of the fields and of the two states that Uniform is made of.
  RingGroups groupsOf(const ElementRuns& runs, int smallest) const;
  InteriorValue at(Vec2 x, const ElementRuns& runs, const RingGroups& groups) const;
  void add(int e, Vec2 x, const Uniform& uniform, Sum& sum) const;
  void add(const RingGroup& group, Vec2 x, const Uniform& uniform, Sum& sum) const;

  Mesh mesh_;
  std::vector<int> elements_;  ///< off the axis
  CurveTree surface_;          ///< of them
  Lame lame_;
  std::vector<LocalField> fields_;
  /// Of each element the points of all rules, from the smallest on.
  std::vector<Sources> whole_;
};

}  // namespace epafi::bem
