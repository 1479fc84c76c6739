#include "contact/body/Holding.hpp"

#include "bem/algebra/LuFactor.hpp"
#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::contact {

namespace {

Matrix withUnitRow(const Matrix& above, Index column) {
  Matrix result(above.rows() + 1, above.columns());
  for (Index j = 0; j < above.columns(); ++j)
    std::copy_n(above.column(j), above.rows(), result.column(j));
  result(above.rows(), column) = 1;
  return result;
}

/// What the motions do at the clamped unknowns, and a row for each that the body does not have.
Matrix clampedMotions(const RigidModes& modes, const std::vector<char>& clamped) {
  std::vector<Index> rows;
  for (Index j = 0; j < modes.motions.rows(); ++j)
    if (clamped[at(j)] != 0)
      rows.push_back(j);
  Matrix result = bem::rowsOf(modes.motions, rows);
  for (Index k = 0; k < modes.motions.columns(); ++k)
    if (bem::largestEntry(columnOf(modes.motions, k)) == 0)
      result = withUnitRow(result, k);
  return result;
}

std::vector<int> namedModes(const Conditions::Fix& fix) {
  const bool isFixed[] = {fix.x, fix.y, fix.rotation};
  std::vector<int> modes;
  for (const int mode : {0, 1, 2})
    if (isFixed[mode])
      modes.push_back(mode);
  return modes;
}

/// Without what clamps take: the functionals act on what is left of u.
Matrix withoutClamped(Matrix columns, const std::vector<char>& clamped) {
  for (Index c = 0; c < columns.columns(); ++c)
    for (Index j = 0; j < columns.rows(); ++j)
      if (clamped[j] != 0)
        columns(j, c) = 0;
  return columns;
}

/// Keeps the first `fixed` functionals, which are dual to the first motions already, and
/// changes the others so that all are dual to all.
Matrix dualTo(const Matrix& motions, Matrix functionals, Index fixed) {
  const Matrix pairing = transposedProduct(functionals, motions);
  const Index free = motions.columns() - fixed;
  const Index n = functionals.rows();
  for (Index k = fixed; k < motions.columns(); ++k)
    for (Index l = 0; l < fixed; ++l)
      for (Index j = 0; j < n; ++j)
        functionals(j, k) -= pairing(k, l) * functionals(j, l);
  if (free == 0)
    return functionals;
  const bem::LuFactor factor(
      bem::rowsBetween(bem::columnsBetween(pairing, fixed, fixed + free), fixed,
                       fixed + free)
          .copy());
  if (!factor.isRegular())
    throw bem::NumericalError(
        "the free rigid motions cannot be told apart on this boundary");
  Matrix right = bem::transposed(bem::columnsBetween(functionals, fixed, fixed + free));
  factor.solve(right);
  for (Index k = 0; k < free; ++k)
    for (Index j = 0; j < n; ++j)
      functionals(j, fixed + k) = right(k, j);
  return functionals;
}

Index largestInRow(const Matrix& columns, Index row, Index first) {
  Index best = first;
  for (Index k = first; k < columns.columns(); ++k)
    if (std::abs(columns(row, k)) > std::abs(columns(row, best)))
      best = k;
  return best;
}

/// The columns from `first` on in reduced echelon form: one basis of their span, whatever
/// signs and rotations the singular vectors came with.  The amplitudes of free motions
/// then mean the same on every mesh, and can be carried from one to the next.
Matrix reduced(Matrix columns, Index first) {
  const Index rows = columns.rows();
  Index pivot = first;
  for (Index row = 0; row < rows && pivot < columns.columns(); ++row) {
    const Index best = largestInRow(columns, row, pivot);
    if (std::abs(columns(row, best)) < 1e-9)
      continue;
    for (Index i = 0; i < rows; ++i)
      std::swap(columns(i, pivot), columns(i, best));
    const double scale = 1 / columns(row, pivot);
    for (Index i = 0; i < rows; ++i)
      columns(i, pivot) *= scale;
    for (Index k = first; k < columns.columns(); ++k) {
      const double factor = k == pivot ? 0 : columns(row, k);
      for (Index i = 0; i < rows; ++i)
        columns(i, k) -= factor * columns(i, pivot);
    }
    ++pivot;
  }
  return columns;
}

/// The values of the named functionals on the allowed motions.
/// \throws bem::InputError if clamps hold one of them already.
bem::Svd heldByFix(const RigidModes& modes, const Matrix& allowedCombinations,
                   const std::vector<int>& fixedModes, const std::string& path) {
  const Matrix pairs = transposedProduct(modes.functionals, modes.motions);
  const Matrix onAllowed = product(pairs, allowedCombinations);
  const auto fixed = static_cast<Index>(fixedModes.size());
  Matrix named(fixed, onAllowed.columns());
  Matrix compared(fixed, onAllowed.columns());  // by what they do to their own motions
  for (Index k = 0; k < fixed; ++k)
    for (Index a = 0; a < onAllowed.columns(); ++a) {
      const int mode = fixedModes[k];
      named(k, a) = onAllowed(mode, a);
      compared(k, a) = named(k, a) / pairs(mode, mode);
    }
  if (bem::rank(bem::singularValues(std::move(compared)), 1e-10) == fixed)
    return bem::singularValues(std::move(named));
  constexpr const char* names[] = {"X", "Y", "Rotation"};
  std::string list;
  for (const int mode : fixedModes)
    list += (list.empty() ? "" : ", ") + std::string(names[mode]);
  throw bem::InputError(path + "->Fix = {" + list +
                        "}: the clamps already hold at least one of these motions; name "
                        "only those that no Dirichlet condition stops");
}

/// Combinations of the allowed motions: pseudo-inverse for the fixed, kernel for the
/// free.
Matrix dualCombinations(const bem::Svd& held, Index fixed, Index allowed) {
  Matrix combinations(allowed, allowed);
  for (Index k = 0; k < fixed; ++k)
    for (Index a = 0; a < allowed; ++a)
      for (Index s = 0; s < fixed; ++s)
        combinations(a, k) += held.vt(s, a) / held.s[s] * held.u(k, s);
  for (Index k = fixed; k < allowed; ++k)
    for (Index a = 0; a < allowed; ++a)
      combinations(a, k) = held.vt(k, a);
  return combinations;
}

/// Sets the motions, their functionals and fixedModes.
void setMotions(const Conditions::Fix& fix, Holding& holding) {
  const RigidModes& modes = holding.modes;
  const bem::Svd clamps = bem::singularValues(clampedMotions(modes, holding.clamped));
  // motions are of size 1, coordinates known to 1e-16
  const Matrix allowedCombinations =
      bem::transposed(bem::rowsBetween(clamps.vt, bem::rank(clamps, 1e-12), 3));
  const Index allowed = allowedCombinations.columns();
  holding.fixedModes = namedModes(fix);
  const Index fixed = holding.fixed();

  const bem::Svd held =
      heldByFix(modes, allowedCombinations, holding.fixedModes, fix.path);
  const Matrix inModes = reduced(
      product(allowedCombinations, dualCombinations(held, fixed, allowed)), fixed);
  holding.allowed = withoutClamped(product(modes.motions, inModes), holding.clamped);

  // functionals of the free motions: ∫ u · r ds, made dual to all allowed motions
  Matrix functionals = product(modes.functionals, inModes);
  for (Index k = 0; k < fixed; ++k)
    std::copy_n(modes.functionals.column(holding.fixedModes[at(k)]), functionals.rows(),
                functionals.column(k));
  functionals = withoutClamped(std::move(functionals), holding.clamped);
  holding.functionals = dualTo(holding.allowed, std::move(functionals), fixed);
  holding.scales.assign(at(allowed), 1.0);
}

void scaleMotions(Holding& holding) {
  for (Index k = 0; k < holding.allowed.columns(); ++k) {
    double* motion = holding.allowed.column(k);
    double* functional = holding.functionals.column(k);
    const double largest = bem::largestEntry(columnOf(holding.allowed, k));
    for (Index j = 0; j < holding.allowed.rows(); ++j) {
      motion[j] /= largest;
      functional[j] *= largest;
    }
    holding.scales[at(k)] = largest;
  }
}

/// Of what a displacement does to each multiplier, the sum of absolute values: where a body meets itself
/// the rest of its terms is rounding.
Vector sizesOf(const TraceCoupling& trace, const Vector& u) {
  Vector sizes(trace.rests.size());
  for (const bem::Entry& entry : trace.entries)
    sizes[at(entry.column)] += std::abs(entry.value * u[at(entry.row)]);
  return sizes;
}

}  // namespace

Holding makeHolding(const bem::Space& space, const Conditions& conditions) {
  Holding holding{prescribed(space, conditions), makeRigidModes(space, conditions)};
  setMotions(conditions.fix, holding);
  const bem::Outline& outline = space.mesh().outline();
  if (outline.diameter() < outline.scaling().length)
    scaleMotions(holding);
  return holding;
}

std::vector<Vector> motionsOnContacts(const Holding& holding, Index first,
                                      const TraceCoupling& trace) {
  std::vector<Vector> columns;
  if (first == holding.allowed.columns())
    return columns;
  const Vector alongX = sizesOf(trace, columnOf(holding.modes.motions, 0));
  const Vector alongY = sizesOf(trace, columnOf(holding.modes.motions, 1));
  for (Index k = first; k < holding.allowed.columns(); ++k) {
    const Vector motion = columnOf(holding.allowed, k);
    columns.push_back(trace.apply(motion));
    dropRounding(alongX, alongY, motion, columns.back());
  }
  return columns;
}

}  // namespace epafi::contact
