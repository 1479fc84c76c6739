#pragma once

#include "bem/mesh/Mesh.hpp"
#include "bem/moments/FarOrder.hpp"
#include "bem/moments/TileMoments.hpp"
#include "bem/simd/InstructionSet.hpp"

namespace epafi::bem {

/// Eight elements F = first ... first+7 relative to an element E, as structure of arrays.
struct alignas(64) FarBatch {
  double wx[lanes];  ///< midpoint of E minus midpoint of F
  double wy[lanes];
  double tx[lanes];  ///< tangent of F at its midpoint
  double ty[lanes];
  double half[lanes];
  double alpha[lanes];  ///< half the angle by which F turns

  /// `w`: midpoint of E minus midpoint of F.
  void set(int lane, Vec2 w, const Element& f) {
    wx[lane] = w.x;
    wy[lane] = w.y;
    tx[lane] = f.curve.frame().tangent.x;
    ty[lane] = f.curve.frame().tangent.y;
    half[lane] = f.half;
    alpha[lane] = 0.5 * f.curve.angle();
  }
  /// Fills an unused lane with a distant element, so that nothing overflows.
  void drop(int lane) {
    wx[lane] = wy[lane] = 10;
    tx[lane] = half[lane] = 1;
    ty[lane] = alpha[lane] = 0;
  }
};

/// Number of Legendre polynomials of the densities on E (rows) and F (columns), at least the
/// degree of the displacements.
struct PairDegrees {
  int rows = 0;
  int columns = 0;
};

/// Gauss rules of a far pair, and Legendre polynomials at their points.
struct FarRules {
  const Rule& outer;
  const Rule& inner;
  const WeightedLegendre& outerTable;
  const WeightedLegendre& innerTable;
  /// Numbers of points on E and on F.
  FarRules(int onE, int onF)
      : outer(gaussLegendre(onE)),
        inner(gaussLegendre(onF)),
        outerTable(weightedLegendre(onE)),
        innerTable(weightedLegendre(onF)) {}
  FarRules(FarOrder order, PairDegrees degrees)
      : FarRules(order.outer + degreeShare(degrees.rows),
                 order.inner + degreeShare(degrees.columns)) {}
};

/// Far moments of a straight E and a batch of straight elements, by tensor Gauss quadrature with
/// one reciprocal per pair of points and one logarithm per outer point: ∫ P_j log|w| follows from
/// ∫ P_j w·τ/|w|² by parts.  `order` is without degreeShare.
void farMoments(const Element& e, const FarBatch& batch, PairDegrees degrees,
                FarOrder order, TileMoments& moments,
                InstructionSet set = largestInstructionSet());

/// farMoments if E or an element of the batch is an arc: tensor Gauss quadrature with a logarithm
/// and a reciprocal per pair of points; points and normals on the curves.
void farArcMoments(const Element& e, const FarBatch& batch, PairDegrees degrees,
                   FarOrder order, TileMoments& moments,
                   InstructionSet set = largestInstructionSet());

}  // namespace epafi::bem
