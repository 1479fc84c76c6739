#pragma once

#include "bem/fields/RunGroups.hpp"
#include "bem/moments/RingKernels.hpp"

#include <array>
#include <functional>
#include <vector>

namespace epafi::bem {

/// Points of rings that act on others: in some states, those of a point contiguous.
struct RingPointSources {
  /// Place, tangent and radius: FarBlocks::inner_.
  std::vector<std::array<double, 5>> places{};
  std::vector<Complex> forces{};         ///< ψ ds
  std::vector<Complex> displacements{};  ///< u ds, or jumps of u
};

/// Eight points of rings and their tangents; what acts there is times 2πr.
struct alignas(64) RingTargets {
  AlignedLane x;
  AlignedLane y;
  AlignedLane tangentX;
  AlignedLane tangentY;
};

/// Of RingGroups.
struct RingGroup : RunGroup {
  RingPointSources circle;  ///< forces
  /// Displacements of eight Gauss points of a piece, n (1 - t²) times a number, for what forces cannot do
  /// at ν = 1/2: change a volume.
  RingPointSources swelling;
  std::vector<double> swelled;  ///< the number, of each state
  RingPointSources ends;        ///< displacements where its elements end

  double halfOfPiece() const { return 0.25 * radius; }
};

/// What groups of elements of a solid of revolution do to what is far: forces on a circle around them (from
/// axis to axis where it meets that), and a piece that changes the volume inside, which move the places of a
/// wider circle as the elements do, by least squares.  K and W by parts, as of elements that are near, are
/// more by what jumps of u where a group ends do.        [doc/theory/axisymmetric.md, Groups]
class RingGroups : public RunGroups<RingGroup> {
 public:
  /// ψ and u of a state at a point of an element.
  struct Value {
    Complex force;
    Complex displacement;
  };
  using Values = std::function<Value(int element, double t, std::size_t state)>;

  /// Refers to the runs.  \param smallest  see RunGroups
  RingGroups(const ElementRuns& runs, const Lame& lame, const Values& values,
             std::size_t states, int smallest);

  /// V ψ - K u and the traction W u + K' ψ of a group: of each state four packs, r and z of both.
  void add(const RingGroup& group, const RingTargets& targets, AlignedLane* to) const;

 private:
  void addEnds(const Values& values, int e, RingGroup& group) const;
  RingPointSources pointsOf(const Values& values, const RingGroup& group) const;
  void sumElements(const Values& values, RingGroup& group) const;

  RingLame lame_;
  std::size_t states_;
};

}  // namespace epafi::bem
