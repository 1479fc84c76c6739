#include "contact/newton/Reduction.hpp"

#include "bem/algebra/SmallAlgebra.hpp"

#include <Teuchos_LAPACK.hpp>

#include <algorithm>
#include <cmath>

namespace epafi::contact {

namespace {

// A rigid motion counts as held when its part in the inactive rows, measured in units in
// which the whole of it has size one, is larger than this.
constexpr double heldThreshold = 1e-12;

}  // namespace

Reduction::Reduction(const Equation& equation_, const LinearRows& at_)
    : equation(equation_),
      e(at_),
      problem(equation_.problem()),
      n(problem.size()),
      k(problem.rigidMotions()) {
  chooseInactive();
  splitMotions();
}

void Reduction::chooseInactive() {
  position.assign(at(n), -1);
  followed.resize(at(n));
  for (Index i = 0; i < n; ++i) {
    const Complementarity& row = e.rows[at(i)];
    if (row.penetration != 0) {
      position[at(i)] = count();
      inactive.push_back(i);
    } else if (i >= problem.normals) {
      const std::size_t t = at(i - problem.normals);
      const double factor = -row.bound * e.stepBounds[t].slope;
      if (factor == 0)
        continue;
      followed[at(i)] = {problem.tangentials[t].normal(), factor};
      // A bound that follows an open contact is known, too.
      symmetric = symmetric && isKnown(followed[at(i)].normal);
    }
  }
  for (const Index i : inactive) {
    const double d =
        problem.flexibility.isFormed() ? problem.flexibility(i, i) : 1 / weight(i);
    scale.push_back(d > 0 ? 1 / std::sqrt(d) : 1);
  }
}

void Reduction::splitMotions() {
  motionScale.assign(at(k), 1.0);
  for (Index j = 0; j < k; ++j) {
    double sum = 0;
    for (Index i = 0; i < n; ++i)
      sum += problem.rigid(i, j) * problem.rigid(i, j) * weight(i);
    motionScale[at(j)] = sum > 0 ? 1 / std::sqrt(sum) : 1;
  }
  Matrix motions(count(), k);
  for (Index m = 0; m < k; ++m)
    for (Index p = 0; p < count(); ++p)
      motions(p, m) =
          scale[at(p)] * problem.rigid(inactive[at(p)], m) * motionScale[at(m)];
  Matrix gram = transposedTimes(motions, motions);
  Vector eigenvalues(at(k));
  Vector work(at(8 * k + 8));
  int info = 0;
  if (k > 0)
    Teuchos::LAPACK<int, double>().SYEV(
        'V', 'L', static_cast<int>(k), gram.data(), static_cast<int>(gram.stride()),
        eigenvalues.data(), work.data(), static_cast<int>(work.size()), &info);
  const auto looseCount = std::count_if(eigenvalues.begin(), eigenvalues.end(),
                                        [](double v) { return !(v > heldThreshold); });
  loose = Matrix(k, looseCount);
  held = Matrix(k, k - looseCount);
  for (Index j = 0; j < k; ++j)
    std::copy_n(gram.column(j), k,
                j < looseCount ? loose.column(j) : held.column(j - looseCount));
  border = multiply(motions, held);
}

double Reduction::heldEntry(Index i, Index j) const {
  double sum = 0;
  for (Index m = 0; m < k; ++m)
    sum += problem.rigid(i, m) * motionScale[at(m)] * held(m, j);
  return sum;
}

Vector Reduction::knownChanges(const Vector& b) const {
  Vector d(at(n), 0.0);
  for (Index i = 0; i < n; ++i)
    if (isKnown(i)) {
      d[at(i)] = b[at(i)];
      if (const auto& [normal, factor] = followed[at(i)]; factor != 0 && isKnown(normal))
        d[at(i)] += factor * d[at(normal)];
    }
  return d;
}

void Reduction::follow(Vector& d) const {
  forEachFollower(
      [&](Index i, Index leader, double factor) { d[at(i)] += factor * d[at(leader)]; });
}

Vector Reduction::balance(const Vector& b, const Vector& known) const {
  Vector rest;
  for (Index j = 0; j < k; ++j) {
    double sum = b[at(n + j)] * equation.balanceScales()[at(j)];
    for (Index i = 0; i < n; ++i)
      sum -= problem.rigid(i, j) * known[at(i)];
    rest.push_back(sum * motionScale[at(j)]);
  }
  return rest;
}

Vector Reduction::rightSides(const Vector& b) const {
  Vector x;
  for (const Index i : inactive)
    x.push_back(b[at(i)] / weight(i));
  return x;
}

void Reduction::appendMotions(const double* sizes, Vector& d) const {
  for (Index m = 0; m < k; ++m) {
    double sum = 0;
    for (Index j = 0; j < held.columns(); ++j)
      sum += held(m, j) * sizes[j];
    d.push_back(motionScale[at(m)] * sum);
  }
}

}  // namespace epafi::contact
