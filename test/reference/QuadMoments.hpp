#pragma once

#include <array>
#include <boost/multiprecision/float128.hpp>
#include <vector>

namespace epafi::reference {

/// A number of 33 digits.
using Quad = boost::multiprecision::float128;

struct QuadVec {
  Quad x;
  Quad y;
};

QuadVec operator+(const QuadVec& a, const QuadVec& b);
QuadVec operator-(const QuadVec& a, const QuadVec& b);
QuadVec operator*(const Quad& s, const QuadVec& a);
Quad dot(const QuadVec& a, const QuadVec& b);
/// P_0 to P_degree.
std::vector<Quad> legendre(int degree, const Quad& t);

/// A segment or an arc, from t = -1 to t = 1.
struct QuadCurve {
  QuadVec from;
  QuadVec middleTangent;
  Quad half;       ///< of its length
  Quad alpha = 0;  ///< half of the angle by which it turns

  QuadVec point(const Quad& t) const;
  QuadVec tangent(const Quad& t) const;
  QuadVec normal(const Quad& t) const;
};

QuadCurve segment(const QuadVec& from, const QuadVec& to);

/// How the second of two curves meets the first, which is known from the mesh and need
/// not be guessed from coordinates.  `ToFrom`: the end of the first is the start of the second.
enum class Meeting { Apart, Same, FromTo, ToFrom };

/// Seven fields of d = x - y, r = |d|, of which all kernels of plane elasticity are made, and
/// d.n(y)/r², -d.n(x)/r².
enum class Field { LogR, Xx, Xy, Xxx, Xxy, Xyy, Yyy, Direct, Reverse };
constexpr int fields = 9;

/// The double integrals  ∫∫ P_i(x) P_j(y) field(x - y) ds_y ds_x  over two curves:
/// log r,  dd'/r²  (xx, xy),  ddd/r⁴  (xxx, xxy, xyy, yyy) and d.n/r², all i and j of one pair at
/// once.
class PairMoments {
 public:
  PairMoments(int firstDegree, int secondDegree);

  Quad& operator()(Field f, int i, int j) { return values_[at(f, i, j)]; }
  const Quad& operator()(Field f, int i, int j) const { return values_[at(f, i, j)]; }

  int firstDegree() const { return firstDegree_; }
  int secondDegree() const { return secondDegree_; }

  /// Adds values of the fields times P_i(x) P_j(y).
  void add(const std::array<Quad, fields>& values, const std::vector<Quad>& outer,
           const std::vector<Quad>& inner);

  /// The moments with the two curves exchanged: d changes its sign.
  PairMoments transposed() const;

 private:
  std::size_t at(Field f, int i, int j) const {
    return static_cast<std::size_t>(
        (static_cast<int>(f) * (firstDegree_ + 1) + i) * (secondDegree_ + 1) + j);
  }

  int firstDegree_;
  int secondDegree_;
  std::vector<Quad> values_;
};

struct QuadRule {
  std::vector<Quad> points;
  std::vector<Quad> weights;
};

/// On [0, 1], for functions with a logarithm at 0: the trapezoidal rule in x, where the place is
/// 1 / (1 + exp(-π sinh x)).
QuadRule doubleExponential(double tolerance);

/// Computes PairMoments by plain quadrature in 33 digits: slow, simple, and nothing in
/// common with the closed forms under test.
///
///   same      over s - t by a double exponential rule, for what has a logarithm or, of both signs
///             together, a pole at 0; segments once for all;
///   touching  segments: s = rho, t = rho eta and the other triangle: polynomials in rho (exact
///             rules), so that one integral over eta is left, bisected until it keeps off the
///             point where the two lines meet again in complex numbers;
///   apart     both are bisected until each pair of pieces is at least as far apart as the
///             longer one is long; then tensor Gauss with as many points as the ellipse of
///             analyticity asks for.  Arcs that touch, too: what is left next to a common
///             point is below 1e-14 of the shorter one.
class PairIntegrator {
 public:
  /// `tolerance` is the relative error that the number of points is chosen for.
  PairIntegrator(int largestDegree, double tolerance);

  PairMoments operator()(const QuadCurve& first, int firstDegree, const QuadCurve& second,
                         int secondDegree, Meeting meeting) const;

 private:
  /// At the places of both.
  struct Normals {
    QuadVec first;
    QuadVec second;
  };
  static std::array<Quad, fields> fieldsAt(const QuadVec& d, const Normals& normals);
  PairMoments same(const QuadCurve& segment, int firstDegree, int secondDegree) const;
  /// \param points  of Gauss's rule along the curve
  PairMoments withItself(const QuadCurve& curve, int firstDegree, int secondDegree,
                         int points) const;
  PairMoments touching(const QuadCurve& first, int firstDegree, const QuadCurve& second,
                       int secondDegree, Meeting meeting) const;
  enum class Leader { First, Second };  // the one whose parameter is rho
  /// \param first, second  from the common point on
  void addTriangle(PairMoments& sum, const QuadVec& first, const QuadVec& second,
                   const Normals& normals, Leader leader) const;
  void addApart(PairMoments& sum, const QuadCurve& first, std::array<Quad, 2> s,
                const QuadCurve& second, std::array<Quad, 2> t) const;
  int points(const Quad& distance, const Quad& length, int degree) const;
  const QuadRule& rule(int n) const { return rules_[n]; }
  std::vector<Quad> tabulateLogMaximum() const;
  std::size_t at(int i, int j) const {
    return static_cast<std::size_t>(i * (degree_ + 1) + j);
  }

  int degree_;
  double tolerance_;
  std::vector<QuadRule> rules_;  // by number of points
  QuadRule ends_;
  PairMoments unit_;              // of the segment from -1 to 1 with itself
  std::vector<Quad> logMaximum_;  // ∫∫ P_i(2s-1) P_j(2t-1) log max(s,t)  on [0,1]²
};

}  // namespace epafi::reference
