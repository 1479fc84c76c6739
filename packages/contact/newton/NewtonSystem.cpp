#include "contact/newton/NewtonSystem.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"
#include "contact/body/IterativeRefinement.hpp"
#include "contact/newton/KeptFactor.hpp"

#include <Teuchos_BLAS.hpp>
#include <Teuchos_LAPACK.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi::contact {

using bem::dot;

namespace {

// A rigid motion counts as held when its part in the inactive rows, measured in units in
// which the whole of it has size one, is larger than this.
constexpr double heldThreshold = 1e-12;

// How much of a solution by a kept factor its last refinement may change; another one would
// change the square of it.
constexpr double enoughOfKept = 1e-7;

}  // namespace

struct NewtonSystem::Impl {
  const Equation& equation;
  const Evaluation& e;
  const Problem& problem;
  Index n;
  Index k;

  std::vector<Index> inactive;  // the coefficients that are solved for
  std::vector<Index> position;  // where a coefficient stands in `inactive`, or -1
  std::vector<std::vector<NormalShare>> boundParts;  // ∂F_i/∂λₙ through the bound
  bool symmetric = true;

  Vector scale;        // 1/sqrt of the reduced diagonal
  Vector motionScale;  // gives each rigid motion size one
  Matrix held;         // orthonormal combinations of scaled motions that the rows hold
  Matrix loose;        // ... and that they do not

  // Where D is known by what it does; its solutions for Ĝ, all coefficients, are in
  // solvedBorder, what balances them in schur.
  std::unique_ptr<Flexibility::Operator::Factor> byOperator;

  std::unique_ptr<const KeptFactor>
      kept;  // that of an earlier system, brought up to date

  Matrix factor;  // Cholesky's L or LU of the bordered matrix
  std::vector<int> pivots;
  Vector rowScale;  // what equilibrates an LU: stiff rows stand beside soft ones
  Vector columnScale;
  Matrix border;        // Ĝ = scale G_I motionScale held
  Matrix solvedBorder;  // (M + Ĝ Ĝᵀ)⁻¹ Ĝ
  Matrix schur;         // its Cholesky factor: Ĝᵀ solvedBorder

  Impl(const Equation& equation_, const Evaluation& at_)
      : equation(equation_),
        e(at_),
        problem(equation_.problem()),
        n(problem.size()),
        k(problem.rigidMotions()) {
    chooseInactive();
    splitMotions();
    if (!problem.flexibility.isFormed())
      factorByOperator();
    else if (problem.flexibility.kept() != nullptr && canKeep())
      kept = KeptFactor::make(problem, allMotions(), keptRows());
    if (byOperator == nullptr && kept == nullptr)
      factorNow();
  }

  void factorNow() {
    if (symmetric)
      factorSymmetric();
    else
      factorGeneral();
  }

  // Is the system D and G alone, whatever the point is?
  bool canKeep() const {
    return loose.columns() == 0 && boundsFollowKnownRows() &&
           std::all_of(inactive.begin(), inactive.end(),
                       [&](Index i) { return row(i).multiplier == 0; });
  }

  std::vector<KeptFactor::Row> keptRows() const {
    std::vector<KeptFactor::Row> rows(at(n));
    for (Index i = 0; i < n; ++i) {
      rows[at(i)].isSolved = !isKnown(i);
      for (const NormalShare& part : boundParts[at(i)])
        if (isKnown(i) && !isKnown(part.normal) && part.value != 0)
          rows[at(i)].followed.push_back({part.normal, following(i, part.value)});
    }
    return rows;
  }

  // G motionScale
  Matrix allMotions() const {
    Matrix motions(n, k);
    for (Index m = 0; m < k; ++m)
      std::transform(problem.rigid.column(m), problem.rigid.column(m) + n,
                     motions.column(m), [&](double g) { return g * motionScale[at(m)]; });
    return motions;
  }

  Vector solveKept(const Vector& b) const {
    Vector right = knownChanges(b);
    const Vector inRows = rowsAfter(b, right);
    for (Index p = 0; p < count(); ++p)
      right[at(inactive[at(p)])] = inRows[at(p)];
    const Vector rest = balance(b, Vector(at(n), 0.0));
    right.insert(right.end(), rest.begin(), rest.end());
    Vector d = kept->solve(right);
    for (Index m = 0; m < k; ++m)
      d[at(n + m)] *= motionScale[at(m)];
    return d;
  }

  const Complementarity::Value& row(Index i) const { return e.rows[at(i)]; }
  double weight(Index i) const { return equation.weights()[at(i)]; }
  bool isKnown(Index i) const { return position[at(i)] < 0; }
  // Known: dλ_i = b_i/a_i + this dλ_j over the bound's parts.
  double following(Index i, double boundPart) const {
    return -boundPart / row(i).multiplier;
  }
  Index count() const { return static_cast<Index>(inactive.size()); }

  void chooseInactive() {
    position.assign(at(n), -1);
    boundParts.resize(at(n));
    for (Index i = 0; i < n; ++i) {
      const bool known = -row(i).penetration <= 1e-15 * row(i).multiplier;
      if (!known) {
        position[at(i)] = count();
        inactive.push_back(i);
      }
      if (i < problem.normals || row(i).bound == 0)
        continue;
      for (const NormalShare& slope : e.stepBounds[at(i - problem.normals)].slopes) {
        boundParts[at(i)].push_back({slope.normal, row(i).bound * slope.value});
        // A bound that follows an open contact is known, too.
        symmetric = symmetric && isKnown(slope.normal);
      }
    }
    for (const Index i : inactive) {
      const double d = problem.flexibility.isFormed()
                           ? problem.flexibility(i, i) + shift(i)
                           : 1 / weight(i) + shift(i);
      scale.push_back(d > 0 ? 1 / std::sqrt(d) : 1);
    }
  }

  bool boundsFollowKnownRows() const {
    for (Index i = problem.normals; i < n; ++i)
      for (const NormalShare& part : boundParts[at(i)])
        if (!isKnown(i) && part.value != 0)
          return false;
    return true;
  }

  void factorByOperator() {
    Flexibility::Operator::System system;
    system.rows = inactive;
    for (const Index i : inactive)
      system.shifts.push_back(shift(i));
    for (Index i = problem.normals; i < n; ++i)
      for (const NormalShare& part : boundParts[at(i)])
        if (isKnown(i) && !isKnown(part.normal))
          system.followers.push_back({i, part.normal, following(i, part.value)});
        else if (!isKnown(i) && !isKnown(part.normal))
          system.entries.push_back(
              {i, part.normal, part.value / (-row(i).penetration * weight(i))});
    byOperator = problem.flexibility.factor(system);
    const Index c = border.columns();
    solvedBorder = Matrix(n, c);
    schur = Matrix(c, c);
    for (Index j = 0; j < c; ++j) {
      Vector right;
      for (const Index i : inactive)
        right.push_back(heldEntry(i, j));
      const Vector solved = byOperator->solve(right, Vector(at(n), 0.0));
      std::copy(solved.begin(), solved.end(), solvedBorder.column(j));
      for (Index l = 0; l < c; ++l)
        schur(l, j) = forceOn(l, solved);
    }
    pivots.resize(at(c));
    const int size = static_cast<int>(c);
    int info = 0;
    if (c > 0)
      Teuchos::LAPACK<int, double>().GETRF(size, size, schur.data(),
                                           static_cast<int>(schur.stride()),
                                           pivots.data(), &info);
    if (info != 0)
      throw SingularJacobian(
          "singular Newton matrix: nothing balances the rigid motions");
  }

  // The work of a multiplier on a held motion.
  double forceOn(Index motion, const Vector& multiplier) const {
    double sum = 0;
    for (Index i = 0; i < n; ++i)
      if (multiplier[at(i)] != 0)
        sum += heldEntry(i, motion) * multiplier[at(i)];
    return sum;
  }

  Vector solveByOperator(const Vector& b) const {
    const Vector known = knownChanges(b);
    Vector d = byOperator->solve(rowsAfter(b, known), known);
    const Index c = border.columns();
    Vector added = d;
    for (Index i = 0; i < n; ++i)
      added[at(i)] -= known[at(i)];
    const Vector rest = balance(b, known);
    Vector beta;
    for (Index j = 0; j < c; ++j)
      beta.push_back(dot(columnOf(held, j), rest) - forceOn(j, added));
    int info = 0;
    if (c > 0)
      Teuchos::LAPACK<int, double>().GETRS(
          'N', static_cast<int>(c), 1, schur.data(), static_cast<int>(schur.stride()),
          pivots.data(), beta.data(), static_cast<int>(c), &info);
    for (Index j = 0; j < c; ++j)
      for (Index i = 0; i < n; ++i)
        d[at(i)] += beta[at(j)] * solvedBorder(i, j);
    appendMotions(beta.data(), d);
    return d;
  }

  void appendMotions(const double* sizes, Vector& d) const {
    for (Index m = 0; m < k; ++m) {
      double sum = 0;
      for (Index j = 0; j < held.columns(); ++j)
        sum += held(m, j) * sizes[j];
      d.push_back(motionScale[at(m)] * sum);
    }
  }

  // What F's slope by λ itself adds to D_ii once the row is divided by -c ∂F/∂y.
  double shift(Index i) const {
    return row(i).multiplier / (-row(i).penetration * weight(i));
  }

  void splitMotions() {
    motionScale.assign(at(k), 1.0);
    for (Index j = 0; j < k; ++j) {
      double sum = 0;
      for (Index i = 0; i < n; ++i)
        sum += problem.rigid(i, j) * problem.rigid(i, j) * weight(i);
      motionScale[at(j)] = sum > 0 ? 1 / std::sqrt(sum) : 1;
    }
    const Matrix motions = scaledMotions();
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

  // scale G_I motionScale
  Matrix scaledMotions() const {
    Matrix motions(count(), k);
    for (Index m = 0; m < k; ++m)
      for (Index p = 0; p < count(); ++p)
        motions(p, m) =
            scale[at(p)] * problem.rigid(inactive[at(p)], m) * motionScale[at(m)];
    return motions;
  }

  Matrix reducedMatrix(Index size) const {
    Matrix m(size, size);
    for (Index q = 0; q < count(); ++q) {
      const double* column = problem.flexibility.column(inactive[at(q)]);
      for (Index p = 0; p < count(); ++p)
        m(p, q) = scale[at(p)] * scale[at(q)] * column[inactive[at(p)]];
      m(q, q) += scale[at(q)] * scale[at(q)] * shift(inactive[at(q)]);
    }
    return m;
  }

  void factorSymmetric() {
    factor = reducedMatrix(count());
    for (Index j = 0; j < border.columns(); ++j)
      for (Index q = 0; q < count(); ++q)
        for (Index p = 0; p < count(); ++p)
          factor(p, q) += border(p, j) * border(q, j);
    factorPositive(factor, "the contact flexibility of the active coefficients");

    solvedBorder = border.copy();
    for (Index j = 0; j < border.columns(); ++j)
      choleskySolve(factor, solvedBorder.column(j));
    schur = transposedTimes(border, solvedBorder);
    factorPositive(schur, "the balance of the free rigid motions");
  }

  static void factorPositive(Matrix& a, const char* name) {
    const int info = cholesky(a);
    if (info != 0)
      throw SingularJacobian(bem::message(
          "singular Newton matrix: ", name, " is not positive definite (pivot ", info,
          " of ", a.rows(),
          "); two multiplier coefficients may act on the same displacement"));
  }

  void factorGeneral() {
    const Index size = count() + border.columns();
    factor = reducedMatrix(size);
    for (Index j = 0; j < border.columns(); ++j)
      for (Index p = 0; p < count(); ++p) {
        factor(p, count() + j) = -border(p, j);
        factor(count() + j, p) = border(p, j);
      }
    for (Index i = problem.normals; i < n; ++i)
      for (const NormalShare& part : boundParts[at(i)])
        if (!isKnown(part.normal))
          addBound(i, part);
    luFactor(size);
  }

  // What a bound that follows a pressure adds to the matrix: to its own row or, where its
  // coefficient is known, to all others.
  void addBound(Index i, const NormalShare& part) {
    const Index q = position[at(part.normal)];
    if (!isKnown(i)) {
      const Index p = position[at(i)];
      factor(p, q) +=
          scale[at(p)] * scale[at(q)] * part.value / (-row(i).penetration * weight(i));
      return;
    }
    const double coupling = following(i, part.value);
    const double* column = problem.flexibility.column(i);
    for (Index p = 0; p < count(); ++p)
      factor(p, q) += scale[at(p)] * scale[at(q)] * coupling * column[inactive[at(p)]];
    for (Index j = 0; j < border.columns(); ++j)
      factor(count() + j, q) += scale[at(q)] * coupling * heldEntry(i, j);
  }

  // G_i in the scaled held combination j, without the row's own scale.
  double heldEntry(Index i, Index j) const {
    double sum = 0;
    for (Index m = 0; m < k; ++m)
      sum += problem.rigid(i, m) * motionScale[at(m)] * held(m, j);
    return sum;
  }

  void luFactor(Index size) {
    if (size == 0)
      return;
    const Teuchos::LAPACK<int, double> lapack;
    const int m = static_cast<int>(size);
    const int stride = static_cast<int>(factor.stride());
    rowScale.resize(at(size));
    columnScale.resize(at(size));
    int info = 0;
    double least = 0;
    double norm = 0;
    lapack.GEEQU(m, m, factor.data(), stride, rowScale.data(), columnScale.data(), &least,
                 &least, &norm, &info);
    norm = 0;
    for (Index j = 0; j < size && info == 0; ++j) {
      double sum = 0;
      for (Index i = 0; i < size; ++i) {
        factor(i, j) *= rowScale[at(i)] * columnScale[at(j)];
        sum += std::abs(factor(i, j));
      }
      norm = std::max(norm, sum);
    }
    pivots.resize(at(size));
    if (info == 0)
      lapack.GETRF(m, m, factor.data(), stride, pivots.data(), &info);
    double reciprocal = 0;
    if (info == 0) {
      Vector work(at(4 * size));
      std::vector<int> integers(at(size));
      lapack.GECON('1', m, factor.data(), stride, norm, &reciprocal, work.data(),
                   integers.data(), &info);
    }
    if (!(reciprocal > std::numeric_limits<double>::epsilon()))
      throw SingularJacobian(bem::message(
          "singular Newton matrix of Coulomb's problem (reciprocal condition ",
          reciprocal,
          "): at this friction coefficient the solution may not be "
          "unique"));
  }

  // The changes that do not depend on the inactive ones; zero elsewhere.
  Vector knownChanges(const Vector& b) const {
    Vector d(at(n), 0.0);
    for (Index i = 0; i < n; ++i)
      if (isKnown(i)) {
        d[at(i)] = b[at(i)] / row(i).multiplier;
        for (const NormalShare& part : boundParts[at(i)])
          if (isKnown(part.normal))
            d[at(i)] += following(i, part.value) * d[at(part.normal)];
      }
    return d;
  }

  // What is left of the balance of each motion after the known changes.
  Vector balance(const Vector& b, const Vector& known) const {
    Vector rest;
    for (Index j = 0; j < k; ++j) {
      double sum = b[at(n + j)] * equation.balanceScales()[at(j)];
      for (Index i = 0; i < n; ++i)
        sum -= problem.rigid(i, j) * known[at(i)];
      rest.push_back(sum * motionScale[at(j)]);
    }
    return rest;
  }

  // The inactive rows, divided by what D has there, without D times the known changes d.
  Vector rowsAfter(const Vector& b, const Vector& d) const {
    Vector x(at(count()), 0.0);
    for (Index p = 0; p < count(); ++p) {
      const Index i = inactive[at(p)];
      const double m = -row(i).penetration * weight(i);
      x[at(p)] = b[at(i)] / m;
      for (const NormalShare& part : boundParts[at(i)])
        if (isKnown(part.normal))
          x[at(p)] -= part.value / m * d[at(part.normal)];
    }
    return x;
  }

  // The inactive rows after the known changes d, scaled, and then the held balances.
  Vector rightSide(const Vector& b, const Vector& d) const {
    Vector x = rowsAfter(b, d);
    for (Index j = 0; j < n; ++j) {
      const double* column = problem.flexibility.column(j);
      for (Index p = 0; p < count() && d[at(j)] != 0; ++p)
        x[at(p)] -= column[inactive[at(p)]] * d[at(j)];
    }
    for (Index p = 0; p < count(); ++p)
      x[at(p)] *= scale[at(p)];
    const Vector rest = balance(b, d);
    for (Index j = 0; j < border.columns(); ++j)
      x.push_back(dot(columnOf(held, j), rest));
    return x;
  }

  Vector solveOnce(const Vector& b) const {
    if (byOperator != nullptr)
      return solveByOperator(b);
    if (kept != nullptr)
      return solveKept(b);
    Vector d = knownChanges(b);
    Vector x = rightSide(b, d);
    if (symmetric)
      solveSymmetric(x);
    else
      solveGeneral(x);

    for (Index p = 0; p < count(); ++p)
      d[at(inactive[at(p)])] = scale[at(p)] * x[at(p)];
    for (Index i = problem.normals; i < n; ++i)
      for (const NormalShare& part : boundParts[at(i)])
        if (isKnown(i) && !isKnown(part.normal))
          d[at(i)] += following(i, part.value) * d[at(part.normal)];
    appendMotions(x.data() + count(), d);
    return d;
  }

  // M d - Ĝ β = x, Ĝᵀ d = h  is the same as  (M + Ĝ Ĝᵀ) d - Ĝ β = x + Ĝ h, Ĝᵀ d = h.
  void solveSymmetric(Vector& x) const {
    const Index c = border.columns();
    const Vector h(x.begin() + count(), x.end());
    for (Index j = 0; j < c; ++j)
      for (Index p = 0; p < count(); ++p)
        x[at(p)] += border(p, j) * h[at(j)];
    choleskySolve(factor, x.data());
    Vector beta = h;
    for (Index j = 0; j < c; ++j)
      for (Index p = 0; p < count(); ++p)
        beta[at(j)] -= border(p, j) * x[at(p)];
    choleskySolve(schur, beta.data());
    for (Index j = 0; j < c; ++j) {
      for (Index p = 0; p < count(); ++p)
        x[at(p)] += solvedBorder(p, j) * beta[at(j)];
      x[at(count() + j)] = beta[at(j)];
    }
  }

  void solveGeneral(Vector& x) const {
    int info = 0;
    const int size = static_cast<int>(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] *= rowScale[i];
    if (size > 0)
      Teuchos::LAPACK<int, double>().GETRS('N', size, 1, factor.data(),
                                           static_cast<int>(factor.stride()),
                                           pivots.data(), x.data(), size, &info);
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] *= columnScale[i];
  }
};

NewtonSystem::NewtonSystem(const Equation& equation, const Evaluation& at)
    : impl_(std::make_unique<Impl>(equation, at)) {}
NewtonSystem::~NewtonSystem() = default;
NewtonSystem::NewtonSystem(NewtonSystem&&) noexcept = default;

Vector NewtonSystem::solve(const Vector& b) const {
  Vector d = impl_->solveOnce(b);
  if (impl_->byOperator != nullptr)
    return d;  // it refines its own
  for (double last = largestEntry(d);;) {
    Vector defect = impl_->equation.jacobianTimes(impl_->e, d);
    for (std::size_t i = 0; i < b.size(); ++i)
      defect[i] = b[i] - defect[i];
    const Vector correction = impl_->solveOnce(defect);
    bem::axpy(1, correction, d);
    const double change = largestEntry(correction);
    if (impl_->kept == nullptr || change <= enoughOfKept * largestEntry(d))
      return d;
    if (!(change <= 1e-3 * last)) {
      impl_->factorNow();
      impl_->kept.reset();
      return solve(b);
    }
    last = change;
  }
}

Vector NewtonSystem::unheld(const Vector& b) const {
  const Impl& s = *impl_;
  if (s.loose.columns() == 0)
    return {};
  const Vector rest = s.balance(b, s.knownChanges(b));
  Vector direction(at(s.k), 0.0);
  for (Index j = 0; j < s.loose.columns(); ++j) {
    const Vector motion(s.loose.column(j), s.loose.column(j) + s.k);
    const double share = dot(motion, rest);
    for (Index m = 0; m < s.k; ++m)
      direction[at(m)] += s.motionScale[at(m)] * motion[at(m)] * share;
  }
  // Rounding in the balance is no demand.
  double demand = 0;
  for (Index m = 0; m < s.k; ++m)
    demand =
        std::max(demand, std::abs(direction[at(m)]) / s.motionScale[at(m)] /
                             (s.motionScale[at(m)] * s.equation.balanceScales()[at(m)]));
  return demand > 1e-10 * s.problem.stress ? direction : Vector{};
}

}  // namespace epafi::contact
