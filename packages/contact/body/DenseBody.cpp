#include "contact/body/DenseBody.hpp"

#include "bem/algebra/DenseAlgebra.hpp"
#include "bem/algebra/DoubledSums.hpp"
#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace epafi::contact {

namespace {

using Tractions = DenseBody::Tractions;

constexpr Index motions = 3;

// Rows that a thread sums up: each in one order, whatever the number of threads.
constexpr Index rowsAtOnce = 128;
Index panels(Index rows) { return (rows + rowsAtOnce - 1) / rowsAtOnce; }

constexpr double ofEntry = 1;  // ns

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

/// Of the forms that insert S u; else null.
Tractions tractionsOf(const BodyInput& input, const MultiplierSpace& multiplier,
                      std::size_t body) {
  const auto form = input.stabilization.tractions();
  if (!form)
    return nullptr;
  std::vector<int> elements;
  for (const auto& contact : multiplier.elements(body))
    elements.push_back(contact.element);
  return bem::tractionRows(input.space, input.lame, input.stiffness, elements, *form);
}

Coupling couplingOf(const BodyInput& input, const MultiplierSpace& multiplier,
                    std::size_t body, const Tractions& tractions, const Coupling& plain) {
  return stabilised(plain, input.space, multiplier, body, input.stabilization, input.lame,
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
  const DenseBody plain(input, holding, std::move(none), tractions);  // S
  const Matrix reduced =
      plain.forward(halfBetween(*tractions, coupling.gamma, 0, columns));
  return coupling.gamma0 /
         bem::singularValues(bem::transposedProduct(reduced, reduced)).s.front();
}

// x - along (tested · x) / square
void takeOff(const double* tested, double square, const double* along,
             std::vector<long double>& x) {
  if (square == 0)  // a motion that the body does not have
    return;
  long double share = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    share += tested[i] * x[i];
  share /= square;
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] -= share * along[i];
}

}  // namespace

DenseBody::DenseBody(const BodyInput& input, std::shared_ptr<const Holding> holding,
                     Coupling coupling, Tractions tractions, Bedding bedding)
    : ElasticBody(input.space, std::move(holding), std::move(coupling),
                  std::move(bedding)),
      stiffness_(input.stiffness),
      response_(stiffness_.response()),
      tractions_(std::move(tractions)),
      columns_(response_ != nullptr    ? &response_->displacements
               : tractions_ != nullptr ? &tractions_->rows
                                       : nullptr),
      free_(unclamped(holding_->clamped)),
      springs_(makeSprings()),
      factor_(factored()) {
  for (Index k = 0; k < motions; ++k) {
    long double square = 0;
    for (Index i = 0; i < holding_->modes.motions.rows(); ++i)
      square += static_cast<long double>(holding_->modes.functionals(i, k)) *
                holding_->modes.motions(i, k);
    squares_.push_back(static_cast<double>(square));
  }
}

bem::CholeskyFactor DenseBody::factored() const try {
  Matrix a = addOuter(subtractStabilisation(unpackedAt(free_, stiffness_.stiffness())),
                      rowsAt(free_, holding_->functionals.copy()), 1);
  return bem::CholeskyFactor(
      bedding_.rows.empty() ? std::move(a)
                            : addOuter(std::move(a), rowsAt(free_, springs_.copy()), 1),
      "the stiffness matrix");
} catch (const bem::NumericalError& error) {
  throw bem::NumericalError(
      error.what(),
      "; rounding has taken its digits, as it does in bodies slender by more than "
      "1 : 1000: look at the outline");
}

// Bᵀ k^½ (I - q qᵀ), q an orthonormal basis of k^½ B r
Matrix DenseBody::makeSprings() const {
  constexpr double rounding = 1e-8;
  const std::vector<Index>& rows = bedding_.rows;
  if (rows.empty())
    return {};
  std::vector<Index> places(coupling_.trace.rests.size(), -1);
  for (std::size_t k = 0; k < rows.size(); ++k)
    places[at(rows[k])] = static_cast<Index>(k);
  Matrix springs = transposedCoupling(places, static_cast<Index>(rows.size()));
  for (Index k = 0; k < springs.columns(); ++k)
    for (Index i = 0; i < springs.rows(); ++i)
      springs(i, k) *= std::sqrt(bedding_.stiffness[at(k)]);
  const Matrix moved = bem::transposedProduct(springs, holding_->allowed);
  std::vector<Vector> basis;
  for (Index k = 0; k < moved.columns(); ++k) {
    Vector q = columnOf(moved, k);
    const double before = bem::dot(q, q);
    for (int twice = 0; twice < 2; ++twice)
      for (const Vector& other : basis)
        bem::axpy(-bem::dot(other, q), other, q);
    if (const double square = bem::dot(q, q); square > rounding * rounding * before)
      basis.push_back(bem::times(1 / std::sqrt(square), q));
  }
  for (const Vector& q : basis) {
    const Vector along = bem::product(springs, q);
    for (Index k = 0; k < springs.columns(); ++k)
      for (Index i = 0; i < springs.rows(); ++i)
        springs(i, k) -= along[at(i)] * q[at(k)];
  }
  return springs;
}

Vector DenseBody::beddingForce(const Vector& x) const {
  Vector own;
  for (std::size_t k = 0; k < bedding_.rows.size(); ++k)
    own.push_back(std::sqrt(bedding_.stiffness[k]) * x[at(bedding_.rows[k])]);
  return bem::product(springs_, own);
}

// A panel of X at a time, which saves memory
Matrix DenseBody::subtractStabilisation(Matrix a) const {
  constexpr Index width = 256;
  const Index columns = tractions_ != nullptr ? tractions_->start.back() : 0;
  for (Index first = 0; first < columns; first += width)
    a = addOuter(std::move(a),
                 rowsAt(free_, halfBetween(*tractions_, coupling_.gamma, first,
                                           std::min(first + width, columns))),
                 -1);
  return a;
}

Vector DenseBody::solve(const Vector& force) const {
  Vector u;
  for (const Index i : free_)
    u.push_back(force[i]);
  const Vector solved = factor_.solve(u);
  u.assign(force.size(), 0.0);
  for (std::size_t k = 0; k < solved.size(); ++k)
    u[free_[k]] = solved[k];
  // r·f of each motion but for rounding, which counts where forces are large beside what moves stiff bodies
  for (Index k = 0; k < holding_->allowed.columns(); ++k)
    bem::axpy(-bem::dot(columnOf(holding_->functionals, k), u),
              columnOf(holding_->allowed, k), u);
  return u;
}

Matrix DenseBody::forward(Matrix rows) const {
  return factor_.forward(rowsAt(free_, std::move(rows)));
}

Vector DenseBody::density(const Vector& u, const Vector& w) const {
  return stiffness_.density(u, w);
}

Vector DenseBody::tractionsOf(const Vector& u) const {
  return bem::transposedProduct(*columns_, u);
}

Vector DenseBody::forcesOf(const Vector& w) const { return bem::product(*columns_, w); }

Vector DenseBody::responsesTo(const Vector& w) const {
  return bem::transposedProduct(response_->density, w);
}

std::pair<Vector, Vector> DenseBody::answerTo(const Vector& g) const {
  return {stiffness_.densityOf(g),
          columnOf(stiffness_.addAdjointDensity(Matrix(space_.displacements(), 1),
                                                bem::ConstMatrixView(g).copy()),
                   0)};
}

ElasticBody::Image DenseBody::imageOf(const Vector& u) const {
  const Extended inner = withoutMotions(u);
  Extended forces = stiffnessTimes(inner);
  const auto work = static_cast<double>(
      std::inner_product(inner.begin(), inner.end(), forces.begin(), 0.0L));
  subtractStabilisation(inner, forces);
  return {balanced(std::move(forces)), work};
}

// P u
DenseBody::Extended DenseBody::withoutMotions(const Vector& u) const {
  Extended result(u.begin(), u.end());
  for (Index k = 0; k < motions; ++k)
    takeOff(holding_->modes.functionals.column(k), squares_[k],
            holding_->modes.motions.column(k), result);
  return result;
}

// Pᵀ f
DenseBody::Extended DenseBody::balanced(Extended forces) const {
  for (Index k = motions; k-- > 0;)
    takeOff(holding_->modes.motions.column(k), squares_[k],
            holding_->modes.functionals.column(k), forces);
  return forces;
}

// S u from the lower triangle: what stands below the diagonal in a column, then what stands
// before it in a row.
DenseBody::Extended DenseBody::stiffnessTimes(const Extended& u) const {
  const bem::LowerTriangle& lower = stiffness_.stiffness();
  const Index n = lower.size();
  const bem::Doubled x(u);
  Extended below(u.size());
  const double work = ofEntry * 0.5 * static_cast<double>(n * n);
  bem::parallelFor({n, work, 16}, [&](Index j) {
    below[j] = bem::dotDoubled(lower.column(j), n - j, x, j);
  });
  bem::Doubled result(below);
  bem::parallelFor({panels(n), work}, [&](Index k) {
    const Index first = k * rowsAtOnce;
    const Index last = std::min(first + rowsAtOnce, n);
    for (Index j = 0; j < last; ++j) {
      const Index from = std::max(j + 1, first);
      if (from < last)
        bem::addDoubled(u[j], lower.column(j) + (from - j), last - from, result, from);
    }
  });
  return result.joined();
}

// S^ u = R γ Rᵀ u with the tractions R.
void DenseBody::subtractStabilisation(const Extended& u, Extended& forces) const {
  if (tractions_ == nullptr)
    return;
  const bem::Matrix& rows = tractions_->rows;
  const Index columns = tractions_->start.back();
  const bem::Doubled x(u);
  Extended tractions(columns);
  const double work = ofEntry * static_cast<double>(rows.rows() * columns);
  bem::parallelFor({columns, work, 16}, [&](Index c) {
    tractions[c] = bem::dotDoubled(rows.column(c), rows.rows(), x, 0);
  });
  for (std::size_t k = 0; k < coupling_.gamma.size(); ++k)
    for (Index c = tractions_->start[k]; c < tractions_->start[k + 1]; ++c)
      tractions[c] *= coupling_.gamma[k];
  bem::Doubled stabilisation(u.size());
  bem::parallelFor({panels(rows.rows()), work}, [&](Index k) {
    const Index first = k * rowsAtOnce;
    const Index last = std::min(first + rowsAtOnce, rows.rows());
    for (Index c = 0; c < columns; ++c)
      bem::addDoubled(tractions[c], rows.column(c) + first, last - first, stabilisation,
                      first);
  });
  const Extended all = stabilisation.joined();
  for (std::size_t i = 0; i < forces.size(); ++i)
    forces[i] -= all[i];
}

IndefiniteStiffness::IndefiniteStiffness(double used, double limit)
    : bem::NumericalError(
          "the stabilised stiffness S - S^ is not positive definite: "
          "Discretization->Stabilization->Gamma0 = ",
          used, " is too large for this mesh; below ", limit,
          " it is definite, and a quarter of that is safe"),
      gamma0(used),
      limitGamma0(limit) {}

std::shared_ptr<const DenseBody> makeDenseBody(
    const BodyInput& input, const MultiplierSpace& multiplier, std::size_t body,
    const std::shared_ptr<const Holding>& holding, const Coupling& plain,
    const Bedding& bedding) {
  const Tractions tractions = tractionsOf(input, multiplier, body);
  Coupling coupling = couplingOf(input, multiplier, body, tractions, plain);
  const auto response = input.stiffness.response();
  if (coupling.byDensity()
          ? response == nullptr || response->densities != coupling.compliance.densities
          : response != nullptr)
    throw bem::InputError(
        "the stiffness was made for another stabilisation than the contact problem: take "
        "it from contact::makeStiffness");
  try {
    return std::make_shared<const DenseBody>(input, holding, coupling, tractions,
                                             bedding);
  } catch (const bem::NumericalError&) {
    if (tractions == nullptr || tractions->start.back() == 0)
      throw;
  }
  const double first = coupling.gamma0;
  const double definiteBelow = limitGamma0(input, holding, coupling, tractions);
  if (input.stabilization.gamma0)
    throw IndefiniteStiffness(first, definiteBelow);
  coupling.weaken(std::min(first, definiteBelow) / 4);
  return std::make_shared<const DenseBody>(input, holding, std::move(coupling), tractions,
                                           bedding);
}

double limitGamma0(const BodyInput& input) {
  if (!input.stabilization.tractions())
    return std::numeric_limits<double>::infinity();
  const MultiplierSpace multiplier(input.space.mesh(), input.basis, input.conditions);
  const Tractions tractions = tractionsOf(input, multiplier, 0);
  const Opposite opposite(input.units.length);
  Coupling plain;
  plain.opposite = &opposite;
  return limitGamma0(
      input, std::make_shared<const Holding>(makeHolding(input.space, input.conditions)),
      couplingOf(input, multiplier, 0, tractions, plain), tractions);
}

}  // namespace epafi::contact
