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

/// Eight elements F = first ... first+7 relative to an element E, as structure of arrays, and
/// which of the pairs are far.
struct alignas(64) FarLanes {
  double wx[lanes];  ///< midpoint of E minus midpoint of F
  double wy[lanes];
  double tx[lanes];  ///< tangent of F at its midpoint
  double ty[lanes];
  double half[lanes];
  double alpha[lanes];  ///< half the angle by which F turns
  bool far[lanes] = {};
  bool arePlain = false;  ///< all are far enough for differences of rounded coordinates
  int densities = 0;      ///< of the run, the largest number on an element
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
  }
};

/// Up to eight consecutive elements of one loop, first ... last - 1, and a circle around
/// them.
struct ElementRun {
  FarLanes elements{};  ///< wx, wy: midpoints, scaled; lanes beyond the last dropped
  int first = 0;
  int last = 0;
  Vec2 centre;
  double radius = 0;
  double largestHalf = 0;
  int degree = 0;           ///< the largest
  int densities = 0;        ///< the largest number on an element
  int loop = 0;             ///< counted from 0
  bool closesLoop = false;  ///< the last element ends at the first node of the loop
  double angle = 0;         ///< largest angle by which an element turns
};

/// Division of a mesh into runs of eight elements; the last run of a loop may be shorter.
class ElementRuns {
 public:
  explicit ElementRuns(const Mesh& mesh);

  const Mesh& mesh() const { return *mesh_; }
  int size() const { return static_cast<int>(runs_.size()); }
  int runOf(int e) const { return runOf_[e]; }
  const ElementRun& operator[](int r) const { return runs_[r]; }

  /// Selects the far pairs of e and the wanted elements of run r.  A single test suffices if all
  /// elements are wanted and the circle is far.
  /// \param largestOuter pairs that need more Gauss points on e (without degreeShare) count as
  /// near; at least 7, which a far circle needs.  With the default, the result does not depend
  /// on which element of a pair is e.
  FarLanes choose(int e, int r, const ElementRange& wanted,
                  int largestOuter = largestSmoothOrder) const;

 private:
  bool chooseAtOnce(int e, const ElementRun& run, FarLanes& result) const;

  const Mesh* mesh_;
  std::vector<ElementRun> runs_;
  std::vector<int> runOf_;
};

}  // namespace epafi::bem
