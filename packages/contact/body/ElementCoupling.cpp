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

/// Adds what one element has.
class CouplingWriter {
 public:
  CouplingWriter(const bem::Space& space, const MultiplierBasis& basis, bool density,
                 Coupling& coupling)
      : space_(space), basis_(basis), density_(density), coupling_(coupling) {}

  void write(const ContactElement& contact, double gamma, Index firstTraction) const {
    const Element& element = space_.mesh()[contact.element];
    const std::vector<Turning> unknowns = turningOf(contact);
    const Integrals integrals = integralsOf(contact, unknowns);
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      const Turning& unknown = unknowns[i];
      for (Index k = 0; k <= element.degree; ++k)
        for (int c = 0; c < 2; ++c)
          writeTrace(space_.displacement(contact.element, static_cast<int>(k), c),
                     unknown.column, integrals.traces[i](k, c), unknown.completion);
      writeRest(unknown.column, integrals.rests[i], unknown.completion);
      if (gamma == 0)
        continue;
      writeMass(element, unknowns, i, gamma, integrals);
      for (int l = 0; l < terms(element); ++l) {
        for (int c = 0; c < 2; ++c)
          coupling_.weights.push_back(
              {firstTraction + 2 * l + c, unknown.column,
               gamma * normOf(element, l) * integrals.parts[i](l, c)});
      }
    }
  }

  /// Adds the moments of a traction on an element in λ's place.
  void addMoments(const ContactElement& contact, double gamma, Index firstRow,
                  const ParticularSolution& inside, TractionMoments& moments) const {
    const bem::Mesh& mesh = space_.mesh();
    const Element& element = mesh[contact.element];
    const std::vector<Turning> unknowns = turningOf(contact);
    const Rule& rule = bem::gaussForGiven(element.degree);
    Matrix parts(terms(element), 2);
    for (int q = 0; q < rule.size(); ++q) {
      const double t = rule.points[q];
      const Vec2 traction =
          element.half * rule.weights[q] * inside.traction(mesh, contact.element, t);
      addOuter(traction, orthonormal(element, t).data(), parts);
      const Vector chi = basis_.values(element.degree, t);
      for (const Turning& unknown : unknowns)
        if (isWhole(element))
          moments.multipliers[at(unknown.column)] +=
              gamma * chi[at(unknown.function)] *
              dot(traction, unknown.tangential ? element.curve.tangent(t)
                                               : element.curve.normal(t));
    }
    if (!isWhole(element)) {
      const Integrals integrals = integralsOf(contact, unknowns);
      for (std::size_t i = 0; i < unknowns.size(); ++i)
        moments.multipliers[at(unknowns[i].column)] +=
            gamma * product(integrals.parts[i], parts);
    }
    for (int l = 0; l < terms(element); ++l)
      for (int c = 0; c < 2; ++c)
        moments.weights[at(firstRow + 2 * l + c)] =
            gamma * normOf(element, l) * parts(l, c);
  }

 private:
  using Completions = std::array<EndCompletion, 2>;

  /// Legendre polynomials on an element, orthonormal, and what one of them is multiplied by to be
  /// that of G's row.
  std::array<double, bem::largestDegree + 2> orthonormal(const Element& element,
                                                         double t) const {
    std::array<double, bem::largestDegree + 2> legendre{};
    bem::legendreValues(terms(element) - 1, t, legendre.data());
    for (int l = 0; l < terms(element); ++l)
      legendre[l] *= std::sqrt((2 * static_cast<double>(l) + 1) / (2 * element.half));
    return legendre;
  }
  double normOf(const Element& element, int l) const {
    return density_ ? std::sqrt(2 * element.half / (2 * l + 1)) : 1;
  }

  /// The columns of an element's tractions, or its densities, by components.
  int terms(const Element& element) const {
    return density_ ? element.densities : element.degree + 1;
  }

  /// A coefficient of an element, in a direction that turns.
  struct Turning {
    Index column;
    const EndCompletion* completion;
    bool tangential;
    int function;
  };

  /// Of each coefficient.
  struct Integrals {
    std::vector<Matrix> traces;  ///< ∫ χ_i d·φ_k: displacement functions x components
    std::vector<Matrix> parts;   ///< χ_i d in orthonormal polynomials x components
    Vector rests;                ///< ∫ χ_i d·(r - r_I)
    Matrix mass;                 ///< where isWhole
  };

  /// Where S u is projected on polynomials, so is λ: on arcs they leave something of it, and M is
  /// the product of what they take.
  bool isWhole(const Element& element) const {
    return density_ || element.curve.isStraight();
  }

  static double product(const Matrix& a, const Matrix& b) {
    double sum = 0;
    for (Index l = 0; l < a.rows(); ++l)
      for (Index c = 0; c < 2; ++c)
        sum += a(l, c) * b(l, c);
    return sum;
  }

  /// By Gauss points.
  Integrals integralsOf(const ContactElement& contact,
                        const std::vector<Turning>& unknowns) const {
    const Element& element = space_.mesh()[contact.element];
    const int p = element.degree;
    const int count = terms(element);
    const Rule& rule =
        bem::gaussLegendre(p + (element.curve.isStraight() ? 1 : bem::pointsOfTurning));
    const auto size = static_cast<Index>(unknowns.size());
    Integrals result{{}, {}, Vector(unknowns.size()), Matrix(size, size)};
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      result.traces.emplace_back(p + 1, 2);
      result.parts.emplace_back(count, 2);
    }
    std::array<double, bem::largestDegree + 1> phi{};
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
      const double t = rule.points[q];
      const double weight = element.half * rule.weights[q];
      const Vector chi = basis_.values(p, t);
      bem::DisplacementBasis::values(p, t, phi.data());
      const auto legendre = orthonormal(element, t);
      const Vec2 rest = space_.rotationRest(contact.element, t);
      for (std::size_t i = 0; i < unknowns.size(); ++i) {
        const Turning& unknown = unknowns[i];
        const Vec2 direction =
            unknown.tangential ? element.curve.tangent(t) : element.curve.normal(t);
        const double value = weight * chi[unknown.function];
        addOuter(value * direction, phi.data(), result.traces[i]);
        addOuter(value * direction, legendre.data(), result.parts[i]);
        result.rests[i] += value * dot(direction, rest);
        for (std::size_t k = 0; isWhole(element) && k < unknowns.size(); ++k)
          if (unknowns[k].tangential == unknown.tangential)
            result.mass(static_cast<Index>(i), static_cast<Index>(k)) +=
                value * chi[unknowns[k].function];
      }
    }
    return result;
  }

  /// A += values directionᵀ
  static void addOuter(Vec2 direction, const double* values, Matrix& a) {
    for (Index k = 0; k < a.rows(); ++k) {
      a(k, 0) += direction.x * values[k];
      a(k, 1) += direction.y * values[k];
    }
  }

  std::vector<Turning> turningOf(const ContactElement& contact) const {
    std::vector<Turning> result;
    const int p = contact.degree;
    for (const bool tangential : {false, true})
      for (int i = 0; i <= p && (!tangential || contact.tangential >= 0); ++i)
        result.push_back({tangential ? contact.tangentialOf(i) : contact.normalOf(i),
                          completionOf(tangential ? contact.tangentialCompletions
                                                  : contact.normalCompletions,
                                       i, p),
                          tangential, i});
    return result;
  }

  void writeMass(const Element& element, const std::vector<Turning>& unknowns,
                 std::size_t i, double gamma, const Integrals& integrals) const {
    const bool whole = isWhole(element);
    for (std::size_t k = 0; k < unknowns.size(); ++k)
      if (!whole || unknowns[k].tangential == unknowns[i].tangential)
        coupling_.mass.push_back(
            {unknowns[i].column, unknowns[k].column,
             gamma * (whole ? integrals.mass(static_cast<Index>(i), static_cast<Index>(k))
                            : product(integrals.parts[i], integrals.parts[k]))});
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
  bool density_;
  Coupling& coupling_;
};

}  // namespace

// NOLINTNEXTLINE(readability-function-size): who assembles has all of these
void addElement(const bem::Space& space, const MultiplierBasis& basis, bool byDensity,
                const ContactElement& contact, double gamma, Index firstRow,
                Coupling& coupling) {
  CouplingWriter(space, basis, byDensity, coupling).write(contact, gamma, firstRow);
}

TractionMoments tractionMoments(const bem::Space& space,
                                const MultiplierSpace& multiplier, bool byDensity,
                                const Coupling& coupling,
                                const ParticularSolution& inside) {
  TractionMoments moments{Vector(at(coupling.start.back())),
                          Vector(at(multiplier.size()))};
  Coupling none;
  const CouplingWriter writer(space, multiplier.basis(), byDensity, none);
  for (std::size_t k = 0; k < multiplier.elements().size(); ++k)
    if (coupling.gamma[k] != 0)
      writer.addMoments(multiplier.elements()[k], coupling.gamma[k], coupling.start[k],
                        inside, moments);
  return moments;
}

}  // namespace epafi::contact
