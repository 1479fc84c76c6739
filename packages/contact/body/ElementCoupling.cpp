#include "contact/body/ElementCoupling.hpp"

#include "bem/basis/Legendre.hpp"
#include "bem/quadrature/Gauss.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace epafi::contact {

using bem::Element;
using bem::Rule;
using bem::Vec2;
using ContactElement = MultiplierSpace::ContactElement;

namespace {

/// Column i: the coefficients of χ_i in the orthonormal Legendre polynomials on the
/// element.
Matrix orthonormalCoefficients(const MultiplierBasis& basis, const Element& element) {
  const int p = element.degree;
  const Rule& rule = bem::gaussLegendre(p + 1);
  Matrix coefficients(p + 1, p + 1);
  std::array<double, bem::largestDegree + 1> legendre{};
  for (int q = 0; q < rule.size(); ++q) {
    const Vector chi = basis.values(p, rule.points[q]);
    bem::legendreValues(p, rule.points[q], legendre.data());
    for (int i = 0; i <= p; ++i)
      for (int k = 0; k <= p; ++k)
        coefficients(k, i) += rule.weights[q] *
                              std::sqrt(element.half * (2 * k + 1) / 2) * legendre[k] *
                              chi[i];
  }
  return coefficients;
}

/// Column k: the coefficients of φ_k in the same polynomials.
Matrix displacementCoefficients(const Element& element) {
  Matrix coefficients = bem::DisplacementBasis::legendreCoefficients(element.degree);
  for (Index k = 0; k < coefficients.columns(); ++k)
    for (Index i = 0; i < coefficients.rows(); ++i)
      coefficients(i, k) *=
          std::sqrt(2 * element.half / (2 * static_cast<double>(i) + 1));
  return coefficients;
}

/// Adds the coefficients of one element.
class CouplingWriter {
 public:
  CouplingWriter(const bem::Space& space, const MultiplierSpace& multiplier,
                 std::size_t k, bool density, Coupling& coupling)
      : space_(space),
        basis_(multiplier.basis()),
        contact_(multiplier.elements()[k]),
        element_(space.mesh()[contact_.element]),
        gamma_(coupling.gamma[k]),
        firstTraction_(coupling.start[k]),
        density_(density),
        coupling_(coupling) {}

  void write() const {
    if (!element_.curve.isStraight())
      return writeArc();
    const Vec2 normal = element_.segment().normal;
    writeDirection(&ContactElement::normalOf, contact_.normalCompletions, normal);
    if (contact_.tangential >= 0)
      writeDirection(&ContactElement::tangentialOf, contact_.tangentialCompletions,
                     turnLeft(normal));
  }

 private:
  using Numbering = Index (ContactElement::*)(int) const;
  using Completions = std::array<EndCompletion, 2>;

  void writeDirection(Numbering number, const Completions& completions,
                      Vec2 direction) const {
    const int p = element_.degree;
    const Matrix chi = orthonormalCoefficients(basis_, element_);
    const Matrix phi = displacementCoefficients(element_);
    const double components[2] = {direction.x, direction.y};
    for (int i = 0; i <= p; ++i) {
      const Index column = (contact_.*number)(i);
      for (int k = 0; k <= p; ++k) {
        double product = 0;
        double mass = 0;
        for (int l = 0; l <= p; ++l) {
          product += chi(l, i) * phi(l, k);
          mass += chi(l, i) * chi(l, k);
        }
        for (int c = 0; c < 2; ++c)
          writeTrace(space_.displacement(contact_.element, k, c), column,
                     components[c] * product, completionOf(completions, i, p));
        if (gamma_ > 0)
          coupling_.mass.push_back({column, (contact_.*number)(k), gamma_ * mass});
      }
      writeWeights(column, std::min(p + 1, terms()), [&](double factor, int l, int c) {
        return factor * chi(l, i) * components[c];
      });
    }
  }

  /// The columns of the element's tractions, or its densities, by components.
  int terms() const { return density_ ? element_.densities : element_.degree + 1; }

  /// A coefficient in a direction that turns.
  struct Turning {
    Index column;
    const EndCompletion* completion;
    bool tangential;
    int function;
  };

  std::vector<Turning> turning() const {
    std::vector<Turning> result;
    const int p = contact_.degree;
    for (const bool tangential : {false, true})
      for (int i = 0; i <= p && (!tangential || contact_.tangential >= 0); ++i)
        result.push_back({tangential ? contact_.tangentialOf(i) : contact_.normalOf(i),
                          completionOf(tangential ? contact_.tangentialCompletions
                                                  : contact_.normalCompletions,
                                       i, p),
                          tangential, i});
    return result;
  }

  /// A Gauss point of an arc, and what functions are there.
  struct ArcPoint {
    double weight = 0;
    Vec2 directions[2];  ///< normal, tangent
    Vec2 rest;           ///< r - r_I
    Vector chi;
    std::array<double, bem::largestDegree + 1> phi{};
    std::array<double, bem::largestDegree + 2> legendre{};
  };

  std::vector<ArcPoint> arcPoints() const {
    const int p = element_.degree;
    const Rule& rule = bem::gaussLegendre(p + bem::pointsOfTurning);
    std::vector<ArcPoint> points(rule.points.size());
    for (std::size_t q = 0; q < points.size(); ++q) {
      const double t = rule.points[q];
      ArcPoint& point = points[q];
      point.weight = element_.half * rule.weights[q];
      point.directions[0] = element_.curve.normal(t);
      point.directions[1] = element_.curve.tangent(t);
      point.rest = space_.rotationRest(contact_.element, t);
      point.chi = basis_.values(p, t);
      bem::DisplacementBasis::values(p, t, point.phi.data());
      bem::legendreValues(terms() - 1, t, point.legendre.data());
    }
    return points;
  }

  /// Of χ_i d.
  struct ArcMoments {
    Matrix traces;    ///< ∫ χ_i d·φ_k, displacement functions x components
    Matrix parts;     ///< orthonormal polynomials x components
    double rest = 0;  ///< ∫ χ_i d·(r - r_I)
  };

  ArcMoments momentsOf(const Turning& unknown,
                       const std::vector<ArcPoint>& points) const {
    ArcMoments moments{Matrix(element_.degree + 1, 2), Matrix(terms(), 2)};
    for (const ArcPoint& point : points) {
      const Vec2 direction = point.directions[unknown.tangential ? 1 : 0];
      const double value = point.weight * point.chi[unknown.function];
      const double components[2] = {value * direction.x, value * direction.y};
      for (Index c = 0; c < 2; ++c) {
        for (Index k = 0; k < moments.traces.rows(); ++k)
          moments.traces(k, c) += components[c] * point.phi[k];
        for (Index l = 0; l < moments.parts.rows(); ++l)
          moments.parts(l, c) +=
              components[c] * point.legendre[l] *
              std::sqrt((2 * static_cast<double>(l) + 1) / (2 * element_.half));
      }
      moments.rest += value * dot(direction, point.rest);
    }
    return moments;
  }

  /// ∫ χ_i χ_k in one direction.
  static double massOf(const Turning& a, const Turning& b,
                       const std::vector<ArcPoint>& points) {
    double mass = 0;
    for (const ArcPoint& point : points)
      if (a.tangential == b.tangential)
        mass += point.weight * point.chi[a.function] * point.chi[b.function];
    return mass;
  }

  static double product(const Matrix& a, const Matrix& b) {
    double sum = 0;
    for (Index l = 0; l < a.rows(); ++l)
      for (Index c = 0; c < 2; ++c)
        sum += a(l, c) * b(l, c);
    return sum;
  }

  // All by Gauss points.  Where S u is projected on orthonormal polynomials, so is λ: M is the
  // product of what is left.
  void writeArc() const {
    const std::vector<ArcPoint> points = arcPoints();
    const std::vector<Turning> unknowns = turning();
    std::vector<ArcMoments> all;
    all.reserve(unknowns.size());
    for (const Turning& unknown : unknowns)
      all.push_back(momentsOf(unknown, points));
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      const Turning& unknown = unknowns[i];
      const ArcMoments& own = all[i];
      for (Index k = 0; k < own.traces.rows(); ++k)
        for (int c = 0; c < 2; ++c)
          writeTrace(space_.displacement(contact_.element, static_cast<int>(k), c),
                     unknown.column, own.traces(k, c), unknown.completion);
      writeRest(unknown.column, own.rest, unknown.completion);
      for (std::size_t k = 0; gamma_ != 0 && k < unknowns.size(); ++k)
        coupling_.mass.push_back(
            {unknown.column, unknowns[k].column,
             gamma_ * (density_ ? massOf(unknown, unknowns[k], points)
                                : product(own.parts, all[k].parts))});
      writeWeights(unknown.column, terms(),
                   [&](double factor, int l, int c) { return factor * own.parts(l, c); });
    }
  }

  /// S φ by orthonormal polynomials, densities by Legendre's: times(factor, polynomial,
  /// component) of each.
  template <class Times>
  void writeWeights(Index column, int count, const Times& times) const {
    for (int l = 0; gamma_ != 0 && l < count; ++l) {
      const double norm = density_ ? std::sqrt(2 * element_.half / (2 * l + 1)) : 1;
      for (int c = 0; c < 2; ++c)
        coupling_.weights.push_back(
            {firstTraction_ + 2 * l + c, column, times(gamma_ * norm, l, c)});
    }
  }

  void writeRest(Index column, double value, const EndCompletion* completion) const {
    const bool clamped = completion != nullptr && completion->clamped;
    Vector& rests = clamped ? coupling_.completionOfRotation : coupling_.traceOfRotation;
    rests[column] += value;
    if (completion != nullptr)
      for (const auto& [k, factor] : completion->added)
        coupling_.completionOfRotation[k] += factor * value;
  }

  static const EndCompletion* completionOf(const Completions& completions, int i, int p) {
    return i == 0 ? &completions[0] : i == p ? &completions[1] : nullptr;
  }

  void writeTrace(Index row, Index column, double value,
                  const EndCompletion* completion) const {
    const bool clamped = completion != nullptr && completion->clamped;
    (clamped ? coupling_.completion : coupling_.trace).push_back({row, column, value});
    if (completion != nullptr)
      for (const auto& [k, factor] : completion->added)
        coupling_.completion.push_back({row, k, factor * value});
  }

  const bem::Space& space_;
  const MultiplierBasis& basis_;
  const ContactElement& contact_;
  const Element& element_;
  double gamma_;
  Index firstTraction_;
  bool density_;
  Coupling& coupling_;
};

}  // namespace

void addElement(const bem::Space& space, const MultiplierSpace& multiplier, std::size_t k,
                bool byDensity, Coupling& coupling) {
  CouplingWriter(space, multiplier, k, byDensity, coupling).write();
}

}  // namespace epafi::contact
