#include "contact/problem/Coupling.hpp"

#include "bem/base/Error.hpp"
#include "bem/basis/Legendre.hpp"
#include "bem/quadrature/Gauss.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace epafi::contact {

using bem::Element;
using bem::Rows;
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

std::vector<int> contactElements(const MultiplierSpace& multiplier) {
  std::vector<int> elements;
  for (const ContactElement& element : multiplier.elements())
    elements.push_back(element.element);
  return elements;
}

std::shared_ptr<const bem::TractionRows> tractions(const ContactProblem::Input& input,
                                                   const MultiplierSpace& multiplier) {
  const auto form = input.stabilization.form == Stabilization::Form::Exact
                        ? bem::TractionForm::Exact
                        : bem::TractionForm::Projected;
  return bem::tractionRows(input.space, input.lame, input.stiffness,
                           contactElements(multiplier), form);
}

std::shared_ptr<const bem::TractionRows> noTractions(const MultiplierSpace& multiplier) {
  return std::make_shared<const bem::TractionRows>(
      bem::TractionRows{{}, std::vector<Index>(multiplier.elements().size() + 1, 0)});
}

/// Adds the normal or tangential coefficients of one element.
class CouplingWriter {
 public:
  CouplingWriter(const bem::Space& space, const MultiplierBasis& basis, bool density,
                 Coupling& coupling)
      : space_(space), basis_(basis), density_(density), coupling_(coupling) {}

  void write(const ContactElement& contact, double gamma, Index firstTraction) const {
    const Element& element = space_.mesh()[contact.element];
    if (!element.curve.isStraight())
      return writeArc(contact, gamma, firstTraction);
    writeDirection(contact, &ContactElement::normalOf, contact.normalCompletions,
                   element.segment().normal, gamma, firstTraction);
    if (contact.tangential >= 0)
      writeDirection(contact, &ContactElement::tangentialOf,
                     contact.tangentialCompletions, turnLeft(element.segment().normal),
                     gamma, firstTraction);
  }

 private:
  using Numbering = Index (ContactElement::*)(int) const;
  using Completions = std::array<EndCompletion, 2>;

  void writeDirection(const ContactElement& contact, Numbering number,
                      const Completions& completions, Vec2 direction, double gamma,
                      Index firstTraction) const {
    const Element& element = space_.mesh()[contact.element];
    const int p = element.degree;
    const Matrix chi = orthonormalCoefficients(basis_, element);
    const Matrix phi = displacementCoefficients(element);
    const double components[2] = {direction.x, direction.y};
    for (int i = 0; i <= p; ++i) {
      const Index column = (contact.*number)(i);
      for (int k = 0; k <= p; ++k) {
        double product = 0;
        double mass = 0;
        for (int l = 0; l <= p; ++l) {
          product += chi(l, i) * phi(l, k);
          mass += chi(l, i) * chi(l, k);
        }
        for (int c = 0; c < 2; ++c)
          writeTrace(space_.displacement(contact.element, k, c), column,
                     components[c] * product, completionOf(completions, i, p));
        if (gamma > 0)
          coupling_.mass.push_back({column, (contact.*number)(k), gamma * mass});
      }
      if (gamma == 0)
        continue;
      // S φ by orthonormal polynomials, densities by Legendre's
      for (int l = 0; l < std::min(p + 1, terms(element)); ++l) {
        const double norm = density_ ? std::sqrt(2 * element.half / (2 * l + 1)) : 1;
        for (int c = 0; c < 2; ++c)
          coupling_.weights.push_back({firstTraction + 2 * l + c, column,
                                       gamma * norm * chi(l, i) * components[c]});
      }
    }
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

  // All by Gauss points: ∫ χ_i d·φ_k, ∫ χ_i d·(r - r_I), and χ_i d in orthonormal
  // polynomials.  Where S u is projected on these, so is λ: M is the product of what is
  // left.
  void writeArc(const ContactElement& contact, double gamma, Index firstTraction) const {
    const Element& element = space_.mesh()[contact.element];
    const int p = element.degree;
    const int count = terms(element);
    const Rule& rule = bem::gaussLegendre(p + bem::pointsOfTurning);
    const std::vector<Turning> unknowns = turningOf(contact);
    std::vector<Matrix> traces;  // displacement functions x components
    std::vector<Matrix> parts;   // orthonormal polynomials x components
    Vector rests(unknowns.size());
    Matrix mass(static_cast<Index>(unknowns.size()), static_cast<Index>(unknowns.size()));
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      traces.emplace_back(p + 1, 2);
      parts.emplace_back(count, 2);
    }
    std::array<double, bem::largestDegree + 2> legendre{};
    std::array<double, bem::largestDegree + 1> phi{};
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
      const double t = rule.points[q];
      const double weight = element.half * rule.weights[q];
      const Vector chi = basis_.values(p, t);
      bem::DisplacementBasis::values(p, t, phi.data());
      bem::legendreValues(count - 1, t, legendre.data());
      const Vec2 rest = space_.rotationRest(contact.element, t);
      for (std::size_t i = 0; i < unknowns.size(); ++i) {
        const Turning& unknown = unknowns[i];
        const Vec2 direction =
            unknown.tangential ? element.curve.tangent(t) : element.curve.normal(t);
        const double value = weight * chi[static_cast<std::size_t>(unknown.function)];
        const double components[2] = {value * direction.x, value * direction.y};
        for (Index c = 0; c < 2; ++c) {
          for (Index k = 0; k <= p; ++k)
            traces[i](k, c) += components[c] * phi[static_cast<std::size_t>(k)];
          for (Index l = 0; l < count; ++l)
            parts[i](l, c) +=
                components[c] * legendre[static_cast<std::size_t>(l)] *
                std::sqrt((2 * static_cast<double>(l) + 1) / (2 * element.half));
        }
        rests[i] += value * dot(direction, rest);
        for (std::size_t k = 0; density_ && k < unknowns.size(); ++k)
          if (unknowns[k].tangential == unknown.tangential)
            mass(static_cast<Index>(i), static_cast<Index>(k)) +=
                value * chi[static_cast<std::size_t>(unknowns[k].function)];
      }
    }
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      const auto& [column, completion, tangential, function] = unknowns[i];
      for (Index k = 0; k <= p; ++k)
        for (int c = 0; c < 2; ++c)
          writeTrace(space_.displacement(contact.element, static_cast<int>(k), c), column,
                     traces[i](k, c), completion);
      writeRest(column, rests[i], completion);
      if (gamma == 0)
        continue;
      for (std::size_t k = 0; k < unknowns.size(); ++k) {
        double product = mass(static_cast<Index>(i), static_cast<Index>(k));
        for (Index l = 0; !density_ && l < count; ++l)
          for (Index c = 0; c < 2; ++c)
            product += parts[i](l, c) * parts[k](l, c);
        coupling_.mass.push_back({column, unknowns[k].column, gamma * product});
      }
      for (int l = 0; l < count; ++l) {
        const double norm = density_ ? std::sqrt(2 * element.half / (2 * l + 1)) : 1;
        for (int c = 0; c < 2; ++c)
          coupling_.weights.push_back(
              {firstTraction + 2 * l + c, column, gamma * norm * parts[i](l, c)});
      }
    }
  }

  void writeRest(Index column, double value, const EndCompletion* completion) const {
    const bool clamped = completion != nullptr && completion->clamped;
    Vector& rests = clamped ? coupling_.completionOfRotation : coupling_.traceOfRotation;
    rests[static_cast<std::size_t>(column)] += value;
    if (completion != nullptr)
      for (const auto& [k, factor] : completion->added)
        coupling_.completionOfRotation[static_cast<std::size_t>(k)] += factor * value;
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

/// Where the densities of each contact element begin among all of them.
std::vector<Index> densityStarts(const bem::Space& space,
                                 const MultiplierSpace& multiplier) {
  std::vector<Index> starts(1, 0);
  for (const ContactElement& contact : multiplier.elements())
    starts.push_back(starts.back() + 2 * space.mesh()[contact.element].densities);
  return starts;
}

/// The mean of one component of ψ on the longest element of an edge, held with a small part
/// of its own diagonal in V: large enough for the factor, and the change of volume that it
/// lets through is below the error.
std::pair<Index, double> pinOn(const bem::Space& space, int edge) {
  int longest = -1;
  for (int e = 0; e < space.mesh().size(); ++e)
    if (space.mesh()[e].piece.edge == edge &&
        (longest < 0 || space.mesh()[e].half > space.mesh()[longest].half))
      longest = e;
  const Element& element = space.mesh()[longest];
  const Vec2 normal = element.curve.normal(0);
  return {space.density(longest, 0, std::abs(normal.x) > std::abs(normal.y) ? 0 : 1),
          1e-4 * element.half * element.half};
}

/// What stands for S φ in the coupling: densities' responses, or tractions.
void chooseColumns(Coupling& coupling, const ContactProblem::Input& input,
                   const MultiplierSpace& multiplier) {
  const Stabilization::Form form = input.stabilization.form;
  coupling.response = input.stiffness.response();
  coupling.tractions =
      form == Stabilization::Form::Projected || form == Stabilization::Form::Exact
          ? tractions(input, multiplier)
          : noTractions(multiplier);
  coupling.start = coupling.tractions->start;
  coupling.columns = {coupling.tractions, &coupling.tractions->rows};
  const bool expected =
      form == Stabilization::Form::Density && !multiplier.elements().empty();
  const auto compliant = densityCompliance(input.space, multiplier, input.stabilization,
                                           input.lame, input.units)
                             .densities;
  if (expected ? coupling.response == nullptr || coupling.response->densities != compliant
               : coupling.response != nullptr)
    throw bem::InputError(
        "the stiffness was made for another stabilisation than the contact problem: take "
        "it from contact::makeStiffness");
  if (!expected)
    return;
  coupling.columns = {coupling.response, &coupling.response->displacements};
  coupling.start = densityStarts(input.space, multiplier);
}

/// Writes what the elements have, with the columns that are chosen already.
void writeElements(const bem::Space& space, const MultiplierSpace& multiplier,
                   const Stabilization& stabilization, const bem::Lame& lame,
                   bem::Units units, Coupling& coupling) {
  const bool byDensity = stabilization.form == Stabilization::Form::Density;
  coupling.unknowns = space.displacements();
  coupling.multipliers = multiplier.size();
  coupling.rotation = space.rotation();
  for (Vector* rests : {&coupling.traceOfRotation, &coupling.completionOfRotation})
    rests->assign(static_cast<std::size_t>(multiplier.size()), 0.0);
  const CouplingWriter writer(space, multiplier.basis(), byDensity, coupling);
  for (std::size_t k = 0; k < multiplier.elements().size(); ++k) {
    const ContactElement& contact = multiplier.elements()[k];
    coupling.gamma.push_back(
        gammaOn(space.mesh(), contact.element, stabilization, lame.nu, units));
    writer.write(contact, coupling.gamma.back(), coupling.start[k]);
  }
  const bem::LocalCompliance compliance =
      densityCompliance(space, multiplier, stabilization, lame, units);
  coupling.compliance = compliance.diagonal;
  coupling.pinned = compliance.pinned;
}

}  // namespace

std::vector<int> tractionElements(const MultiplierSpace& multiplier,
                                  const Stabilization& stabilization) {
  if (stabilization.form != Stabilization::Form::Projected)
    return {};
  return contactElements(multiplier);
}

bem::Space makeSpace(const bem::Mesh& mesh, const Conditions& conditions,
                     const Stabilization& stabilization) {
  std::vector<int> densities;
  for (int e = 0; e < mesh.size(); ++e) {
    const bool raised = stabilization.form == Stabilization::Form::Density &&
                        stabilization.raised && mesh[e].degree < bem::largestDegree &&
                        contactOn(mesh, e, conditions) != nullptr;
    densities.push_back(mesh[e].degree + (raised ? 1 : 0));
  }
  return bem::Space(mesh.withDensities(densities));
}

bem::LocalCompliance densityCompliance(const bem::Space& space,
                                       const MultiplierSpace& multiplier,
                                       const Stabilization& stabilization,
                                       const bem::Lame& lame, bem::Units units) {
  bem::LocalCompliance compliance;
  if (stabilization.form != Stabilization::Form::Density)
    return compliance;
  for (const int e : contactElements(multiplier)) {
    const Element& element = space.mesh()[e];
    const double gamma = gammaOn(space.mesh(), e, stabilization, lame.nu, units);
    for (int i = 0; i < element.densities; ++i)
      for (int c = 0; c < 2; ++c) {
        compliance.densities.push_back(space.density(e, i, c));
        compliance.diagonal.push_back(gamma * 2 * element.half / (2 * i + 1));
      }
  }
  for (const int edge : multiplier.conditions().pins)
    compliance.pinned.push_back(pinOn(space, edge));
  return compliance;
}

bem::SteklovPoincare makeStiffness(const bem::Space& space,
                                   const MultiplierSpace& multiplier,
                                   const Stabilization& stabilization,
                                   const bem::Lame& lame, bem::Units units,
                                   const bem::DenseAlgebra& algebra) {
  return bem::SteklovPoincare(
      bem::assembleOperators(space, lame, algebra,
                             tractionElements(multiplier, stabilization)),
      algebra, densityCompliance(space, multiplier, stabilization, lame, units));
}

Coupling makeCoupling(const ContactProblem::Input& input,
                      const MultiplierSpace& multiplier) {
  Coupling coupling;
  chooseColumns(coupling, input, multiplier);
  writeElements(input.space, multiplier, input.stabilization, input.lame, input.units,
                coupling);
  return coupling;
}

Coupling makeLocalCoupling(const bem::Space& space, const MultiplierSpace& multiplier,
                           const Stabilization& stabilization, const bem::Lame& lame,
                           bem::Units units) {
  Coupling coupling;
  coupling.tractions = noTractions(multiplier);
  coupling.start = densityStarts(space, multiplier);
  writeElements(space, multiplier, stabilization, lame, units, coupling);
  return coupling;
}

void Coupling::weaken(double factor) {
  for (auto* entries : {&weights, &mass})
    for (Entry& entry : *entries)
      entry.value *= factor;
  for (double& g : gamma)
    g *= factor;
}

double quadratic(const Matrix& symmetric, const Vector& w) {
  double sum = 0;
  for (Index j = 0; j < symmetric.columns(); ++j) {
    const double* column = symmetric.column(j);
    double inner = 0;
    for (Index i = 0; i < symmetric.rows() && w[at(j)] != 0; ++i)
      inner += column[i] * w[at(i)];
    sum += w[at(j)] * inner;
  }
  return sum;
}

Matrix Coupling::multiplierMass() const {
  Matrix result(multipliers, multipliers);
  for (const Entry& entry : mass)
    result(entry.row, entry.column) += entry.value;
  if (response == nullptr)
    return result;
  // - Nᵀ X N, N by columns
  const Matrix& x = response->density;
  Matrix half(x.rows(), multipliers);
  for (const Entry& entry : weights)
    for (Index i = 0; i < x.rows(); ++i)
      half(i, entry.column) += entry.value * x(i, entry.row);
  for (Index j = 0; j < multipliers; ++j)
    for (const Entry& entry : weights)
      result(entry.column, j) -= entry.value * half(entry.row, j);
  return result;
}

double Coupling::multiplierWork(const Vector& lambda) const {
  double work = 0;
  for (const Entry& entry : mass)
    work += lambda[at(entry.row)] * entry.value * lambda[at(entry.column)];
  return response == nullptr ? work
                             : work - quadratic(response->density, weighted(lambda));
}

Matrix Coupling::transposed(const bem::DenseAlgebra& algebra) const {
  const Rows mine = algebra.myRows(unknowns);
  Matrix result(mine.size(), multipliers);
  for (const Entry& entry : trace)
    if (mine.contain(entry.row))
      result(entry.row - mine.begin, entry.column) += entry.value;
  for (const Entry& entry : weights) {
    const double* traction = columns->column(entry.row);
    double* column = result.column(entry.column);
    for (Index j = 0; j < mine.size(); ++j)
      column[j] -= entry.value * traction[j];
  }
  if (rotation != nullptr)
    for (Index i = 0; i < multipliers; ++i)
      for (Index j = 0; j < mine.size(); ++j)
        result(j, i) += traceOfRotation[static_cast<std::size_t>(i)] *
                        rotation->functional()[static_cast<std::size_t>(j + mine.begin)];
  return result;
}

Vector Coupling::weighted(const Vector& lambda) const {
  Vector result(static_cast<std::size_t>(start.back()));
  for (const Entry& entry : weights)
    result[static_cast<std::size_t>(entry.row)] +=
        entry.value * lambda[static_cast<std::size_t>(entry.column)];
  return result;
}

Vector Coupling::push(const bem::DenseAlgebra& algebra, const Vector& lambda) const {
  Vector result(static_cast<std::size_t>(unknowns));
  if (!weights.empty()) {
    result = algebra.multiply(*columns, unknowns, weighted(lambda));
    for (double& x : result)
      x = -x;
  }
  for (const auto* entries : {&trace, &completion})
    for (const Entry& entry : *entries)
      result[static_cast<std::size_t>(entry.row)] +=
          entry.value * lambda[static_cast<std::size_t>(entry.column)];
  if (rotation != nullptr) {
    double rest = 0;
    for (std::size_t i = 0; i < lambda.size(); ++i)
      rest += (traceOfRotation[i] + completionOfRotation[i]) * lambda[i];
    rotation->complete(rest, result);
  }
  return result;
}

Vector Coupling::pull(const bem::DenseAlgebra& algebra, const Vector& u) const {
  const auto at = [](Index i) { return static_cast<std::size_t>(i); };
  Vector result(at(multipliers));
  if (!weights.empty()) {
    const Rows mine = algebra.myRows(unknowns);
    Vector tractionOf(at(columns->columns()));  // Rᵀ u
    for (Index k = 0; k < columns->columns(); ++k) {
      const double* traction = columns->column(k);
      for (Index j = 0; j < mine.size(); ++j)
        tractionOf[at(k)] += traction[j] * u[at(j + mine.begin)];
    }
    tractionOf = algebra.sum(std::move(tractionOf));
    for (const Entry& entry : weights)
      result[at(entry.column)] -= entry.value * tractionOf[at(entry.row)];
  }
  for (const Entry& entry : trace)
    result[at(entry.column)] += entry.value * u[at(entry.row)];
  return result;
}

Matrix Coupling::stabilisationHalf(Index first, Index last) const {
  const Index rows = tractions->rows.rows();
  Matrix half(rows, last - first);
  for (std::size_t k = 0; k < gamma.size(); ++k) {
    const double root = std::sqrt(gamma[k]);
    const Index end = std::min(last, tractions->start[k + 1]);
    for (Index c = std::max(first, tractions->start[k]); c < end; ++c)
      for (Index j = 0; j < rows; ++j)
        half(j, c - first) = root * tractions->rows(j, c);
  }
  return half;
}

}  // namespace epafi::contact
