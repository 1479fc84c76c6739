#include "bem/moments/RingRules.hpp"

#include "bem/quadrature/Gauss.hpp"
#include "bem/quadrature/MadeOnce.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi::bem {

namespace {

/// A part of an element.
struct Part {
  int e;
  const Element* element;
  double start = -1;
  double end = 1;

  const Curve& curve() const { return element->curve; }
  double size() const { return end - start; }
  double length() const { return element->half * size(); }
  double middle() const { return 0.5 * (start + end); }
  double radius(double t) const {
    return curve().frame().middle.x + curve().fromMiddle(t).x;
  }
  double smallestRadius() const { return std::min(radius(start), radius(end)); }
  Part first() const { return {e, element, start, middle()}; }
  Part second() const { return {e, element, middle(), end}; }
  /// y(t) - y(s) from t - s and t + s.
  Vec2 chord(double difference, double sum) const {
    const double turn = 0.25 * curve().angle() * difference;
    const double sinc = turn == 0 ? 1 : std::sin(turn) / turn;
    return curve().half() * difference * sinc * curve().tangent(0.5 * sum);
  }
};

/// Points of the unit square for functions that are singular at a = 0.
struct Softened {
  struct Point {
    double a;
    double b;
    double weight;
  };
  std::vector<Point> points;
};

constexpr int smoothOrders = 64;

constexpr double digits = 32.2;  // 1e-14

int softenedOrder(int degree) { return 27 + 4 * (degree - 1); }

/// Of a degree times smoothOrders, plus the number of points in the smooth direction.
Softened makeSoftened(int key) {
  constexpr int power = 7;
  const Rule& g = gaussLegendre(softenedOrder(key / smoothOrders));
  const Rule& h = gaussLegendre(key % smoothOrders);
  Softened rule;
  for (int i = 0; i < g.size(); ++i)
    for (int j = 0; j < h.size(); ++j) {
      const double u = 0.5 * (1 + g.points[at(i)]);
      rule.points.push_back(
          {std::pow(u, power), 0.5 * (1 + h.points[at(j)]),
           0.25 * g.weights[at(i)] * h.weights[at(j)] * power * std::pow(u, power - 1)});
    }
  return rule;
}

const Softened& softened(int degree, int smooth) {
  static MadeOnce<Softened, (largestDegree + 2) * smoothOrders> rules(makeSoftened);
  return rules[degree * smoothOrders + smooth];
}

/// Which ends of two parts are one point.
enum class Touching { No, EndOfX, StartOfX, Both };

class Pair {
 public:
  Pair(const Mesh& mesh, int e, int f, int more, std::vector<RingPoints>& to)
      : mesh_(mesh),
        x_{e, &mesh[e]},
        y_{f, &mesh[f]},
        offset_(e == f ? Vec2{} : mesh.offset(e, f)),
        degree_(std::min(std::max({x_.element->degree, x_.element->densities,
                                   y_.element->degree, y_.element->densities}) +
                             more,
                         largestDegree)),
        to_(to) {
    to_.clear();
    if (e == f)
      same(x_);
    else
      pair(x_, y_);
    fill();
  }

 private:
  void add(double t, double s, Vec2 w, double weight) {
    const auto lane = static_cast<int>(count_++ % lanes);
    if (lane == 0)
      to_.emplace_back();
    put(lane, t, s, w, weight);
  }

  void put(int lane, double t, double s, Vec2 w, double weight) {
    RingPoints& points = to_.back();
    points.t.lane[lane] = t;
    points.s.lane[lane] = s;
    points.weight.lane[lane] = weight;
    points.w.set(lane, asComplex(w));
  }

  /// Fills the last lanes with harmless points.
  void fill() {
    const auto last = static_cast<int>((count_ - 1) % lanes);
    const RingPoints& points = to_.back();
    for (int lane = last + 1; lane < lanes; ++lane)
      put(lane, points.t.lane[last], points.s.lane[last], asVector(points.w[at(last)]),
          0);
  }

  int smooth(double turn) const { return degree_ + 12 + static_cast<int>(3 * turn); }

  void same(const Part& part) {
    constexpr double tiny = 1e-13;
    constexpr double nearAxis = 0.7;
    const bool startsInside = part.radius(part.start) < part.radius(part.end);
    const double size = part.size();
    const int order = smooth(std::abs(part.curve().angle()));
    if (part.smallestRadius() < tiny * part.element->half) {  // it ends on the axis
      for (const auto& [a, b, weight] : softened(degree_, order + 4).points) {
        const double far = b * size;
        const double distance = far * a;
        const double t = startsInside ? part.start + far : part.end - far;
        const double s =
            startsInside ? part.start + (far - distance) : part.end - (far - distance);
        addBoth(t, s, part.chord(startsInside ? distance : -distance, t + s),
                weight * b * size * size);
      }
      return;
    }
    if (part.smallestRadius() < nearAxis * part.length()) {
      const Part halves[] = {part.first(), part.second()};
      for (const Part& x : halves)
        for (const Part& y : halves)
          if (x.start == y.start)
            same(x);
          else
            pair(x, y);
      return;
    }
    for (const auto& [a, b, weight] : softened(degree_, order).points) {
      const double distance = size * a;
      const double s = part.start + (size - distance) * b;
      addBoth(s + distance, s, part.chord(distance, 2 * s + distance),
              weight * size * (size - distance));
    }
  }

  void addBoth(double t, double s, Vec2 w, double weight) {
    add(t, s, w, weight);
    add(s, t, -w, weight);
  }

  Touching touching(const Part& x, const Part& y) const {
    const auto meets = [&](const Part& first, const Part& second) {
      return first.e == second.e ? first.end == second.start
                                 : first.end == 1 && second.start == -1 &&
                                       mesh_[first.e].next == second.e;
    };
    const bool end = meets(x, y);
    const bool start = meets(y, x);
    return end && start ? Touching::Both
           : end        ? Touching::EndOfX
           : start      ? Touching::StartOfX
                        : Touching::No;
  }

  void pair(const Part& x, const Part& y) {
    const Touching how = touching(x, y);
    if (how == Touching::Both)
      return halve(x, y, true);
    if (how == Touching::No)
      return apart(x, y);
    constexpr double alike = 1.6;
    constexpr double nearAxis = 0.6;
    constexpr double nearImage = 1.2;
    const double longer = std::max(x.length(), y.length());
    const bool atEnd = how == Touching::EndOfX;
    if (longer > alike * std::min(x.length(), y.length()) ||
        x.radius(atEnd ? x.end : x.start) < nearAxis * longer ||
        (x.e != y.e && beyondAxis(x, y, atEnd) < nearImage * longer))
      return halve(x, y, x.length() >= y.length());
    const int order =
        4 + smooth(std::max(std::abs(x.curve().angle()), std::abs(y.curve().angle())));
    const double angle = smallestOpening(x, y, atEnd);
    for (const bool isFarther : {false, true}) {
      const double ratio = isFarther ? x.length() / y.length() : y.length() / x.length();
      for (const auto& [start, size] : aroundPole(std::polar(ratio, angle), order))
        for (const auto& [a, inside, weight] : softened(degree_, order).points) {
          const double b = start + size * inside;
          const BehindNode at =
              behindNode(x, y, atEnd, (isFarther ? a : a * b) * x.size(),
                         (isFarther ? a * b : a) * y.size());
          add(at.t, at.s, at.w, size * weight * a * x.size() * y.size());
        }
    }
  }

  /// From the farther end of x to that of y behind the axis.
  double beyondAxis(const Part& x, const Part& y, bool atEnd) const {
    const double t = atEnd ? x.start : x.end;
    const double s = atEnd ? y.end : y.start;
    return std::hypot(x.radius(t) + y.radius(s), difference(x, y, t, s).y);
  }

  struct BehindNode {
    double t;
    double s;
    Vec2 w;
  };

  /// At distances from the common node, in parameters.
  static BehindNode behindNode(const Part& x, const Part& y, bool atEnd, double a,
                               double b) {
    const double t = atEnd ? x.end - a : x.start + a;
    const double s = atEnd ? y.start + b : y.end - b;
    const double hx = x.element->half;
    const double hy = y.element->half;
    const Vec2 w = x.e == y.e ? x.chord(atEnd ? -(a + b) : a + b, t + s)
                   : atEnd    ? x.curve().fromEnd(-a * hx) - y.curve().fromStart(b * hy)
                              : x.curve().fromStart(a * hx) - y.curve().fromEnd(-b * hy);
    return {t, s, w};
  }

  /// The smallest angle under which the common node sees points that are equally far from it.
  static double smallestOpening(const Part& x, const Part& y, bool atEnd) {
    constexpr double atNode = 1e-3;  // of the shorter one
    double sine = 1;                 // of half of it
    for (const double share : {atNode, 0.25, 0.5, 0.75, 1.0}) {
      const double distance = share * std::min(x.length(), y.length());
      const Vec2 w =
          behindNode(x, y, atEnd, distance / x.element->half, distance / y.element->half)
              .w;
      sine = std::min(sine, length(w) / (2 * distance));
    }
    return 2 * std::asin(sine);
  }

  struct Panel {
    double start;
    double size;
  };
  /// Of [0, 1], for so many Gauss points and a function with a pole: one but for sharp wedges, where x
  /// and y run beside each other.
  static std::vector<Panel> aroundPole(Complex pole, int order) {
    constexpr double narrowest = 1e-6;
    std::vector<Panel> panels;
    std::vector<Panel> left = {{0, 1}};
    while (!left.empty()) {
      const auto [start, size] = left.back();
      left.pop_back();
      const Complex z = 2.0 * (pole - start) / size - 1.0;
      const Complex root = std::sqrt(z * z - 1.0);
      const double growth = std::log(std::max(std::abs(z + root), std::abs(z - root)));
      if (2 * order * growth >= digits || size < narrowest) {
        panels.push_back({start, size});
        continue;
      }
      left.push_back({start + 0.5 * size, 0.5 * size});
      left.push_back({start, 0.5 * size});
    }
    return panels;
  }

  void halve(const Part& x, const Part& y, bool isX) {
    if (isX) {
      pair(x.first(), y);
      pair(x.second(), y);
    } else {
      pair(x, y.first());
      pair(x, y.second());
    }
  }

  Vec2 difference(const Part& x, const Part& y, double t, double s) const {
    return x.e == y.e ? x.chord(t - s, t + s)
                      : offset_ + x.curve().fromMiddle(t) - y.curve().fromMiddle(s);
  }

  /// Gauss points on a part whose distance is known from the ends of the other one.
  int order(const Part& own, const Part& other, bool isX) const {
    constexpr int samples = 8;
    const auto from = [&](double t, double s) {
      return length(isX ? difference(own, other, t, s) : difference(other, own, s, t));
    };
    double z = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= samples; ++k) {
      const double s = other.start + other.size() * k / samples;
      z = std::min(z, from(own.start, s) + from(own.end, s));
    }
    const double chord = length(own.chord(own.size(), own.start + own.end));
    z /= chord;
    if (z < 1.0001)
      return 1000;
    const double growth = std::log(z + std::sqrt(z * z - 1));
    return static_cast<int>(std::ceil(0.5 * digits / growth)) + degree_ / 2 + 2 +
           static_cast<int>(std::abs(own.curve().angle()) * own.size());
  }

  void apart(const Part& x, const Part& y) {
    const int nx = order(x, y, true);
    const int ny = order(y, x, false);
    const int most = 22 + degree_ / 2;
    if (std::max(nx, ny) > most)
      return halve(x, y, nx == ny ? x.length() >= y.length() : nx > ny);
    const Rule& g = gaussLegendre(nx);
    const Rule& h = gaussLegendre(ny);
    for (int i = 0; i < nx; ++i)
      for (int j = 0; j < ny; ++j) {
        const double t = x.middle() + 0.5 * x.size() * g.points[at(i)];
        const double s = y.middle() + 0.5 * y.size() * h.points[at(j)];
        add(t, s, difference(x, y, t, s),
            0.25 * x.size() * y.size() * g.weights[at(i)] * h.weights[at(j)]);
      }
  }

  const Mesh& mesh_;
  Part x_;
  Part y_;
  Vec2 offset_;
  int degree_;
  std::vector<RingPoints>& to_;
  std::size_t count_ = 0;
};

}  // namespace

void nearRingPoints(const Mesh& mesh, int e, int f, int more,
                    std::vector<RingPoints>& to) {
  Pair(mesh, e, f, more, to);
}

}  // namespace epafi::bem
