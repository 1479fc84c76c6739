#include "contact/body/CoupledBody.hpp"

#include "bem/algebra/DenseAlgebra.hpp"
#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/tractions/TractionRows.hpp"
#include "contact/body/BalancedStiffness.hpp"

#include <Teuchos_LAPACK.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi::contact {

using bem::dot;

namespace {

std::vector<Index> unclamped(const std::vector<char>& clamped) {
  std::vector<Index> free;
  for (std::size_t i = 0; i < clamped.size(); ++i)
    if (clamped[i] == 0)
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

double largestEigenvalue(Matrix symmetric) {
  const int n = bem::asInt(symmetric.rows());
  Vector values(n);
  Vector work(std::max(1, 34 * n));
  int info = 0;
  Teuchos::LAPACK<int, double>().SYEV('N', 'L', n, symmetric.data(),
                                      bem::asInt(symmetric.stride()), values.data(),
                                      work.data(), static_cast<int>(work.size()), &info);
  return info == 0 && n > 0 ? values.back() : 0;
}

using Tractions = std::shared_ptr<const bem::TractionRows>;

/// Columns of X, S^ = X Xᵀ = R γ Rᵀ.
Matrix halfBetween(const bem::TractionRows& tractions, const Vector& gamma, Index first,
                   Index last) {
  Matrix half(tractions.rows.rows(), last - first);
  for (std::size_t k = 0; k < gamma.size() && first < last; ++k) {
    const double root = std::sqrt(gamma[k]);
    const Index end = std::min(last, tractions.start[k + 1]);
    for (Index c = std::max(first, tractions.start[k]); c < end; ++c)
      for (Index j = 0; j < half.rows(); ++j)
        half(j, c - first) = root * tractions.rows(j, c);
  }
  return half;
}

/// The forms of [P], which insert the traction S u, the one by the density, and no
/// stabilisation.
class CoupledBody final : public StabilisedBody {
 public:
  /// \param tractions S φ; null: no S^  \throws bem::NumericalError if A is not definite
  CoupledBody(const BodyInput& input, std::shared_ptr<const Holding> holding,
              Coupling coupling, Tractions tractions)
      : StabilisedBody(input.space, std::move(holding), std::move(coupling)),
        stiffness_(input.stiffness),
        response_(stiffness_.response()),
        tractions_(std::move(tractions)),
        columns_(response_ != nullptr    ? &response_->displacements
                 : tractions_ != nullptr ? &tractions_->rows
                                         : nullptr),
        balanced_(stiffness_, makeRigidModes(space_), tractions_, coupling_.gamma),
        free_(unclamped(holding_->clamped)),
        factor_(factored()) {}

  bool isFormed() const override { return true; }
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
                      const Loads::OfInside& inside) const override {
    double twice = balanced_.stiffnessWork(u);
    if (!coupling_.hasCompliance())
      return 0.5 * twice;
    const Vector& ofInside = inside.density;
    Vector psi = density(u, multiplier);
    if (!ofInside.empty()) {
      bem::axpy(1, ofInside, psi);
      twice -= 2 * dot(u, inside.force) + dot(inside.compliance, ofInside);
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

  bem::CholeskyFactor factored() const try {
    return bem::CholeskyFactor(
        addOuter(subtract(unpackedAt(free_, stiffness_.stiffness())),
                 rowsAt(free_, holding_->functionals.copy()), 1),
        "the stiffness matrix");
  } catch (const bem::NumericalError& error) {
    throw bem::NumericalError(
        error.what(),
        "; rounding has taken its digits, as it does in bodies slender by more than "
        "1 : 1000: look at the outline");
  }

  // S - S^, a panel of X at a time, which saves memory
  Matrix subtract(Matrix a) const {
    constexpr Index width = 256;
    const Index columns = tractions_ != nullptr ? tractions_->start.back() : 0;
    for (Index first = 0; first < columns; first += width)
      a = addOuter(std::move(a),
                   rowsAt(free_, halfBetween(*tractions_, coupling_.gamma, first,
                                             std::min(first + width, columns))),
                   -1);
    return a;
  }

  const bem::SteklovPoincare& stiffness_;
  std::shared_ptr<const bem::ComplianceResponse> response_;  ///< Density; else null
  Tractions tractions_;
  const Matrix* columns_;  ///< R
  BalancedStiffness balanced_;
  std::vector<Index> free_;     ///< displacements that are not clamped
  bem::CholeskyFactor factor_;  ///< of A there
};

/// Of the forms that insert S u; else null.
Tractions tractionsOf(const BodyInput& input, const MultiplierSpace& multiplier) {
  const auto form = input.stabilization.tractions();
  return form ? bem::tractionRows(input.space, input.lame, input.stiffness,
                                  multiplier.meshElements(), *form)
              : nullptr;
}

Coupling couplingOf(const BodyInput& input, const MultiplierSpace& multiplier,
                    const Tractions& tractions) {
  return makeCoupling(input.space, multiplier, input.stabilization, input.lame,
                      input.units,
                      tractions != nullptr ? tractions->start : std::vector<Index>());
}

double limitGamma0(const BodyInput& input, const std::shared_ptr<const Holding>& holding,
                   const Coupling& coupling, const Tractions& tractions) {
  const Index columns = tractions->start.back();
  if (columns == 0)
    return std::numeric_limits<double>::infinity();
  Coupling none = coupling;
  none.weaken(0);
  const CoupledBody plain(input, holding, std::move(none), tractions);  // S
  const Matrix reduced =
      plain.forward(halfBetween(*tractions, coupling.gamma, 0, columns));
  return coupling.gamma0 / largestEigenvalue(addGram(Matrix(columns, columns), reduced));
}

}  // namespace

IndefiniteStiffness::IndefiniteStiffness(double used, double limit)
    : bem::NumericalError(
          "the stabilised stiffness S - S^ is not positive definite: "
          "Discretization->Stabilization->Gamma0 = ",
          used, " is too large for this mesh; below ", limit,
          " it is definite, and a quarter of that is safe"),
      gamma0(used),
      limitGamma0(limit) {}

std::unique_ptr<const StabilisedBody> makeCoupledBody(
    const BodyInput& input, const MultiplierSpace& multiplier,
    const std::shared_ptr<const Holding>& holding) {
  const Tractions tractions = tractionsOf(input, multiplier);
  Coupling coupling = couplingOf(input, multiplier, tractions);
  const auto response = input.stiffness.response();
  if (coupling.byDensity()
          ? response == nullptr || response->densities != coupling.compliance.densities
          : response != nullptr)
    throw bem::InputError(
        "the stiffness was made for another stabilisation than the contact problem: take "
        "it from contact::makeStiffness");
  try {
    return std::make_unique<const CoupledBody>(input, holding, coupling, tractions);
  } catch (const bem::NumericalError&) {
    if (tractions == nullptr || tractions->start.back() == 0)
      throw;
  }
  const double first = coupling.gamma0;
  const double definiteBelow = limitGamma0(input, holding, coupling, tractions);
  if (input.stabilization.gamma0)
    throw IndefiniteStiffness(first, definiteBelow);
  coupling.weaken(std::min(first, definiteBelow) / 4);
  return std::make_unique<const CoupledBody>(input, holding, std::move(coupling),
                                             tractions);
}

double limitGamma0(const BodyInput& input) {
  if (!input.stabilization.tractions())
    return std::numeric_limits<double>::infinity();
  const MultiplierSpace multiplier(input.space.mesh(), input.basis, input.conditions);
  const Tractions tractions = tractionsOf(input, multiplier);
  return limitGamma0(
      input, std::make_shared<const Holding>(makeHolding(input.space, input.conditions)),
      couplingOf(input, multiplier, tractions), tractions);
}

}  // namespace epafi::contact
