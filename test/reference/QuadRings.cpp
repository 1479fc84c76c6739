#include "reference/QuadRings.hpp"

#include <algorithm>
#include <array>

namespace epafi::reference {

namespace {

const Quad pi = acos(Quad(-1));

/// Complete elliptic integrals K and E of the complementary parameter m₁.
std::array<Quad, 2> elliptic(const Quad& m1) {
  Quad a = 1;
  Quad b = sqrt(m1);
  Quad power = 1;
  Quad sum = (1 - m1) / 2;
  while (fabs(a - b) > 1e-20 * a) {
    const Quad c = (a - b) / 2;
    const Quad mean = (a + b) / 2;
    b = sqrt(a * b);
    a = mean;
    sum += power * c * c;
    power *= 2;
  }
  const Quad k = pi / (a + b);
  return {k, k * (1 - sum)};
}

/// A basis function's value and its derivative by arc length.
struct Value {
  Quad value;
  Quad slope;
};

class Integrals {
 public:
  Integrals(const bem::Mesh& mesh, int e, int f, const bem::Lame& lame)
      : first_(mesh[e]),
        second_(mesh[f]),
        x_(curveOf(mesh, e)),
        y_(curveOf(mesh, f)),
        nu_(lame.nu),
        mu_(lame.mu),
        b_(lame.b == 0 ? Quad(0) : 1 / (16 * pi * mu_ * (1 - nu_))),
        a_(lame.b == 0 ? 1 / (4 * pi)
                       : (3 - 4 * nu_) * b_),  // Laplace's, see lameOfRingLaplace
        result{QuadBlock(2 * first_.densities, 2 * second_.densities),
               QuadBlock(2 * first_.densities, 2 * second_.degree + 2),
               QuadBlock(2 * first_.degree + 2, 2 * second_.degree + 2)} {}

  const QuadCurve& x() const { return x_; }
  const QuadCurve& y() const { return y_; }

  /// At the parameters t of the first and s of the second element; w = x - y.
  void add(const Quad& t, const Quad& s, const QuadVec& w, const Quad& weight);

 private:
  static QuadCurve curveOf(const bem::Mesh& mesh, int e) {
    const bem::Curve& curve = mesh[e].curve;
    const bem::Vec2 from = mesh.scaledPoint(e, -1);
    const bem::Vec2 tangent = curve.frame().tangent;
    return {{from.x, from.y},
            {tangent.x, tangent.y},
            Quad(mesh[e].half),
            Quad(curve.angle()) / 2};
  }
  static std::vector<Value> basis(const bem::Element& element, const Quad& t) {
    const int p = element.degree;
    const std::vector<Quad> legendre = reference::legendre(std::max(p, 1), t);
    std::vector<Value> all = {{(1 - t) / 2, Quad(-1) / 2}, {(1 + t) / 2, Quad(1) / 2}};
    for (int k = 2; k <= p; ++k)
      all.push_back({(legendre[k] - legendre[k - 2]) / sqrt(Quad(2 * (2 * k - 1))),
                     sqrt(Quad(2 * k - 1) / 2) * legendre[k - 1]});
    for (Value& v : all)
      v.slope /= element.half;
    return all;
  }

  bem::Element first_;
  bem::Element second_;
  QuadCurve x_;
  QuadCurve y_;
  Quad nu_;
  Quad mu_;
  Quad b_;
  Quad a_;

 public:
  QuadRings result;
};

// <W u, v> = ∫∫ 2π r_x r_y (μ/2π ∫ C(u)·C(v)/R + M v · (2μL - 4μ²G) M u),  M u = J u' - n u_r/r
void Integrals::add(const Quad& t, const Quad& s, const QuadVec& w, const Quad& weight) {
  const Quad rx = x_.point(t).x;
  const Quad ry = y_.point(s).x;
  const QuadVec tx = x_.tangent(t);
  const QuadVec ty = y_.tangent(s);
  const QuadVec nx = x_.normal(t);
  const QuadVec ny = y_.normal(s);
  const Quad w2 = dot(w, w);
  const Quad q2 = w2 + 4 * rx * ry;
  const Quad m1 = w2 / q2;
  const Quad m = 4 * rx * ry / q2;
  const auto [k, e] = elliptic(m1);
  const Quad b = (e - m1 * k) / m;
  const Quad d = (k - e) / m;
  const Quad q = sqrt(q2);
  const Quad e0 = 4 * k / q;
  const Quad e1 = 4 * (d - b) / q;
  const Quad es = 16 * (d - (d - b) / m) / (3 * q);
  const Quad g1 = 4 * b / (q * w2);
  const Quad g2 = 4 * d / (q2 * q);
  const Quad g3 = 4 * (d - (d - b) / m) / (q2 * q);
  const Quad whole = g1 + g2;   // ∫ 1/R³
  const Quad turned = g1 - g2;  // ∫ cos/R³
  const Quad px = w.x * whole + 2 * ry * g2;
  const Quad py = w.x * whole - 2 * rx * g2;
  const Quad v[2][2] = {
      {a_ * e1 + b_ * (w.x * w.x * turned - 4 * rx * ry * g3), b_ * w.y * px},
      {b_ * w.y * py, a_ * e0 + b_ * w.y * w.y * whole}};
  const Quad l[2] = {e1 / (4 * pi), e0 / (4 * pi)};
  // double layer of Laplace from y to x
  const Quad across = dot(ny, w);
  const Quad kl[2] = {(across * turned - 2 * rx * ny.x * (g2 - 2 * g3)) / (4 * pi),
                      (across * whole - 2 * rx * ny.x * g2) / (4 * pi)};
  const std::vector<Value> us = basis(second_, s);
  const std::vector<Value> vs = basis(first_, t);
  const std::vector<Quad> psi = legendre(second_.densities, s);
  const std::vector<Quad> chi = legendre(first_.densities, t);
  const Quad area = 2 * pi * weight * rx * ry * x_.half * y_.half;
  // M of a function of one component
  const auto m_ = [](const Value& f, int c, const QuadVec& n, const Quad& r) {
    return c == 0 ? QuadVec{-n.x * f.value / r, f.slope - n.y * f.value / r}
                  : QuadVec{-f.slope, 0};
  };
  const auto component = [](const QuadVec& vec, int c) { return c == 0 ? vec.x : vec.y; };
  for (int i = 0; i < first_.densities; ++i)
    for (int c = 0; c < 2; ++c) {
      for (int j = 0; j < second_.densities; ++j)
        for (int g = 0; g < 2; ++g)
          result.singleLayer(2 * i + c, 2 * j + g) += area * chi[i] * psi[j] * v[c][g];
      for (int j = 2; j <= second_.degree; ++j)
        for (int g = 0; g < 2; ++g) {
          const QuadVec mu = m_(us[j], g, ny, ry);
          Quad sum = c == g ? kl[c] * us[j].value : Quad(0);
          for (int h = 0; h < 2; ++h)
            sum += (2 * mu_ * v[c][h] - (c == h ? l[c] : Quad(0))) * component(mu, h);
          result.doubleLayer(2 * i + c, 2 * j + g) += area * chi[i] * sum;
        }
    }
  for (int i = 2; i <= first_.degree; ++i)
    for (int c = 0; c < 2; ++c)
      for (int j = 2; j <= second_.degree; ++j)
        for (int g = 0; g < 2; ++g) {
          const QuadVec mv = m_(vs[i], c, nx, rx);
          const QuadVec mu = m_(us[j], g, ny, ry);
          Quad sum = 0;
          for (int h = 0; h < 2; ++h)
            for (int o = 0; o < 2; ++o)
              sum += component(mv, h) * component(mu, o) *
                     ((h == o ? 2 * mu_ * l[h] : Quad(0)) - 4 * mu_ * mu_ * v[h][o]);
          Quad curl = 0;
          if (c == 0 && g == 0)
            curl = us[j].slope * vs[i].slope * (e0 - es) +
                   es * (tx.x * us[j].slope * vs[i].value / rx +
                         ty.x * vs[i].slope * us[j].value / ry) +
                   (tx.x * ty.x * (e0 - es) + tx.y * ty.y * e1) * us[j].value *
                       vs[i].value / (rx * ry);
          if (c == 1 && g == 1)
            curl = us[j].slope * vs[i].slope * e1;
          result.hypersingular(2 * i + c, 2 * j + g) +=
              area * (sum + mu_ / (2 * pi) * curl);
        }
}

}  // namespace

double QuadBlock::frobenius() const {
  Quad sum = 0;
  for (const Quad& v : values_)
    sum += v * v;
  return static_cast<double>(sqrt(sum));
}

QuadRings quadRings(const bem::Mesh& mesh, int e, int f, const bem::Lame& lame,
                    double tolerance) {
  Integrals sums(mesh, e, f, lame);
  const QuadCurve& x = sums.x();
  const QuadCurve& y = sums.y();
  const QuadRule rule = doubleExponential(tolerance);
  const bool isEnd = mesh[e].next == f;
  const bool touches = isEnd || mesh[f].next == e;
  // chord from the place at a distance (in parameters) from an end to that end
  const auto fromEnd = [](const QuadCurve& curve, int end, const Quad& distance) {
    const Quad turn = curve.alpha * distance / 2;
    const Quad sinc = turn == 0 ? Quad(1) : Quad(sin(turn) / turn);
    const Quad middle = end - end * distance / 2;
    return (-end * curve.half * distance * sinc) * curve.tangent(middle);
  };
  const auto chord = [](const QuadCurve& curve, const Quad& difference, const Quad& sum) {
    const Quad turn = curve.alpha * difference / 2;
    const Quad sinc = turn == 0 ? Quad(1) : Quad(sin(turn) / turn);
    return (curve.half * difference * sinc) * curve.tangent(sum / 2);
  };
  for (std::size_t i = 0; i < rule.points.size(); ++i)
    for (std::size_t j = 0; j < rule.points.size(); ++j) {
      const Quad& a = rule.points[i];
      const Quad& b = rule.points[j];
      const Quad weight = 4 * rule.weights[i] * rule.weights[j];
      if (e == f) {  // a: the distance
        const Quad s = -1 + 2 * (1 - a) * b;
        const Quad t = s + 2 * a;
        const QuadVec w = chord(x, 2 * a, s + t);
        sums.add(t, s, w, weight * (1 - a));
        sums.add(s, t, Quad(-1) * w, weight * (1 - a));
      } else if (touches) {
        const int end = isEnd ? 1 : -1;
        for (const bool farther : {false, true}) {
          const Quad p = 2 * (farther ? a : a * b);
          const Quad q = 2 * (farther ? a * b : a);
          sums.add(end - end * p, -end + end * q,
                   fromEnd(x, end, p) - fromEnd(y, -end, q), weight * a);
        }
      } else {
        const Quad t = 2 * a - 1;
        const Quad s = 2 * b - 1;
        sums.add(t, s, x.point(t) - y.point(s), weight);
      }
    }
  return sums.result;
}

}  // namespace epafi::reference
