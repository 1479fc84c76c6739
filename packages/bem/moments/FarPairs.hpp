#pragma once

#include "bem/mesh/Mesh.hpp"
#include "bem/moments/FarOrder.hpp"
#include "bem/moments/TileMoments.hpp"
#include "bem/simd/InstructionSet.hpp"

namespace epafi::bem {

/// Eight elements F = first ... first+7 seen from one element E, structure of arrays.
struct alignas(64) FarBatch {
  double wx[lanes];  ///< middle of E minus middle of F
  double wy[lanes];
  double tx[lanes];  ///< tangent of F at its middle
  double ty[lanes];
  double half[lanes];
  double alpha[lanes];  ///< half the angle by which F turns

  /// `w`: middle of E minus middle of F.
  void set(int lane, Vec2 w, const Element& f) {
    wx[lane] = w.x;
    wy[lane] = w.y;
    tx[lane] = f.curve.frame().tangent.x;
    ty[lane] = f.curve.frame().tangent.y;
    half[lane] = f.half;
    alpha[lane] = 0.5 * f.curve.angle();
  }
  /// A lane that is not wanted: far off, so that nothing overflows.
  void drop(int lane) {
    wx[lane] = wy[lane] = 10;
    tx[lane] = half[lane] = 1;
    ty[lane] = alpha[lane] = 0;
  }
};

/// How many Legendre polynomials densities on E and on F have, and so the largest degrees
/// that displacements bring.
struct PairDegrees {
  int rows = 0;
  int columns = 0;
};

/// The rules of far pairs of these degrees, and polynomials at their points.
struct FarRules {
  const Rule& outer;
  const Rule& inner;
  const WeightedLegendre& outerTable;
  const WeightedLegendre& innerTable;
  /// Of points on E and on F.
  FarRules(int onE, int onF)
      : outer(gaussLegendre(onE)),
        inner(gaussLegendre(onF)),
        outerTable(weightedLegendre(onE)),
        innerTable(weightedLegendre(onF)) {}
  FarRules(FarOrder order, PairDegrees degrees)
      : FarRules(order.outer + degreeShare(degrees.rows),
                 order.inner + degreeShare(degrees.columns)) {}
};

/// Far moments of a straight E against a batch of straight elements.  `order` without what polynomials cost.  Tensor Gauss
/// with one reciprocal per point pair and one logarithm per outer point: ∫ P_j log|w| comes
/// from ∫ P_j w·τ/|w|² by parts.
void farMoments(const Element& e, const FarBatch& batch, PairDegrees degrees,
                FarOrder order, TileMoments& moments,
                InstructionSet set = largestInstructionSet());

/// farMoments where E or an element of the batch is an arc: tensor Gauss with a logarithm
/// and a reciprocal per point pair, points and normals on the curves.
void farArcMoments(const Element& e, const FarBatch& batch, PairDegrees degrees,
                   FarOrder order, TileMoments& moments,
                   InstructionSet set = largestInstructionSet());

}  // namespace epafi::bem
