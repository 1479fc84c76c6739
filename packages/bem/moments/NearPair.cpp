#include "bem/moments/NearPair.hpp"

#include "bem/moments/RelativeTarget.hpp"
#include "bem/quadrature/Graded.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::bem {

namespace {

// ∫ P_n Q_m dt over [-1,1] for n + m odd, principal value.            [DLMF 14.17.9]
double integralPQ(int n, int m) { return 2.0 / ((n - m) * (n + m + 1.0)); }

// The phase of two elements on one line, exactly: what cancels between neighbours shall
// cancel.
void constantPhase(Vec2 tangent, int rows, int columns, PairMoments& moments) {
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      moments.phaseReal(i, j) = moments.phaseImag(i, j) = 0;
  moments.phaseReal(0, 0) = 4 * (tangent.x * tangent.x - tangent.y * tangent.y);
  moments.phaseImag(0, 0) = 8 * tangent.x * tangent.y;
}

// An element with itself:  log|w| = log(h/2) + log|s-t|,  w/conj(w) = τ²,  w·n = 0.
void selfMoments(const Element& element, PairMoments& moments) {
  const int p = element.degree;
  moments.clear(p, p);
  constantPhase(element.tangent, p, p, moments);
  for (int i = 0; i < p; ++i)
    for (int j = i % 2; j < p; j += 2)  // odd ones vanish
      moments.log(i, j) =
          j == 0 ? (i == 0 ? 4 * std::log(2.0) - 6
                           : 2 * integralPQ(0, i + 1) / (2 * i + 1) -
                                 2 * integralPQ(0, i - 1) / (2 * i + 1))
                 : 2 * (integralPQ(i, j + 1) - integralPQ(i, j - 1)) / (2 * j + 1);
  moments.log(0, 0) += 4 * std::log(element.half);
}

std::vector<Feature> feetOf(const Mesh& mesh, int inner, int outer) {
  const Piece& piece = mesh[inner].piece;
  std::vector<Feature> features;
  for (const Position& end : {piece.start, piece.end}) {
    const RelativeTarget seen = seenFrom(mesh, outer, {piece.edge, end, 0});
    features.push_back({seen.z().real(), std::abs(seen.b())});
  }
  return features;
}

/// Where the moments of (outer i, inner j) belong: transposed if outer is F.
struct TableWriter {
  PairMoments& moments;
  bool transposed;
  double& log(int i, int j) const {
    return transposed ? moments.log(j, i) : moments.log(i, j);
  }
};

/// 1e-13 of the moments' norm with polynomials of both degrees.  At a touching end the
/// integrands are like s log s, and a last interval of 1e-6 will do; beside an end that
/// is off the line by less they turn by pi over that distance.
GradedRule outerRule(const std::vector<Feature>& features, const Element& outer,
                     const Element& inner) {
  constexpr double closest = 1e-12;  // nearer ones are the end itself and rounding
  double smallest = 1e-6 * std::min(1.0, inner.half / outer.half);
  for (const Feature& feature : features)
    if (feature.distance > closest)
      smallest = std::min(smallest, feature.distance);
  return gradedRule(features, 17 + (outer.degree + inner.degree) / 2, smallest);
}

/// Two elements of one edge: logarithms of a real distance.
void lineMoments(const Mesh& mesh, int outer, int inner, const TableWriter& writer) {
  const Element& x = mesh[outer];
  const Element& y = mesh[inner];
  const bool ahead = distanceAlong(y.piece.start, x.piece.start) > 0;
  const double gap = ahead ? distanceAlong(y.piece.end, x.piece.start)
                           : distanceAlong(x.piece.end, y.piece.start);
  const double sign = ahead ? -1 : 1;
  const std::vector<Feature> features = {{sign * (1 + gap / x.half), 0},
                                         {sign * (1 + (gap + 2 * y.half) / x.half), 0}};
  const GradedRule rule = outerRule(features, x, y);
  const double logHalf = std::log(y.half);
  std::array<double, largestDegree + 1> legendre{};
  for (int q = 0; q < rule.size(); ++q) {
    const EndPoint& point = rule.points[q];
    const double beyond =
        (gap + x.half * (ahead ? point.fromStart : point.toEnd)) / y.half;
    LogMoments l = logMomentsAhead(beyond, y.degree - 1);
    l[0] += 2 * logHalf;
    if (!ahead)
      for (int j = 1; j < y.degree; j += 2)
        l[j] = -l[j];
    legendreValues(x.degree - 1, point.t, legendre.data());
    for (int i = 0; i < x.degree; ++i)
      for (int j = 0; j < y.degree; ++j)
        writer.log(i, j) += rule.weights[q] * legendre[i] * l[j];
  }
  constantPhase(x.tangent, x.degree, y.degree, writer.moments);
}

/// One pass: outer quadrature on `outer`, closed form on `inner`; calls
/// visit(weighted P_i(x), i, moments of inner at x, b).
template <class Visit>
void sweep(const Mesh& mesh, int outer, int inner, Need need, const Visit& visit) {
  const Element& x = mesh[outer];
  const Element& y = mesh[inner];
  const GradedRule rule = outerRule(feetOf(mesh, inner, outer), x, y);
  std::array<double, largestDegree + 1> legendre{};
  LegendreMoments moments;
  for (int q = 0; q < rule.size(); ++q) {
    const EndPoint& point = rule.points[q];
    const BoundaryPoint place = mesh.at(outer, point.fromStart, point.toEnd);
    const RelativeTarget seen = seenFrom(mesh, inner, place);
    evaluateMoments(seen, y.degree, need, moments);
    legendreValues(x.degree, point.t, legendre.data());
    for (int i = 0; i <= x.degree; ++i)
      visit(rule.weights[q] * legendre[i], i, moments, seen.b());
  }
}

// log and phase by outer quadrature on `outer`.
void logAndPhase(const Mesh& mesh, int outer, int inner, const TableWriter& writer) {
  const Element& y = mesh[inner];
  const Complex square =
      Complex(y.tangent.x, y.tangent.y) * Complex(y.tangent.x, y.tangent.y);
  const double logHalf = std::log(y.half);
  const int rows = mesh[outer].degree;
  PairMoments& m = writer.moments;
  sweep(mesh, outer, inner, Need::CandL,
        [&](double weight, int i, const LegendreMoments& at, double b) {
          if (i >= rows)
            return;
          for (int j = 0; j < y.degree; ++j) {
            const double delta = j == 0 ? 2 : 0;
            const double logarithm = weight * (at.l[j] + delta * logHalf);
            const Complex phase = weight * square * (delta - Complex(0, 2 * b) * at.c[j]);
            const int row = writer.transposed ? j : i;
            const int column = writer.transposed ? i : j;
            writer.log(i, j) += logarithm;
            m.phaseReal(row, column) += phase.real();
            m.phaseImag(row, column) += phase.imag();
          }
        });
}

}  // namespace

void nearPairMoments(const Mesh& mesh, int e, int f, PairMoments& moments) {
  if (e == f) {
    selfMoments(mesh[e], moments);
    return;
  }
  const int rows = mesh[e].degree;
  const int columns = mesh[f].degree;
  moments.clear(rows, columns);
  // the smaller element outside: the potential of the larger one is smoother on it
  const bool transposed = mesh[e].half > mesh[f].half;
  const int outer = transposed ? f : e;
  const int inner = transposed ? e : f;
  const TableWriter writer{moments, transposed};
  if (mesh[e].piece.edge == mesh[f].piece.edge) {  // w·n = 0: no more
    lineMoments(mesh, outer, inner, writer);
    return;
  }
  logAndPhase(mesh, outer, inner, writer);
  sweep(mesh, e, f, Need::C,
        [&](double weight, int i, const LegendreMoments& at, double) {
          if (i < rows)
            for (int j = 0; j <= columns; ++j)
              moments.direct(i, j) -= weight * at.c[j].imag();
        });
  sweep(mesh, f, e, Need::C,
        [&](double weight, int j, const LegendreMoments& at, double) {
          if (j < columns)
            for (int i = 0; i <= rows; ++i)
              moments.reverse(i, j) -= weight * at.c[i].imag();
        });
}

}  // namespace epafi::bem
