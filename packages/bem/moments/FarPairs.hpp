#pragma once

#include "bem/mesh/Mesh.hpp"
#include "bem/moments/PairMoments.hpp"
#include "bem/simd/InstructionSet.hpp"
#include "bem/simd/Pack.hpp"

namespace epafi::bem {

/// Eight elements F = first ... first+7 seen from one element E, structure of arrays.
struct alignas(64) FarBatch {
  double wx[lanes];  ///< middle of E minus middle of F
  double wy[lanes];
  double tx[lanes];  ///< tangent of F
  double ty[lanes];
  double half[lanes];

  /// `w`: middle of E minus middle of F.
  void set(int lane, Vec2 w, const Element& f) {
    wx[lane] = w.x;
    wy[lane] = w.y;
    tx[lane] = f.tangent.x;
    ty[lane] = f.tangent.y;
    half[lane] = f.half;
  }
  /// A lane that is not wanted: far off, so that nothing overflows.
  void drop(int lane) {
    wx[lane] = wy[lane] = 10;
    tx[lane] = half[lane] = 1;
    ty[lane] = 0;
  }
};

/// The largest smoothOrder.
constexpr int largestSmoothOrder = 48;

/// Gauss orders of a pair: on E and on F.
struct PairOrder {
  int outer = 0;
  int inner = 0;
};

/// Gauss points that polynomials of a degree cost on top of what the kernel needs.
constexpr int degreeShare(int degree) { return (degree + 2) / 2 + 1; }

/// Gauss points on an element for 1e-12, without what polynomials cost on top, the other
/// one outside the ellipse about the element whose sum of focal distances is z lengths.
/// [doc/theory/operators.md]
int smoothOrder(double z);

/// True when the pair must go to nearPairMoments: the gap is below half the larger
/// length. Otherwise sets the orders that give eps = 1e-12 (tensor Gauss),
/// which grow with the degree and shrink with the distance, separately for the two
/// elements.
bool isNear(const Mesh& mesh, int e, int f, PairOrder& order);
/// The same with `w`, the middle of E minus that of F.
bool isNear(const Mesh& mesh, int e, int f, Vec2 w, PairOrder& order);

/// The same for a point x instead of E, w = x - middle of F; otherwise sets the order on
/// F.
bool isNear(Vec2 w, const Element& f, int& order);

/// Numbers of eight lanes, for containers.
struct alignas(64) AlignedLane {
  double lane[lanes];
};

/// Moments of a far pair, one lane of the batch.
class FarMoments {
 public:
  static constexpr int stride = largestDegree + 1;
  using Lane = double[lanes];
  alignas(64) Lane log[stride * stride];
  alignas(64) Lane along[stride * stride];   ///< ∫∫ P_i P_j (w·n_F)(w·τ_F)/|w|²
  alignas(64) Lane across[stride * stride];  ///< ∫∫ P_i P_j (w·n_F)²/|w|²
  alignas(64) Lane direct[stride * stride];
  alignas(64) Lane reverse[stride * stride];
};

/// Largest degrees of the polynomials on E and on F.
struct PairDegrees {
  int rows = 0;
  int columns = 0;
};

/// Far moments of E against a batch: degrees p_E and the batch's largest, orders the
/// batch's largest.  Tensor Gauss with one reciprocal per point pair
/// and one logarithm per outer point: ∫ P_j log|w| comes from ∫ P_j w·τ/|w|² by parts.
void farMoments(const Element& e, const FarBatch& batch, PairDegrees degrees,
                PairOrder order, FarMoments& moments,
                InstructionSet set = largestInstructionSet());

/// Copies one lane out.
void extractLane(const FarMoments& far, int lane, Vec2 tangent, int rows, int columns,
                 PairMoments& moments);

}  // namespace epafi::bem
