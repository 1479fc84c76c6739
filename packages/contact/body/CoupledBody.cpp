#include "contact/body/CoupledBody.hpp"

#include "bem/algebra/DenseAlgebra.hpp"
#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/tractions/TractionRows.hpp"
#include "contact/body/BalancedStiffness.hpp"
#include "contact/body/Holding.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::contact {

using bem::dot;

namespace {

std::vector<Index> unclamped(const Loads& loads) {
  std::vector<Index> free;
  for (std::size_t i = 0; i < loads.clamped.size(); ++i)
    if (loads.clamped[i] == 0)
      free.push_back(static_cast<Index>(i));
  return free;
}

/// Rows and columns of some, ascending.
Matrix unpackedAt(const std::vector<Index>& which, const bem::LowerTriangle& lower) {
  const auto count = static_cast<Index>(which.size());
  Matrix result(count, count);
  for (Index j = 0; j < count; ++j) {
    const double* column = lower.column(which[j]) - which[j];
    for (Index i = j; i < count; ++i)
      result(i, j) = column[which[i]];
  }
  return result;
}

/// Some rows, ascending; without a copy where they are all.
Matrix rowsAt(const std::vector<Index>& which, Matrix a) {
  return at(a.rows()) == which.size() ? std::move(a) : bem::rowsOf(a, which);
}

/// Aᵀ x
Vector columnsTimes(const Matrix& a, const Vector& x) {
  Vector result;
  for (Index j = 0; j < a.columns(); ++j) {
    const double* column = a.column(j);
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (Index i = 0; i < a.rows(); ++i)
      sum += column[i] * x[i];
    result.push_back(sum);
  }
  return result;
}

class Factored final : public HeldStiffness {
 public:
  /// Of the displacements at `free` alone.
  Factored(Matrix lower, std::vector<Index> free)
      : factor_(factorOf(std::move(lower))), free_(std::move(free)) {}

  Vector solve(const Vector& force) const override {
    Vector u;
    for (const Index i : free_)
      u.push_back(force[i]);
    const Vector solved = factor_.solve(u);
    u.assign(force.size(), 0.0);
    for (std::size_t k = 0; k < solved.size(); ++k)
      u[free_[k]] = solved[k];
    return u;
  }
  Matrix forward(Matrix rows) const override {
    return factor_.forward(rowsAt(free_, std::move(rows)));
  }

 private:
  static bem::CholeskyFactor factorOf(Matrix lower) try {
    return bem::CholeskyFactor(std::move(lower), "the stiffness matrix");
  } catch (const bem::NumericalError& error) {
    throw bem::NumericalError(
        error.what(),
        "; rounding has taken its digits, as it does in bodies slender by more than "
        "1 : 1000: look at the outline");
  }

  bem::CholeskyFactor factor_;
  std::vector<Index> free_;
};

/// The forms of [P], which insert the traction S u, the one by the density, and no
/// stabilisation.
class Coupled final : public StabilisedBody {
 public:
  Coupled(const bem::Space& space, const bem::SteklovPoincare& stiffness,
          Coupling coupling, std::shared_ptr<const bem::TractionRows> tractions)
      : StabilisedBody(space, std::move(coupling)),
        stiffness_(stiffness),
        response_(stiffness.response()),
        tractions_(std::move(tractions)),
        columns_(response_ != nullptr    ? &response_->displacements
                 : tractions_ != nullptr ? &tractions_->rows
                                         : nullptr),
        balanced_(stiffness_, makeRigidModes(space), tractions_, coupling_.gamma) {}

  std::shared_ptr<const HeldStiffness> held(const Holding& holding) const override {
    std::vector<Index> free = unclamped(holding.loads);
    Matrix a = addOuter(subtract(unpackedAt(free, stiffness_.stiffness()), free),
                        rowsAt(free, holding.functionals.copy()), 1);
    return std::make_shared<const Factored>(std::move(a), std::move(free));
  }

  Vector residual(const Vector& force, const Vector& u) const override {
    return balanced_.residual(force, u);
  }
  Vector density(const Vector& u, const Vector& multiplier) const override {
    return coupling_.byDensity() ? stiffness_.density(u, coupling_.weighted(multiplier))
                                 : stiffness_.density(u);
  }

  Matrix coupling() const override {
    Matrix result(space_.displacements(),
                  static_cast<Index>(coupling_.trace.rests.size()));
    coupling_.trace.addTo(result);
    for (const bem::Entry& entry : coupling_.weights) {
      const double* traction = columns_->column(entry.row);
      double* column = result.column(entry.column);
      for (Index j = 0; j < result.rows(); ++j)
        column[j] -= entry.value * traction[j];
    }
    return result;
  }

  // M - Gᵀ X G, G by columns
  Matrix multiplierMass() const override {
    const auto size = static_cast<Index>(coupling_.trace.rests.size());
    Matrix result(size, size);
    for (const bem::Entry& entry : coupling_.mass)
      result(entry.row, entry.column) += entry.value;
    if (response_ == nullptr)
      return result;
    const Matrix& x = response_->density;
    Matrix half(x.rows(), size);
    for (const bem::Entry& entry : coupling_.weights)
      for (Index i = 0; i < x.rows(); ++i)
        half(i, entry.column) += entry.value * x(i, entry.row);
    for (Index j = 0; j < size; ++j)
      for (const bem::Entry& entry : coupling_.weights)
        result(entry.column, j) -= entry.value * half(entry.row, j);
    return result;
  }

  // With w = N λ:  uᵀ A u - 2 uᵀ R w + wᵀ X w - ψᵀ G ψ, which has no differences of what
  // grows as ν -> 1/2 while γ is there.
  // What acts inside adds g to w in all places, ψ_p = -(V + G)⁻¹ g.
  double strainEnergy(const Vector& u, const Vector& multiplier,
                      const ResidualTerms& terms) const override {
    double twice = balanced_.stiffnessWork(u);
    if (!coupling_.hasCompliance())
      return 0.5 * twice;
    const Vector& ofInside = terms.density;
    Vector psi = density(u, multiplier);
    if (!ofInside.empty()) {
      bem::axpy(1, ofInside, psi);
      twice -= 2 * dot(u, terms.force) + dot(terms.compliance, ofInside);
    }
    twice -= coupling_.complianceWork(psi);
    if (!coupling_.byDensity())
      return 0.5 * twice;
    const Vector w = coupling_.weighted(multiplier);
    if (!ofInside.empty())
      twice -= 2 * dot(w, coupling_.ofDensities(ofInside));
    twice -= 2 * dot(u, forcesOf(w));
    return 0.5 * (twice + dot(w, responsesTo(w)));
  }

  // S^ = X Xᵀ
  Matrix subtracted() const override { return halfBetween(0, columnsOfHalf()); }
  std::unique_ptr<const StabilisedBody> weakened(double factor) const override {
    Coupling weaker = coupling_;
    weaker.weaken(factor);
    return std::make_unique<const Coupled>(space_, stiffness_, std::move(weaker),
                                           tractions_);
  }

 private:
  Vector tractionsOf(const Vector& u) const override {
    return columnsTimes(*columns_, u);
  }
  Vector forcesOf(const Vector& w) const override { return multiply(*columns_, w); }
  Vector responsesTo(const Vector& w) const override {
    return columnsTimes(response_->density, w);
  }
  std::pair<Vector, Vector> answerTo(const Vector& compliance) const override {
    return {stiffness_.densityOf(compliance),
            columnOf(stiffness_.addAdjointDensity(Matrix(space_.displacements(), 1),
                                                  bem::asColumn(compliance)),
                     0)};
  }

  Index columnsOfHalf() const { return tractions_ ? tractions_->start.back() : 0; }
  Matrix halfBetween(Index first, Index last) const {
    Matrix half(space_.displacements(), last - first);
    for (std::size_t k = 0; k < coupling_.gamma.size() && first < last; ++k) {
      const double root = std::sqrt(coupling_.gamma[k]);
      const Index end = std::min(last, tractions_->start[k + 1]);
      for (Index c = std::max(first, tractions_->start[k]); c < end; ++c)
        for (Index j = 0; j < half.rows(); ++j)
          half(j, c - first) = root * tractions_->rows(j, c);
    }
    return half;
  }

  // S - S^, a panel of X at a time, which saves memory
  Matrix subtract(Matrix a, const std::vector<Index>& free) const {
    constexpr Index width = 256;
    for (Index first = 0; first < columnsOfHalf(); first += width)
      a = addOuter(
          std::move(a),
          rowsAt(free, halfBetween(first, std::min(first + width, columnsOfHalf()))), -1);
    return a;
  }

  const bem::SteklovPoincare& stiffness_;
  std::shared_ptr<const bem::ComplianceResponse> response_;  ///< Density; else null
  std::shared_ptr<const bem::TractionRows> tractions_;       ///< S φ; null: no S^
  const Matrix* columns_;                                    ///< R
  BalancedStiffness balanced_;
};

/// Of the forms that insert S u; else null.
std::shared_ptr<const bem::TractionRows> tractionsOf(const BodyInput& input,
                                                     const MultiplierSpace& multiplier) {
  const auto form = input.stabilization.tractions();
  return form ? bem::tractionRows(input.space, input.lame, input.stiffness,
                                  multiplier.meshElements(), *form)
              : nullptr;
}

}  // namespace

std::unique_ptr<const StabilisedBody> makeCoupledBody(const BodyInput& input,
                                                      const MultiplierSpace& multiplier) {
  const auto tractions = tractionsOf(input, multiplier);
  Coupling coupling =
      makeCoupling(input.space, multiplier, input.stabilization, input.lame, input.units,
                   tractions != nullptr ? tractions->start : std::vector<Index>());
  const auto response = input.stiffness.response();
  if (coupling.byDensity()
          ? response == nullptr || response->densities != coupling.compliance.densities
          : response != nullptr)
    throw bem::InputError(
        "the stiffness was made for another stabilisation than the contact problem: take "
        "it from contact::makeStiffness");
  return std::make_unique<const Coupled>(input.space, input.stiffness,
                                         std::move(coupling), tractions);
}

}  // namespace epafi::contact
