#include "reference/Scatter.hpp"

#include "bem/operators/Block.hpp"

#include <algorithm>

namespace epafi::reference {

using namespace epafi::bem;

Scatter::Scatter(const Space& space, const Lame& lame, Operators& out)
    : space_(space), lame_(lame), out_(out) {
  for (int k = 0; k <= largestDegree; ++k)
    slopes_[k] = DisplacementBasis::slope(k);
}

void Scatter::add(int e, int f, const LaneMoments& m) const {
  const Element& x = space_.mesh()[e];
  const Element& y = space_.mesh()[f];
  for (int i = 0; i < x.densities; ++i)
    for (int j = 0; j < y.densities; ++j) {
      const double constant = i == 0 && j == 0 ? 4 : 0;
      // d d'/r² = (I + [Re, Im; Im, -Re] of w/conj(w)) / 2
      const Kernel radial = {0.5 * (constant + m.phaseReal(i, j)),
                             0.5 * m.phaseImag(i, j),
                             0.5 * (constant - m.phaseReal(i, j))};
      const double log = m.log(i, j);
      const double area = x.half * y.half;
      const double xy = area * lame_.b * radial.xy;
      addBlock(out_.singleLayer, space_.density(e, i, 0), space_.density(f, j, 0),
               {area * (lame_.b * radial.xx - lame_.a * log), xy, xy,
                area * (lame_.b * radial.yy - lame_.a * log)});
      if (i < x.degree && j < y.degree)
        addHypersingular(e, i, f, j,
                         {lame_.d * (radial.xx - log), lame_.d * radial.xy,
                          lame_.d * (radial.yy - log)});
    }
  if (x.piece.edge == y.piece.edge)
    addTurning(e, f, m.phaseReal(0, 0), m.phaseImag(0, 0));
  addDoubleLayer(e, f, MomentsAsTheyAre{m});
  if (e != f)
    addDoubleLayer(f, e, MomentsSwapped{m});
  else
    addHalfMass(e);
}

// K v = K_Δ v - X M v.  For v = φ e_x, M v = (0, -φ'); for v = φ e_y, M v = (φ', 0).
// X = 2μ V - V_Δ without its constant part, which ∫ v' = 0 over a loop removes:
// 2μ A - 1/2π = μ (A - B) = 2 μ (1-2ν) B keeps its digits as ν -> 1/2.
template <class Moments>
void Scatter::addDoubleLayer(int test, int source, const Moments& m) const {
  const Element& x = space_.mesh()[test];
  const int p = space_.mesh()[source].degree;
  const double ofLog = x.half * 2 * lame_.mu * (1 - 2 * lame_.nu) * lame_.b;
  // on one line: the phase is in addTurning, the Laplace double layer vanishes
  const bool sameEdge = x.piece.edge == space_.mesh()[source].piece.edge;
  const double ofPhase = sameEdge ? 0 : x.half * lame_.mu * lame_.b;
  const double ofLaplace = sameEdge ? 0 : x.half * lame_.mu * (lame_.a + lame_.b);
  for (int i = 0; i < x.densities; ++i) {
    const Index row = space_.density(test, i, 0);
    for (int k = 0; k <= p; ++k) {
      const int j = k < 2 ? 0 : k - 1;  // φ_k' = slope P_j
      const double slope = slopes_[k];
      double laplace = 0;  // ∫∫ P_i φ_k
      if (sameEdge)
        ;
      else if (k < 2)
        laplace = 0.5 * (m.direct(i, 0) + (k == 0 ? -1 : 1) * m.direct(i, 1));
      else
        laplace = slope / (2 * k - 1) * (m.direct(i, k) - m.direct(i, k - 2));
      laplace *= ofLaplace;
      const double re = ofPhase * m.phaseReal(i, j);
      const double im = slope * ofPhase * m.phaseImag(i, j);
      const double log = ofLog * m.log(i, j);
      addBlock(out_.doubleLayer, row, space_.displacement(source, k, 0),
               {im + laplace, slope * (-re - log), slope * (log - re), laplace - im});
    }
  }
}

// On one line the phase is one constant, whose contributions of neighbours cancel at
// every node but the edge's ends.  Adding and subtracting it would leave rounding, which
// is large beside the rest as ν -> 1/2.
void Scatter::addTurning(int e, int f, double phaseReal, double phaseImag) const {
  const double scale = lame_.mu * lame_.b;
  const Kernel turning = {scale * phaseReal, scale * phaseImag, -scale * phaseReal};
  addTurningAtEnds(e, f, turning);
  if (e != f)
    addTurningAtEnds(f, e, turning);
}

void Scatter::addTurningAtEnds(int test, int source, const Kernel& turning) const {
  const Mesh& mesh = space_.mesh();
  const Element& y = mesh[source];
  const Index row = space_.density(test, 0, 0);
  for (int k = 0; k < 2; ++k) {
    const int neighbour = k == 0 ? y.previous : y.next;
    if (mesh[neighbour].piece.edge == y.piece.edge)
      continue;
    const double s = mesh[test].half * slopes_[k];
    addBlock(out_.doubleLayer, row, space_.displacement(source, k, 0),
             {s * turning.xy, s * turning.yy, -s * turning.xx, -s * turning.xy});
  }
}

// <W φ_k, φ_l> = <V* φ_k', φ_l'>.  Only the lower triangle counts, so what would stand
// above the diagonal goes to its mirror image, and blocks on the diagonal get both.
void Scatter::addHypersingular(int e, int i, int f, int j, const Kernel& v) const {
  const int firstK = i == 0 ? 0 : i + 1;
  const int lastK = i == 0 ? 1 : i + 1;
  const int firstL = j == 0 ? 0 : j + 1;
  const int lastL = j == 0 ? 1 : j + 1;
  for (int k = firstK; k <= lastK; ++k)
    for (int l = firstL; l <= lastL; ++l) {
      const Index row = space_.displacement(e, k, 0);
      const Index column = space_.displacement(f, l, 0);
      double s = slopes_[k] * slopes_[l];
      if (e == f && row < column)
        continue;  // comes again with k and l exchanged
      if (e != f && row == column)
        s *= 2;
      addBlock(out_.hypersingular, std::max(row, column), std::min(row, column),
               {s * v.xx, s * v.xy, s * v.xy, s * v.yy});
    }
}

void Scatter::addHalfMass(int e) const {
  const Element& x = space_.mesh()[e];
  const Matrix coefficients = DisplacementBasis::legendreCoefficients(x.degree);
  for (int i = 0; i < std::min(x.densities, x.degree + 1); ++i)
    for (int k = 0; k <= x.degree; ++k) {
      const double mass = x.half * coefficients(i, k) / (2 * i + 1);
      addBlock(out_.doubleLayer, space_.density(e, i, 0), space_.displacement(e, k, 0),
               {mass, 0, 0, mass});
    }
}

}  // namespace epafi::reference
