#pragma once

#include "bem/moments/FarPairs.hpp"
#include "bem/quadrature/Graded.hpp"

namespace epafi::bem {

/// farMoments where E or an element of the batch is an arc: tensor Gauss with a logarithm
/// and a reciprocal per point pair, points and normals on the curves.
void farArcMoments(const Element& e, const FarBatch& batch, PairDegrees degrees,
                   FarOrder order, TileMoments& moments,
                   InstructionSet set = largestInstructionSet());

/// NearMoments::evaluate of elements that are not on one line, one of them an arc at
/// least: the larger one's potential at the points `rule` of the smaller one.
void nearArcMoments(const Mesh& mesh, int e, int f, const GradedRule& rule,
                    TileMoments& moments, int lane);

/// What makes moments of two elements of one arc, of half a circle at most, from those on
/// a line, where w·n = 0 and only `log` is there: w = (t₀ - t) g has the direction of the
/// tangent half way, and g = h/2 sinc is smooth.            [doc/theory/operators.md]
void bendMoments(const Mesh& mesh, int e, int f, TileMoments& moments, int lane);

}  // namespace epafi::bem
