#include "contact/body/Coupling.hpp"

#include "bem/algebra/DenseAlgebra.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "contact/body/ElementCoupling.hpp"

#include <algorithm>

namespace epafi::contact {

using ContactElement = MultiplierSpace::ContactElement;

namespace {

std::shared_ptr<const bem::TractionRows> tractions(const BodyInput& input,
                                                   const MultiplierSpace& multiplier) {
  const auto form = input.stabilization.form == Stabilization::Form::Exact
                        ? bem::TractionForm::Exact
                        : bem::TractionForm::Projected;
  return bem::tractionRows(input.space, input.lame, input.stiffness,
                           multiplier.meshElements(), form);
}

std::shared_ptr<const bem::TractionRows> noTractions(const MultiplierSpace& multiplier) {
  return std::make_shared<const bem::TractionRows>(
      bem::TractionRows{{}, std::vector<Index>(multiplier.elements().size() + 1, 0)});
}

double product(const double* a, const double* b, Index size) {
  double sum = 0;
#pragma omp simd reduction(+ : sum)
  for (Index i = 0; i < size; ++i)
    sum += a[i] * b[i];
  return sum;
}

/// Where the densities of each contact element begin among all of them.
std::vector<Index> densityStarts(const bem::Space& space,
                                 const MultiplierSpace& multiplier) {
  std::vector<Index> starts(1, 0);
  for (const ContactElement& contact : multiplier.elements())
    starts.push_back(starts.back() + 2 * space.mesh()[contact.element].densities);
  return starts;
}

/// What stands for S φ in the coupling: densities' responses, or tractions.
void chooseColumns(Coupling& coupling, const BodyInput& input,
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
    rests->assign(multiplier.size(), 0.0);
  for (std::size_t k = 0; k < multiplier.elements().size(); ++k) {
    const ContactElement& contact = multiplier.elements()[k];
    coupling.gamma.push_back(
        gammaOn(space.mesh(), contact.element, stabilization, lame.nu, units));
    addElement(space, multiplier.basis(), byDensity, contact, coupling.gamma.back(),
               coupling.start[k], coupling);
  }
  coupling.compliance = densityCompliance(space, multiplier, stabilization, lame, units);
}

}  // namespace

Coupling makeCoupling(const BodyInput& input, const MultiplierSpace& multiplier) {
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
    for (bem::Entry& entry : *entries)
      entry.value *= factor;
  for (double& g : gamma)
    g *= factor;
}

Vector timesSymmetric(const Matrix& symmetric, const Vector& w) {
  Vector result;
  for (Index j = 0; j < symmetric.columns(); ++j)
    result.push_back(product(symmetric.column(j), w.data(), symmetric.rows()));
  return result;
}

double quadratic(const Matrix& symmetric, const Vector& w) {
  return bem::dot(w, timesSymmetric(symmetric, w));
}

Matrix Coupling::multiplierMass() const {
  Matrix result(multipliers, multipliers);
  for (const bem::Entry& entry : mass)
    result(entry.row, entry.column) += entry.value;
  if (response == nullptr)
    return result;
  // - Nᵀ X N, N by columns
  const Matrix& x = response->density;
  Matrix half(x.rows(), multipliers);
  for (const bem::Entry& entry : weights)
    for (Index i = 0; i < x.rows(); ++i)
      half(i, entry.column) += entry.value * x(i, entry.row);
  for (Index j = 0; j < multipliers; ++j)
    for (const bem::Entry& entry : weights)
      result(entry.column, j) -= entry.value * half(entry.row, j);
  return result;
}

Vector Coupling::massTimes(const Vector& lambda) const {
  Vector result(multipliers);
  for (const bem::Entry& entry : mass)
    result[entry.row] += entry.value * lambda[entry.column];
  if (response == nullptr)
    return result;
  const Vector taken = timesSymmetric(response->density, weighted(lambda));
  for (const bem::Entry& entry : weights)
    result[entry.column] -= entry.value * taken[entry.row];
  return result;
}

double Coupling::multiplierWork(const Vector& lambda) const {
  return bem::dot(lambda, massTimes(lambda));
}

double Coupling::complianceWork(const Vector& density) const {
  double work = 0;
  for (std::size_t k = 0; k < compliance.densities.size(); ++k)
    work += compliance.diagonal[k] * std::pow(density[compliance.densities[k]], 2);
  for (const auto& [i, value] : compliance.pinned)
    work += value * std::pow(density[i], 2);
  return work;
}

Vector Coupling::complianceOf(const bem::Space& space, const Vector& onContacts,
                              const ParticularSolution& inside) const {
  const bem::Mesh& mesh = space.mesh();
  Vector result(at(space.densities()));
  for (std::size_t k = 0; k < compliance.densities.size(); ++k)
    result[at(compliance.densities[k])] = onContacts[k];
  for (const auto& [i, value] : compliance.pinned)
    for (int e = 0; e < mesh.size(); ++e)
      for (const int c : {0, 1}) {
        const bem::Rule& rule = bem::gaussForGiven(0);
        for (int q = 0; q < rule.size() && space.density(e, 0, c) == i; ++q) {
          const bem::Vec2 traction = inside.traction(mesh, e, rule.points[q]);
          result[at(i)] +=
              value * 0.5 * rule.weights[q] * (c == 0 ? traction.x : traction.y);
        }
      }
  return result;
}

void Coupling::subtractWeighted(const Vector& density, Vector& r) const {
  for (const bem::Entry& entry : weights)
    r[at(entry.column)] -= entry.value * density[at(compliance.densities[at(entry.row)])];
}

std::vector<bem::Vec2> Coupling::meanSlacks(const Vector& lambda, const Vector& density,
                                            const Vector& ofInside) const {
  std::vector<bem::Vec2> means(gamma.size());
  if (compliance.densities.empty())
    return means;
  // P_0 is 1: its rows of N λ and of G ψ are integrals
  Vector w = weighted(lambda);
  for (std::size_t k = 0; k < w.size() && !ofInside.empty(); ++k)
    w[k] += ofInside[at(compliance.densities[k])];
  const auto integral = [&](Index k) {
    return w[k] + compliance.diagonal[k] * density[compliance.densities[k]];
  };
  for (std::size_t c = 0; c < means.size(); ++c) {
    const Index first = start[c];
    const double length = compliance.diagonal[first] / gamma[c];
    means[c] = (1 / length) * bem::Vec2{integral(first), integral(first + 1)};
  }
  return means;
}

Matrix Coupling::transposed() const {
  Matrix result(unknowns, multipliers);
  for (const bem::Entry& entry : trace)
    result(entry.row, entry.column) += entry.value;
  for (const bem::Entry& entry : weights) {
    const double* traction = columns->column(entry.row);
    double* column = result.column(entry.column);
    for (Index j = 0; j < unknowns; ++j)
      column[j] -= entry.value * traction[j];
  }
  if (rotation != nullptr)
    for (Index i = 0; i < multipliers; ++i)
      for (Index j = 0; j < unknowns; ++j)
        result(j, i) += traceOfRotation[i] * rotation->functional()[j];
  return result;
}

Vector Coupling::weighted(const Vector& lambda) const {
  Vector result(start.back());
  if (lambda.empty())
    return result;
  for (const bem::Entry& entry : weights)
    result[entry.row] += entry.value * lambda[entry.column];
  return result;
}

Vector Coupling::push(const Vector& lambda) const {
  Vector result(unknowns);
  if (!weights.empty()) {
    result = multiply(*columns, weighted(lambda));
    for (double& x : result)
      x = -x;
  }
  for (const auto* entries : {&trace, &completion})
    for (const bem::Entry& entry : *entries)
      result[entry.row] += entry.value * lambda[entry.column];
  if (rotation != nullptr) {
    double rest = 0;
    for (std::size_t i = 0; i < lambda.size(); ++i)
      rest += (traceOfRotation[i] + completionOfRotation[i]) * lambda[i];
    rotation->complete(rest, result);
  }
  return result;
}

Vector Coupling::pull(const Vector& u) const {
  Vector result(multipliers);
  if (!weights.empty()) {
    Vector tractionOf(columns->columns());  // Rᵀ u
    for (Index k = 0; k < columns->columns(); ++k)
      tractionOf[k] = product(columns->column(k), u.data(), unknowns);
    for (const bem::Entry& entry : weights)
      result[entry.column] -= entry.value * tractionOf[entry.row];
  }
  for (const bem::Entry& entry : trace)
    result[entry.column] += entry.value * u[entry.row];
  if (rotation != nullptr)
    bem::axpy(rotation->amount(u), traceOfRotation, result);
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
