#include "bem/moments/ArcWeights.hpp"

#include "bem/base/Error.hpp"
#include "bem/moments/LegendreMoments.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::bem {

namespace {

static_assert(ArcRule::largestSize <= longestSeries + 1);

/// log |z + √(z²-1)| of a real z > 1.
double logRadius(double z) { return std::acosh(std::max(z, 1.0 + 1e-3)); }

/// Terms by which 1/g falls below 1e-15: its poles are the places of the target on other
/// turns of the circle, farther than π/α.
int termsOfFactor(double alpha) {
  constexpr double digits = 35;
  return alpha == 0 ? 1
                    : static_cast<int>(digits / logRadius(3.14159 / std::abs(alpha))) + 2;
}

/// Table[q * n + k] = (k + 1/2) w_q P_k(t_q) of the rule with n points, by n.
const std::vector<double>& coefficientTable(int n) {
  static const std::vector<std::vector<double>> tables = [] {
    std::vector<std::vector<double>> made(ArcRule::largestSize + 1);
    for (int size = 1; size <= ArcRule::largestSize; ++size) {
      const Rule& rule = gaussLegendre(size);
      const auto terms = static_cast<std::size_t>(size);
      std::vector<double>& table = made[terms];
      table.resize(terms * terms);
      for (std::size_t q = 0; q < terms; ++q) {
        legendreValues(size - 1, rule.points[q], table.data() + q * terms);
        for (std::size_t k = 0; k < terms; ++k)
          table[q * terms + k] *= (static_cast<double>(k) + 0.5) * rule.weights[q];
      }
    }
    return made;
  }();
  return tables[n];
}

/// So far off that the Gauss rule itself does: error R^-(2n - degree).
bool isFar(const ArcRule& rule, const RelativeTarget& x) {
  constexpr double digits = 37;
  const double focal = 0.5 * (std::abs(x.zMinus1) + std::abs(x.zPlus1));
  return focal > 1.5 && (2 * rule.size() - rule.degree()) * logRadius(focal) > digits;
}

/// ∫ P_k log|z-t| dt where z is an end.
void endLogarithms(bool atStart, int last, LongLegendreMoments& m) {
  m.l[0] = 2 * std::log(2.0) - 2;
  for (int k = 1; k <= last; ++k) {
    const double limit = -2.0 / (k * (k + 1.0));
    m.l[k] = atStart && k % 2 == 1 ? -limit : limit;
  }
}

}  // namespace

ArcRule::ArcRule(const Curve& curve, int degree) : curve_(curve), degree_(degree) {
  if (std::abs(curve.angle()) > largestAngle)
    throw InputError("an element turns by more than half a circle");
  const int terms = degree + termsOfFactor(0.5 * curve.angle());
  rule_ = &gaussLegendre(std::min(terms, largestSize));
  legendre_.resize(at(size(), 0));
  for (int q = 0; q < size(); ++q) {
    legendreValues(degree, point(q), legendre_.data() + at(q, 0));
    tangents_.push_back(asComplex(curve.tangent(point(q))));
  }
}

void ArcWeights::evaluate(const ArcRule& rule, const RelativeTarget& x, ArcNeed need) {
  const int n = rule.size();
  const bool potentials = need != ArcNeed::Sums;
  const bool sums = need != ArcNeed::Potentials;
  const bool atStart = x.zPlus1 == 0.0;
  const bool atEnd = x.zMinus1 == 0.0;
  const bool closed = !isFar(rule, x);
  const Complex z = x.z();
  const Complex turn(0, 2 * x.b());
  LongLegendreMoments m;
  if (atStart || atEnd)
    endLogarithms(atStart, n - 1, m);
  else if (closed)
    evaluateMoments(x, n - 1, sums ? (potentials ? Need::All : Need::CandD) : Need::CandL,
                    m);
  const std::vector<double>& table = coefficientTable(n);
  for (int q = 0; q < n; ++q) {
    const auto k = static_cast<std::size_t>(q);
    const Complex g = rule.curve().factor(x, rule.point(q));
    const Complex conj = std::conj(g);
    const double weight = rule.weight(q);
    Complex first = 0;   // of f/(z-t)
    Complex second = 0;  // of f/(z-t)²
    double logarithm = 0;
    if (closed) {
      const double* row = table.data() + k * static_cast<std::size_t>(n);
      for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
        first += row[i] * m.c[i];
        second += row[i] * m.d[i];
        logarithm += row[i] * m.l[i];
      }
    } else {
      const Complex inverse = 1.0 / (z - rule.point(q));
      first = weight * inverse;
      second = first * inverse;
      logarithm = -weight * std::log(std::abs(inverse));
    }
    overW[k] = std::conj(first / conj);
    if (potentials) {
      log[k] = logarithm + weight * std::log(std::abs(g));
      phase[k] = (weight - turn * first) * (g / conj);
    }
    if (sums)  // on the arc b = 0, and the second need not exist
      cubic[k] = (x.b() == 0 ? first : first - turn * second) * g / (conj * conj);
  }
}

}  // namespace epafi::bem
