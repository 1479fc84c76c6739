#include "bem/moments/NearPairs.hpp"

#include "bem/moments/ArcPairs.hpp"
#include "bem/moments/RelativeTarget.hpp"
#include "bem/quadrature/Graded.hpp"
#include "bem/simd/Dispatch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi::bem {

namespace {

constexpr int stride = TileMoments::stride;

// ∫ P_n Q_m dt over [-1,1] for n + m odd, principal value.            [DLMF 14.17.9]
double integralPQ(int n, int m) { return 2.0 / ((n - m) * (n + m + 1.0)); }

// An element with itself:  log|w| = log(h/2) + log|s-t|,  w/conj(w) = τ²,  w·n = 0.
double selfMoment(int i, int j) {
  if ((i + j) % 2 == 1)
    return 0;
  if (j == 0)
    return i == 0 ? 4 * std::log(2.0) - 6
                  : 2 * (integralPQ(0, i + 1) - integralPQ(0, i - 1)) / (2 * i + 1);
  return 2 * (integralPQ(i, j + 1) - integralPQ(i, j - 1)) / (2 * j + 1);
}

/// What is integrated over the outer element x and the inner one y.
enum Table { Log, Along, Across, Direct, Reverse, Tables };

struct Shape {
  int rows;     ///< densities on x
  int columns;  ///< on y
  std::size_t at(int table, int i, int j) const {
    return static_cast<std::size_t>((table * (rows + 1) + i) * (columns + 1) + j);
  }
  std::size_t size() const { return at(Tables, 0, 0); }
};

/// The outer element seen from the inner one, on its arc or a straight line of targets: those of its
/// ends and what half a length of it adds.
struct Sight {
  RelativeTarget start;
  RelativeTarget end;
  Complex step;
};

Sight sightOf(const Mesh& mesh, int outer, int inner) {
  const Element& x = mesh[outer];
  const Element& y = mesh[inner];
  const double ratio = x.half / y.half;
  const bool onLine = x.piece.edge == y.piece.edge;
  const Vec2 direction = x.curve.frame().tangent;
  const Curve::Frame& frame = y.curve.frame();
  return {seenFrom(mesh, inner, mesh.at(outer, -1)),
          seenFrom(mesh, inner, mesh.at(outer, 1)),
          onLine && !y.curve.isStraight()  // by arc length
              ? ratio
              : ratio * Complex(dot(direction, frame.tangent),
                                onLine ? 0.0 : dot(direction, frame.normal))};
}

/// What the kernels read and write.
struct Work {
  const GradedRule& rule;
  const Sight& sight;
  Shape shape;
  Complex turn;  ///< conj(τ_x) τ_y h_x/h_y
  AlignedLane* sums;
};

/// Eight points of the outer rule.
struct Points {
  alignas(64) double t[lanes];
  alignas(64) double fromStart[lanes];
  alignas(64) double toEnd[lanes];
  alignas(64) double weight[lanes];

  EPAFI_INLINE Points(const GradedRule& rule, int first) {
    for (int lane = 0; lane < lanes; ++lane) {
      const bool isThere = first + lane < rule.size();
      const auto at = static_cast<std::size_t>(isThere ? first + lane : first);
      t[lane] = rule.points[at].t;
      fromStart[lane] = rule.points[at].fromStart;
      toEnd[lane] = rule.points[at].toEnd;
      weight[lane] = isThere ? rule.weights[at] : 0;
    }
  }
};

/// Targets z = a + ib as in RelativeTarget.
struct Targets {
  Pack z;
  Pack minus;  ///< a - 1
  Pack plus;   ///< a + 1
  Pack b;

  EPAFI_INLINE Targets(const Sight& s, const Points& points) {
    const Pack fromStart = load(points.fromStart);
    const Pack toEnd = load(points.toEnd);
    const Pack zero{};
    const auto atStart = fromStart < toEnd;
    const Pack along = atStart ? fromStart : -toEnd;
    const auto from = [&](const Complex& start, const Complex& end, Pack& x, Pack& y) {
      x = (atStart ? zero + start.real() : zero + end.real()) + s.step.real() * along;
      y = (atStart ? zero + start.imag() : zero + end.imag()) + s.step.imag() * along;
    };
    Pack bOfPlus;
    from(s.start.zMinus1, s.end.zMinus1, minus, b);
    from(s.start.zPlus1, s.end.zPlus1, plus, bOfPlus);
    // both from the offset to the nearer end
    const auto atOne = minus * minus + b * b < plus * plus + bOfPlus * bOfPlus;
    z = atOne ? 1.0 + minus : plus - 1.0;
    const Pack other = atOne ? minus + 2.0 : plus;
    minus = atOne ? minus : plus - 2.0;
    plus = other;
    b = atOne ? b : bOfPlus;
  }
};

/// 2 Q_j and Re ∫ P_j log(z-t) dt of eight targets; Parts 1: on the element's line, where
/// all is real.
template <int Parts>
struct Legendre {
  static constexpr int size = largestMoment + 1;
  Pack c[Parts][size];
  Pack l[size];

  EPAFI_INLINE void evaluate(const Targets& x, int top) {
    const Pack minus2 = x.minus * x.minus + x.b * x.b;
    const Pack plus2 = x.plus * x.plus + x.b * x.b;
    Pack logMinus;
    Pack logPlus;
    logarithm(minus2, logMinus);
    logarithm(plus2, logPlus);
    c[0][0] = 0.5 * (logPlus - logMinus);
    l[0] = 0.5 * (logPlus + logMinus) - 2.0 + x.z * c[0][0];
    if constexpr (Parts == 2) {
      angle(2.0 * x.b, x.minus * x.plus + x.b * x.b, c[1][0]);
      c[1][0] = -c[1][0];
      l[0] -= x.b * c[1][0];
    }
    if (top == 0)
      return;
    Pack distanceMinus;
    Pack distancePlus;
    squareRoot(minus2, distanceMinus);
    squareRoot(plus2, distancePlus);
    const Pack focal = distanceMinus + distancePlus;
    // The forward recurrence loses R = |z + √(z-1) √(z+1)| a step: one digit in all is what
    // moments of size 1 can spare.  R + 1/R is the sum of distances.
    const double limit = 2 * std::cosh(std::log(10.0) / top);
    double nearest = std::numeric_limits<double>::infinity();
    int count = 0;
    for (int lane = 0; lane < lanes; ++lane)
      if (focal[lane] > limit) {
        nearest = std::min(nearest, focal[lane]);
        ++count;
      }
    if (count < lanes)
      forward(x, top);
    if (count > 0) {
      Legendre other;
      other.backward(x, top, std::acosh(0.5 * nearest), *this);
      const auto isFar = focal > limit;
      for (int part = 0; part < Parts; ++part)
        for (int j = 1; j <= top; ++j)
          c[part][j] = isFar ? other.c[part][j] : c[part][j];
    }
    for (int j = 1; j < top; ++j)
      l[j] = (c[0][j + 1] - c[0][j - 1]) * (1.0 / (2 * j + 1));
  }

 private:
  EPAFI_INLINE void forward(const Targets& x, int top) {
    c[0][1] = x.z * c[0][0] - 2.0;
    if constexpr (Parts == 2) {
      c[0][1] -= x.b * c[1][0];
      c[1][1] = x.z * c[1][0] + x.b * c[0][0];
    }
    for (int j = 1; j < top; ++j) {
      const double here = (2 * j + 1.0) / (j + 1);
      const double before = j / (j + 1.0);
      Pack real = x.z * c[0][j];
      if constexpr (Parts == 2) {
        real -= x.b * c[1][j];
        c[1][j + 1] = here * (x.z * c[1][j] + x.b * c[0][j]) - before * c[1][j - 1];
      }
      c[0][j + 1] = here * real - before * c[0][j - 1];
    }
  }

  // Miller's recurrence, scaled to 2 Q₀: from where R^-2 a step has left 1e-16 of it.  It
  // is kept near 1 until the first value that is wanted.
  EPAFI_INLINE void backward(const Targets& x, int top, double logR,
                             const Legendre& first) {
    Pack above[2] = {};
    Pack here[2] = {Pack{} + 1.0, Pack{}};
    const int start = std::max(top, static_cast<int>(18.5 / logR + 0.5 * top)) + 2;
    for (int j = start; j > 0; --j) {
      const double inverse = 1.0 / j;
      Pack real = x.z * here[0];
      if constexpr (Parts == 2) {
        real -= x.b * here[1];
        const Pack imag = x.z * here[1] + x.b * here[0];
        const Pack below = (2 + inverse) * imag - (1 + inverse) * above[1];
        above[1] = here[1];
        here[1] = below;
      }
      const Pack below = (2 + inverse) * real - (1 + inverse) * above[0];
      above[0] = here[0];
      here[0] = below;
      if (j - 1 <= top) {
        for (int part = 0; part < Parts; ++part)
          c[part][j - 1] = here[part];
      } else if (j % 16 == 0) {
        const Pack scale = 1.0 / (here[0] * here[0] + here[1] * here[1]);
        Pack root;
        squareRoot(scale, root);
        for (int part = 0; part < Parts; ++part) {
          here[part] *= root;
          above[part] *= root;
        }
      }
    }
    Pack norm = c[0][0] * c[0][0];
    Pack real = first.c[0][0] * c[0][0];
    Pack imag{};
    if constexpr (Parts == 2) {
      norm += c[1][0] * c[1][0];
      real += first.c[1][0] * c[1][0];
      imag = first.c[1][0] * c[0][0] - first.c[0][0] * c[1][0];
    }
    const Pack inverse = 1.0 / norm;
    real *= inverse;
    imag *= inverse;
    for (int j = 0; j <= top; ++j) {
      const Pack value = c[0][j];
      c[0][j] = real * value;
      if constexpr (Parts == 2) {
        c[0][j] -= imag * c[1][j];
        c[1][j] = real * c[1][j] + imag * value;
      }
    }
  }
};

template <int Parts>
struct NearKernel {
  const Work& work;

  template <Division How>
  EPAFI_INLINE void run() const {
    const Shape shape = work.shape;
    const int rows = shape.rows;
    const int columns = shape.columns;
    Pack weighted[largestMoment + 1];
    Legendre<Parts> inner;
    for (int first = 0; first < work.rule.size(); first += lanes) {
      const Points points(work.rule, first);
      const Targets x(work.sight, points);
      inner.evaluate(x, Parts == 1 && columns == 1 ? 0 : columns);
      const Pack t = load(points.t);
      weighted[0] = load(points.weight);
      weighted[1] = t * weighted[0];
      for (int k = 1; k < rows; ++k)
        weighted[k + 1] = ((2 * k + 1.0) / (k + 1)) * (t * weighted[k]) -
                          (k / (k + 1.0)) * weighted[k - 1];
      for (int j = 0; j < columns; ++j)
        for (int i = 0; i < rows; ++i)
          put(Log, i, j, weighted[i] * inner.l[j]);
      if constexpr (Parts == 2)
        for (int j = 0; j <= columns; ++j) {
          const Pack real = inner.c[0][j];
          const Pack imag = inner.c[1][j];
          for (int i = 0; i < rows; ++i)
            put(Direct, i, j, -weighted[i] * imag);
          if (j == columns)
            continue;
          const Pack along = x.b * real;
          const Pack across = -x.b * imag;
          const Pack reverse = work.turn.real() * imag + work.turn.imag() * real;
          for (int i = 0; i < rows; ++i) {
            put(Along, i, j, weighted[i] * along);
            put(Across, i, j, weighted[i] * across);
          }
          for (int i = 0; i <= rows; ++i)
            put(Reverse, i, j, weighted[i] * reverse);
        }
    }
  }

  EPAFI_INLINE void put(int table, int i, int j, const Pack& value) const {
    add(work.sums[work.shape.at(table, i, j)].lane, value);
  }
};

/// 1e-13 of the moments' norm with polynomials of both degrees: where the elements touch,
/// integrands are like log s in the distance s, on one line like s log s.
GradedRule nearRule(const Mesh& mesh, int outer, int inner) {
  const Piece& piece = mesh[inner].piece;
  std::vector<Feature> features;
  for (const Position& end : {piece.start, piece.end}) {
    const RelativeTarget seen = seenFrom(mesh, outer, {piece.edge, end, 0});
    features.push_back({seen.z().real(), std::abs(seen.b())});
  }
  const bool hasArc = !mesh[outer].curve.isStraight() || !mesh[inner].curve.isStraight();
  const int degree = mesh[outer].densities + mesh[inner].densities + (hasArc ? 6 : 0);
  const bool onLine = mesh[outer].piece.edge == piece.edge;
  return touchingRule(
      features, 17 + degree / 2,
      onLine ? Softening{5, 20 + 7 * degree / 6} : Softening{7, 26 + 27 * degree / 20});
}

double total(const AlignedLane& sums) {
  const double* x = sums.lane;
  return ((x[0] + x[1]) + (x[2] + x[3])) + ((x[4] + x[5]) + (x[6] + x[7]));
}

}  // namespace

void NearMoments::evaluate(const Mesh& mesh, int e, int f, TileMoments& m, int lane,
                           InstructionSet set) {
  const int rows = mesh[e].densities;
  const int columns = mesh[f].densities;
  const bool onLine = mesh[e].piece.edge == mesh[f].piece.edge;
  if (onLine)  // w·n = 0
    for (int i = 0; i <= rows; ++i)
      for (int j = 0; j <= columns; ++j) {
        const int at = i * stride + j;
        m.along[at][lane] = m.across[at][lane] = 0;
        m.direct[at][lane] = m.reverse[at][lane] = 0;
        m.log[at][lane] = e == f ? selfMoment(i, j) : 0;
      }
  const bool hasArc = !mesh[e].curve.isStraight() || !mesh[f].curve.isStraight();
  if (e == f) {
    m.log[0][lane] += 4 * std::log(mesh[e].half);
    if (hasArc)
      bendMoments(mesh, e, f, m, lane);
    return;
  }
  // the smaller element outside: the potential of the larger one is smoother on it
  const bool transposed = mesh[e].half > mesh[f].half;
  const int outer = transposed ? f : e;
  const int inner = transposed ? e : f;
  const Element& x = mesh[outer];
  const Element& y = mesh[inner];
  const Shape shape = {x.densities, y.densities};
  sums_.assign(shape.size(), AlignedLane{});
  const GradedRule rule = nearRule(mesh, outer, inner);
  if (hasArc && !onLine)
    return nearArcMoments(mesh, e, f, rule, m, lane);
  const Sight sight = sightOf(mesh, outer, inner);
  const Complex tangentX = asComplex(x.curve.frame().tangent);
  const Complex tangentY = asComplex(y.curve.frame().tangent);
  const Work work = {rule, sight, shape, x.half / y.half * std::conj(tangentX) * tangentY,
                     sums_.data()};
  if (onLine)
    dispatch(set, NearKernel<1>{work});
  else
    dispatch(set, NearKernel<2>{work});
  const auto sum = [&](int table, int i, int j) {
    return total(sums_[shape.at(table, i, j)]);
  };
  // w/conj(w) = τ² (1 - 2 (w·n)²/r² - 2i (w·n)(w·τ)/r²) for either element's τ
  const Complex turned = std::pow(tangentY * std::conj(tangentX), 2);
  for (int i = 0; i <= x.densities; ++i)
    for (int j = 0; j <= y.densities; ++j) {
      const int at = transposed ? j * stride + i : i * stride + j;
      if (i < x.densities)
        (transposed ? m.reverse : m.direct)[at][lane] = sum(Direct, i, j);
      if (j < y.densities)
        (transposed ? m.direct : m.reverse)[at][lane] = sum(Reverse, i, j);
      if (i == x.densities || j == y.densities)
        continue;
      const double constant = i == 0 && j == 0 ? 4 : 0;
      m.log[at][lane] = sum(Log, i, j) + constant * std::log(y.half);
      Complex phase(constant - 2 * sum(Across, i, j), -2 * sum(Along, i, j));
      if (transposed)
        phase *= turned;
      m.across[at][lane] = 0.5 * (constant - phase.real());
      m.along[at][lane] = -0.5 * phase.imag();
    }
  if (hasArc)
    bendMoments(mesh, e, f, m, lane);
}

}  // namespace epafi::bem
