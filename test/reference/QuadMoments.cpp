#include "reference/QuadMoments.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace epafi::reference {

QuadVec operator+(const QuadVec& a, const QuadVec& b) { return {a.x + b.x, a.y + b.y}; }
QuadVec operator-(const QuadVec& a, const QuadVec& b) { return {a.x - b.x, a.y - b.y}; }
QuadVec operator*(const Quad& s, const QuadVec& a) { return {s * a.x, s * a.y}; }
Quad dot(const QuadVec& a, const QuadVec& b) { return a.x * b.x + a.y * b.y; }

std::vector<Quad> legendre(int degree, const Quad& t) {
  std::vector<Quad> p = {1, t};
  for (int k = 1; k < degree; ++k)
    p.push_back(((2 * k + 1) * t * p[k] - k * p[k - 1]) / (k + 1));
  p.resize(static_cast<std::size_t>(degree) + 1);
  return p;
}

namespace {

/// What touches is bisected to 2^-deepest.
constexpr int deepest = 48;

Quad cross(const QuadVec& a, const QuadVec& b) { return a.x * b.y - a.y * b.x; }
Quad norm(const QuadVec& a) { return sqrt(dot(a, a)); }

QuadVec turned(const QuadVec& a, const Quad& angle) {
  if (angle == 0)
    return a;
  const Quad c = cos(angle);
  const Quad s = sin(angle);
  return {c * a.x - s * a.y, s * a.x + c * a.y};
}

/// Where a graded rule for a function with a singular point at distance `height` from
/// `foot` on the line of [0, 1] has its intervals: none longer than its distance from the
/// point.
void bisect(const Quad& from, const Quad& to, const Quad& foot, const Quad& height,
            std::vector<std::array<Quad, 3>>& intervals) {
  const Quad nearest = std::max(from, std::min(to, foot));
  const Quad distance = sqrt((nearest - foot) * (nearest - foot) + height * height);
  if (distance >= to - from) {
    intervals.push_back({from, to, distance});
    return;
  }
  const Quad middle = (from + to) / 2;
  bisect(from, middle, foot, height, intervals);
  bisect(middle, to, foot, height, intervals);
}

}  // namespace

QuadVec QuadCurve::tangent(const Quad& t) const {
  return turned(middleTangent, alpha * t);
}

QuadVec QuadCurve::normal(const Quad& t) const {
  const QuadVec tau = tangent(t);
  return {tau.y, -tau.x};
}

// chords from the start have the direction of the tangent half way
QuadVec QuadCurve::point(const Quad& t) const {
  const Quad s = alpha * (1 + t) / 2;
  const Quad sinc = s == 0 ? Quad(1) : Quad(sin(s) / s);
  return from + (half * (1 + t) * sinc) * tangent((t - 1) / 2);
}

QuadCurve segment(const QuadVec& from, const QuadVec& to) {
  const Quad length = norm(to - from);
  return {from, (1 / length) * (to - from), length / 2};
}

PairMoments::PairMoments(int firstDegree, int secondDegree)
    : firstDegree_(firstDegree),
      secondDegree_(secondDegree),
      values_(fields * (firstDegree + 1) * (secondDegree + 1)) {}

PairMoments PairMoments::transposed() const {
  PairMoments result(secondDegree_, firstDegree_);
  for (int f = 0; f < fields; ++f) {
    const auto field = static_cast<Field>(f);
    const auto exchanged = field == Field::Direct    ? Field::Reverse
                           : field == Field::Reverse ? Field::Direct
                                                     : field;
    const int sign = field >= Field::Xxx && exchanged == field ? -1 : 1;
    for (int i = 0; i <= firstDegree_; ++i)
      for (int j = 0; j <= secondDegree_; ++j)
        result(exchanged, j, i) = sign * (*this)(field, i, j);
  }
  return result;
}

void PairMoments::add(const std::array<Quad, fields>& values,
                      const std::vector<Quad>& outer, const std::vector<Quad>& inner) {
  for (int i = 0; i <= firstDegree_; ++i)
    for (int j = 0; j <= secondDegree_; ++j) {
      const Quad product = outer[i] * inner[j];
      for (int f = 0; f < fields; ++f)
        (*this)(static_cast<Field>(f), i, j) += values[f] * product;
    }
}

namespace {

/// The Gauss-Legendre rule on [-1, 1] to 33 digits: Newton's method on P_n.
QuadRule quadGauss(int n) {
  QuadRule rule;
  for (int i = 0; i < n; ++i) {
    Quad t = -std::cos(std::acos(-1.0) * (i + 0.75) / (n + 0.5));
    Quad slope;
    for (int step = 0; step < 8; ++step) {  // 1e-4, 1e-8, ... : five would do
      const std::vector<Quad> p = legendre(std::max(n, 1), t);
      slope = n * (t * p[n] - p[n - 1]) / (t * t - 1);
      t -= p[n] / slope;
    }
    rule.points.push_back(t);
    rule.weights.push_back(2 / ((1 - t * t) * slope * slope));
  }
  return rule;
}

}  // namespace

QuadRule doubleExponential(double tolerance) {
  QuadRule rule;
  const double digits = -std::log(tolerance);
  const Quad step = 2.4 / digits;
  const Quad pi = acos(Quad(-1));
  const int count = static_cast<int>(std::asinh(digits / 3) * digits / 2.4) + 1;
  for (int k = -count; k <= count; ++k) {
    const Quad at = 1 / (1 + exp(-pi * sinh(k * step)));
    const Quad rest = 1 / (1 + exp(pi * sinh(k * step)));
    rule.points.push_back(at);
    rule.weights.push_back(step * pi * cosh(k * step) * at * rest);
  }
  return rule;
}

PairIntegrator::PairIntegrator(int largestDegree, double tolerance)
    : degree_(largestDegree),
      tolerance_(tolerance),
      ends_(doubleExponential(tolerance)),
      unit_(largestDegree, largestDegree) {
  const int most = std::max(points(1, 1, degree_), degree_ + 2);
  rules_.resize(1);
  for (int n = 1; n <= most; ++n)
    rules_.push_back(quadGauss(n));
  unit_ = withItself(segment({-1, 0}, {1, 0}), degree_, degree_, degree_ + 2);
  logMaximum_ = tabulateLogMaximum();
}

// log max(s,t) is log s where t < s, and log t elsewhere.
std::vector<Quad> PairIntegrator::tabulateLogMaximum() const {
  std::vector<Quad> table(static_cast<std::size_t>((degree_ + 1) * (degree_ + 1)));
  const QuadRule& exact = rule(degree_ + 2);
  for (std::size_t k = 0; k < ends_.points.size(); ++k) {
    const Quad v = ends_.points[k];
    const std::vector<Quad> p = legendre(degree_, 2 * v - 1);
    for (std::size_t q = 0; q < exact.points.size(); ++q) {
      const std::vector<Quad> below = legendre(degree_, v * (1 + exact.points[q]) - 1);
      const Quad w = ends_.weights[k] * log(v) * exact.weights[q] * v / 2;
      for (int i = 0; i <= degree_; ++i)
        for (int j = 0; j <= degree_; ++j)
          table[at(i, j)] += w * (p[i] * below[j] + below[i] * p[j]);
    }
  }
  return table;
}

// Gauss's rule converges like R^(-2n) for functions analytic in the ellipse of sum R of
// its half axes; a singular point at `distance` is at worst beside the middle: R - 1/R =
// 4 d/L.
int PairIntegrator::points(const Quad& distance, const Quad& length, int degree) const {
  const double q = 2 * static_cast<double>(distance / length);
  const double rate = std::log(q + std::sqrt(1 + q * q));
  return static_cast<int>(
      std::ceil(-std::log(tolerance_) / (2 * rate) + 0.5 * degree + 1));
}

std::array<Quad, fields> PairIntegrator::fieldsAt(const QuadVec& d,
                                                  const Normals& normals) {
  const Quad inverse = 1 / dot(d, d);
  const Quad gx = d.x * inverse;
  const Quad gy = d.y * inverse;
  const Quad xx = d.x * gx;
  const Quad yy = d.y * gy;
  return {-log(inverse) / 2,
          xx,
          d.x * gy,
          xx * gx,
          xx * gy,
          yy * gx,
          yy * gy,
          gx * normals.second.x + gy * normals.second.y,
          -gx * normals.first.x - gy * normals.first.y};
}

PairMoments PairIntegrator::operator()(const QuadCurve& first, int firstDegree,
                                       const QuadCurve& second, int secondDegree,
                                       Meeting meeting) const {
  assert(firstDegree <= degree_ && secondDegree <= degree_);
  const bool straight = first.alpha == 0 && second.alpha == 0;
  if (meeting == Meeting::Same && straight)
    return same(first, firstDegree, secondDegree);
  if (meeting != Meeting::Apart && straight)
    return touching(first, firstDegree, second, secondDegree, meeting);
  if (meeting == Meeting::Same)
    return withItself(first, firstDegree, secondDegree, points(1, 1, degree_));
  PairMoments sum(firstDegree, secondDegree);
  addApart(sum, first, {-1, 1}, second, {-1, 1});
  return sum;
}

PairMoments PairIntegrator::withItself(const QuadCurve& curve, int firstDegree,
                                       int secondDegree, int points) const {
  const int degree = std::max(firstDegree, secondDegree);
  PairMoments half(degree, degree);  // s > t
  const QuadRule& gauss = rule(points);
  for (std::size_t q = 0; q < ends_.points.size(); ++q) {
    const Quad r = 2 * ends_.points[q];
    const Quad scale = (2 - r) / 2;
    for (std::size_t k = 0; k < gauss.points.size(); ++k) {
      const Quad t = -1 + scale * (1 + gauss.points[k]);
      const Quad s = t + r;
      auto values =
          fieldsAt(curve.point(s) - curve.point(t), {curve.normal(s), curve.normal(t)});
      for (Quad& v : values)
        v *= curve.half * curve.half * 2 * ends_.weights[q] * scale * gauss.weights[k];
      half.add(values, legendre(degree, s), legendre(degree, t));
    }
  }
  const PairMoments other = half.transposed();
  PairMoments sum(firstDegree, secondDegree);
  for (int f = 0; f < fields; ++f)
    for (int i = 0; i <= firstDegree; ++i)
      for (int j = 0; j <= secondDegree; ++j) {
        const auto field = static_cast<Field>(f);
        sum(field, i, j) = half(field, i, j) + other(field, i, j);
      }
  return sum;
}

PairMoments PairIntegrator::same(const QuadCurve& segment, int firstDegree,
                                 int secondDegree) const {
  PairMoments result(firstDegree, secondDegree);
  const Quad half = segment.half;
  const QuadVec tau = segment.middleTangent;
  for (int i = 0; i <= firstDegree; ++i)
    for (int j = 0; j <= secondDegree; ++j) {
      const Quad one = i == 0 && j == 0 ? Quad(4) : Quad(0);
      const Quad pole = half * unit_(Field::Xxx, i, j);
      result(Field::LogR, i, j) =
          half * half * (unit_(Field::LogR, i, j) + one * log(half));
      result(Field::Xx, i, j) = half * half * one * tau.x * tau.x;
      result(Field::Xy, i, j) = half * half * one * tau.x * tau.y;
      result(Field::Xxx, i, j) = pole * tau.x * tau.x * tau.x;
      result(Field::Xxy, i, j) = pole * tau.x * tau.x * tau.y;
      result(Field::Xyy, i, j) = pole * tau.x * tau.y * tau.y;
      result(Field::Yyy, i, j) = pole * tau.y * tau.y * tau.y;
    }
  return result;
}

PairMoments PairIntegrator::touching(const QuadCurve& first, int firstDegree,
                                     const QuadCurve& second, int secondDegree,
                                     Meeting meeting) const {
  const bool firstAtStart = meeting == Meeting::FromTo;
  const QuadVec a = ((firstAtStart ? 2 : -2) * first.half) * first.middleTangent;
  const QuadVec b = ((firstAtStart ? -2 : 2) * second.half) * second.middleTangent;
  const Normals normals{first.normal(0), second.normal(0)};

  PairMoments sum(firstDegree, secondDegree);
  addTriangle(sum, a, b, normals, Leader::First);
  addTriangle(sum, a, b, normals, Leader::Second);
  const Quad area = norm(a) * norm(b);
  for (int i = 0; i <= firstDegree; ++i)
    for (int j = 0; j <= secondDegree; ++j) {
      sum(Field::LogR, i, j) += logMaximum_[at(i, j)];
      // so far from the common point on: P_i(2s-1); where that is an end, t = 1-2s
      const bool odd = (firstAtStart ? j : i) % 2 == 1;
      for (int f = 0; f < fields; ++f)
        sum(static_cast<Field>(f), i, j) *= odd ? -area : area;
    }
  return sum;
}

// x = s first, y = t second from the common point, {s, t} = {rho, rho eta}, d = rho D:
// a field is rho⁰ or rho⁻¹ times its value at D(eta), and ds dt = rho drho deta.
void PairIntegrator::addTriangle(PairMoments& sum, const QuadVec& first,
                                 const QuadVec& second, const Normals& normals,
                                 Leader leader) const {
  const QuadVec& lead = leader == Leader::First ? first : second;
  const QuadVec& follow = leader == Leader::First ? second : first;
  const int m = sum.firstDegree();
  const int n = sum.secondDegree();

  const Quad square = dot(follow, follow);
  const Quad foot = dot(lead, follow) / square;
  const Quad height = abs(cross(lead, follow)) / square;
  std::vector<std::array<Quad, 3>> intervals;
  bisect(0, 1, foot, height, intervals);

  const QuadRule& radial = rule((m + n + 1) / 2 + 1);
  for (const auto& [from, to, distance] : intervals) {
    const QuadRule& angular = rule(points(distance, to - from, std::max(m, n)));
    for (std::size_t q = 0; q < angular.points.size(); ++q) {
      const Quad eta = from + (to - from) * (1 + angular.points[q]) / 2;
      const QuadVec d =
          leader == Leader::First ? first - eta * second : eta * first - second;
      auto value = fieldsAt(d, normals);
      for (Quad& v : value)
        v *= angular.weights[q] * (to - from) / 2;
      for (std::size_t r = 0; r < radial.points.size(); ++r) {
        const Quad rho = (1 + radial.points[r]) / 2;
        const Quad s = leader == Leader::First ? rho : rho * eta;
        const Quad t = leader == Leader::First ? rho * eta : rho;
        std::array<Quad, fields> weighted = value;
        for (int f = 0; f < fields; ++f)
          weighted[f] *= radial.weights[r] / 2 *
                         (static_cast<Field>(f) >= Field::Xxx ? Quad(1) : rho);
        sum.add(weighted, legendre(m, 2 * s - 1), legendre(n, 2 * t - 1));
      }
    }
  }
}

void PairIntegrator::addApart(PairMoments& sum, const QuadCurve& first,
                              std::array<Quad, 2> s, const QuadCurve& second,
                              std::array<Quad, 2> t) const {
  const Quad firstLength = first.half * (s[1] - s[0]);
  const Quad secondLength = second.half * (t[1] - t[0]);
  const Quad longer = std::max(firstLength, secondLength);
  const Quad gap =
      norm(first.point((s[0] + s[1]) / 2) - second.point((t[0] + t[1]) / 2)) -
      (firstLength + secondLength) / 2;
  if (gap < longer) {
    if (longer < ldexp(std::min(first.half, second.half), -deepest))
      return;
    const bool halveFirst = firstLength >= secondLength;
    const std::array<Quad, 2>& range = halveFirst ? s : t;
    const Quad middle = (range[0] + range[1]) / 2;
    for (const std::array<Quad, 2>& part :
         {std::array<Quad, 2>{range[0], middle}, std::array<Quad, 2>{middle, range[1]}})
      addApart(sum, first, halveFirst ? part : s, second, halveFirst ? t : part);
    return;
  }

  const int m = sum.firstDegree();
  const int n = sum.secondDegree();
  const QuadRule& outer = rule(points(gap, firstLength, m));
  const QuadRule& inner = rule(points(gap, secondLength, n));
  std::vector<QuadVec> y;
  std::vector<QuadVec> normals;
  std::vector<std::vector<Quad>> weightedLegendre;
  for (std::size_t r = 0; r < inner.points.size(); ++r) {
    const Quad tau = t[0] + (t[1] - t[0]) * (1 + inner.points[r]) / 2;
    y.push_back(second.point(tau));
    normals.push_back(second.normal(tau));
    weightedLegendre.push_back(legendre(n, tau));
    for (Quad& p : weightedLegendre.back())
      p *= inner.weights[r] * secondLength / 2;
  }
  for (std::size_t q = 0; q < outer.points.size(); ++q) {
    const Quad sigma = s[0] + (s[1] - s[0]) * (1 + outer.points[q]) / 2;
    const QuadVec x = first.point(sigma);
    const QuadVec normal = first.normal(sigma);
    PairMoments line(0, n);
    for (std::size_t r = 0; r < y.size(); ++r)
      line.add(fieldsAt(x - y[r], {normal, normals[r]}), {1}, weightedLegendre[r]);
    const std::vector<Quad> p = legendre(m, sigma);
    for (int i = 0; i <= m; ++i) {
      const Quad w = p[i] * outer.weights[q] * firstLength / 2;
      for (int f = 0; f < fields; ++f)
        for (int j = 0; j <= n; ++j)
          sum(static_cast<Field>(f), i, j) += w * line(static_cast<Field>(f), 0, j);
    }
  }
}

}  // namespace epafi::reference
