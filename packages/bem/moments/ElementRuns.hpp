#pragma once

#include "bem/mesh/Mesh.hpp"
#include "bem/moments/Nearness.hpp"
#include "bem/simd/ComplexPack.hpp"

#include <vector>

namespace epafi::bem {

/// Elements first ... last - 1.
struct ElementRange {
  int first = 0;
  int last = 0;
  bool contain(int e) const { return first <= e && e < last; }
};

/// Up to eight elements F relative to an origin, as structure of arrays: those of a run, the
/// consecutive elements first ... last - 1 of one loop, relative to the origin of coordinates, or,
/// where choose() selected them, to the midpoint of an element E.
struct alignas(64) ElementLanes {
  double wx[lanes];  ///< midpoint of F, scaled; where chosen that of E minus it
  double wy[lanes];
  double tx[lanes];  ///< tangent of F at its midpoint
  double ty[lanes];
  double half[lanes];
  double alpha[lanes];  ///< half the angle by which F turns
  int first = 0;
  int last = 0;
  int degree = 0;           ///< the largest
  int densities = 0;        ///< the largest number on an element
  int loop = 0;             ///< counted from 0
  bool closesLoop = false;  ///< the last element ends at the first node of the loop
  double largestAngle = 0;  ///< by which an element turns
  double largestHalf = 0;
  Vec2 centre;  ///< of a circle around them
  double radius = 0;

  // where choose() selected them
  bool far[lanes] = {};   ///< of a run: is there an element in the lane?
  bool arePlain = false;  ///< all are far enough for differences of rounded coordinates
  Nearness smooth;        ///< for all far pairs
  Nearness own[lanes]{};  ///< for each of them

  /// `w`: midpoint of E minus midpoint of F.
  void set(int lane, Vec2 w, const Element& f) {
    wx[lane] = w.x;
    wy[lane] = w.y;
    tx[lane] = f.curve.frame().tangent.x;
    ty[lane] = f.curve.frame().tangent.y;
    half[lane] = f.half;
    alpha[lane] = 0.5 * f.curve.angle();
    far[lane] = true;
  }
  /// A point of each element relative to its middle, and the unit tangent there.
  struct alignas(64) Points {
    ComplexPack place;
    ComplexPack tangent;
  };
  EPAFI_INLINE Points at(const Pack& t) const {
    const Pack angle = (0.5 * t) * load(alpha);
    Pack sinc;
    Pack cosine;
    sineCosine(angle, sinc, cosine);
    const ComplexPack turn{cosine, angle * sinc};
    const ComplexPack chord = turn * ComplexPack{load(tx), load(ty)};
    return {(load(half) * t * sinc) * chord, turn * chord};
  }
  /// Fills an unused lane with a distant element, so that nothing overflows.
  void drop(int lane) {
    wx[lane] = wy[lane] = 10;
    tx[lane] = half[lane] = 1;
    ty[lane] = alpha[lane] = 0;
    far[lane] = false;
  }
};

/// Division of a mesh into runs of eight elements; the last run of a loop may be shorter.
class ElementRuns {
 public:
  explicit ElementRuns(const Mesh& mesh);

  const Mesh& mesh() const { return *mesh_; }
  int size() const { return static_cast<int>(runs_.size()); }
  int runOf(int e) const { return runOf_[e]; }
  const ElementLanes& operator[](int r) const { return runs_[r]; }

  /// Selects the far pairs of e and the wanted elements of run r.  A single test suffices if all
  /// elements are wanted and the circle is far.
  /// \param largestOuter pairs that need more Gauss points on e (without degreeShare) count as
  /// near; at least 7, which a far circle needs.  With the default, the result does not depend
  /// on which element of a pair is e.
  ElementLanes choose(int e, int r, const ElementRange& wanted,
                      int largestOuter = largestSmoothOrder) const;

 private:
  bool chooseAtOnce(int e, ElementLanes& run) const;

  const Mesh* mesh_;
  std::vector<ElementLanes> runs_;
  std::vector<int> runOf_;
};

}  // namespace epafi::bem
