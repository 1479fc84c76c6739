#include "contact/problem/ContactProblem.hpp"

#include "bem/algebra/Blas.hpp"
#include "bem/base/Error.hpp"
#include "contact/problem/BalancedStiffness.hpp"
#include "contact/problem/Coupling.hpp"
#include "contact/problem/Loads.hpp"
#include "contact/problem/Obstacle.hpp"
#include "contact/problem/Refinement.hpp"
#include "contact/problem/RigidConstraints.hpp"
#include "contact/problem/SmallAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi::contact {

using bem::DenseAlgebra;
using bem::Rows;

namespace {

/// Clamped rows and columns become those of the identity, and every allowed rigid motion
/// gets the stiffness of its functional, which makes A positive definite:  A + Σ c cᵀ.
Matrix constrain(Matrix lower, const Rows& mine, const Loads& loads,
                 const RigidConstraints& rigid) {
  const auto diagonal = [&](Index j) { return std::max<Index>(0, j - mine.begin); };
  for (Index j = 0; j < lower.columns(); ++j)
    for (Index i = diagonal(j); i < lower.rows(); ++i) {
      const Index row = i + mine.begin;
      if (loads.clamped[static_cast<std::size_t>(row)] != 0 ||
          loads.clamped[static_cast<std::size_t>(j)] != 0)
        lower(i, j) = row == j ? 1 : 0;
    }
  for (Index k = 0; k < rigid.functionals.columns(); ++k) {
    const double* c = rigid.functionals.column(k);
    for (Index j = 0; j < lower.columns(); ++j)
      for (Index i = diagonal(j); i < lower.rows(); ++i)
        lower(i, j) += c[i + mine.begin] * c[j];
  }
  return lower;
}

/// Rows of clamped unknowns set to zero.
void clearClamped(Matrix& rows, const Rows& mine, const Loads& loads) {
  for (Index j = 0; j < rows.columns(); ++j)
    for (Index i = 0; i < rows.rows(); ++i)
      if (loads.clamped[static_cast<std::size_t>(i + mine.begin)] != 0)
        rows(i, j) = 0;
}

/// What rounding has left of a correction; it is a force where |A| is large.  Not more,
/// or reactions would no longer say what u is worth.
Vector onlyRounding(Vector correction, const Vector& u) {
  const double limit = roundingOfCorrections * largestEntry(u);
  for (double& x : correction)
    x = std::clamp(x, -limit, limit);
  return correction;
}

double largestEigenvalue(Matrix symmetric) {
  const int n = static_cast<int>(symmetric.rows());
  const int ld = static_cast<int>(symmetric.stride());
  Vector values(static_cast<std::size_t>(n));
  Vector work(static_cast<std::size_t>(std::max(1, 34 * n)));
  const int size = static_cast<int>(work.size());
  int info = 0;
  dsyev_("N", "L", &n, symmetric.data(), &ld, values.data(), work.data(), &size, &info);
  return info == 0 && n > 0 ? values.back() : 0;
}

}  // namespace

struct ContactProblem::Parts {
  Problem numbers;
  MultiplierSpace multiplier;
  Loads loads;
  RigidConstraints rigid;
  std::unique_ptr<bem::CholeskyFactor> factor;  ///< of A, constrained: L Lᵀ
  const bem::SteklovPoincare* operators;
  const DenseAlgebra* algebra;
  Index unknowns = 0;

  Vector load;      ///< f - A u_D on the unclamped unknowns
  Vector constant;  ///< u_D and what Fix makes of it

  Vector gap;
  Coupling coupling;
  double gamma0;
  BalancedStiffness stiffness;

  /// The unclamped, non-rigid displacement under a force: A⁻¹ f of doc/theory/contact.md.
  Vector respond(Vector force) const {
    for (std::size_t j = 0; j < force.size(); ++j)
      if (loads.clamped[j] != 0)
        force[j] = 0;
    Vector u = factor->solve(force);
    for (Index k = 0; k < rigid.allowed.columns(); ++k) {
      const Vector r = columnOf(rigid.allowed, k);
      axpy(-dot(r, force), r, u);
    }
    return u;
  }

  /// The contact problem in numbers: u = S⁻¹ (f - Bᵀ λ) put into the contact conditions.
  Problem condensed(Obstacle obstacle) const;

  /// f - Bᵀ λ.
  Vector force(const Vector& f, const State& state) const {
    Vector force = f;
    if (!state.multiplier.empty())
      axpy(-1, coupling.push(*algebra, state.multiplier), force);
    return force;
  }
};

namespace {

/// B u for a replicated displacement.
Vector pull(const DenseAlgebra& algebra, const Matrix& couplingTransposed,
            const Vector& u) {
  const Rows mine = algebra.myRows(static_cast<Index>(u.size()));
  Vector result(static_cast<std::size_t>(couplingTransposed.columns()));
  for (Index i = 0; i < couplingTransposed.columns(); ++i)
    for (Index j = 0; j < mine.size(); ++j)
      result[static_cast<std::size_t>(i)] +=
          couplingTransposed(j, i) * u[static_cast<std::size_t>(j + mine.begin)];
  return algebra.sum(std::move(result));
}

/// The same for the columns of a matrix.
Matrix pullColumns(const DenseAlgebra& algebra, const Matrix& couplingTransposed,
                   const Matrix& u) {
  Matrix result(couplingTransposed.columns(), u.columns());
  for (Index k = 0; k < u.columns(); ++k) {
    const Vector b = pull(algebra, couplingTransposed, columnOf(u, k));
    std::copy(b.begin(), b.end(), result.column(k));
  }
  return result;
}

/// S - S^ = S - X Xᵀ.  One process takes a panel of X at a time, which saves its memory;
/// several would exchange the whole sum for every panel.
Matrix subtractStabilisation(const DenseAlgebra& algebra, Matrix a,
                             const Coupling& coupling) {
  const Index columns = coupling.stabilisationColumns();
  const Index width = algebra.processes() == 1 ? 256 : std::max<Index>(1, columns);
  for (Index first = 0; first < columns; first += width)
    a = algebra.addOuter(
        std::move(a), coupling.stabilisationHalf(first, std::min(first + width, columns)),
        -1);
  return a;
}

/// See limitGamma0.
double limit(const ContactProblem::Input& input, const Coupling& coupling,
             const Loads& loads, const RigidConstraints& rigid) {
  const DenseAlgebra& algebra = input.stiffness.algebra();
  const Rows mine = algebra.myRows(input.space.displacements());
  const auto stiffness = algebra.cholesky(
      constrain(input.stiffness.stiffness().unpacked(), mine, loads, rigid), "S");
  Matrix half = coupling.stabilisationHalf(0, coupling.stabilisationColumns());
  clearClamped(half, mine, loads);
  const Matrix reduced = stiffness->forward(std::move(half));
  const Index columns = reduced.columns();
  const Rows mineOfColumns = algebra.myRows(columns);
  const Matrix gram = algebra.replicate(
      algebra.addGram(Matrix(mineOfColumns.size(), columns), reduced), columns);
  const double largest = largestEigenvalue(gram.copy());
  return algebra.broadcast({input.stabilization.firstGamma0() / largest}).front();
}

/// The factor of A, constrained, and what else of A is needed.
struct Factorised {
  std::unique_ptr<bem::CholeskyFactor> factor;
  Vector load;  ///< f - A u_D
};

/// \throws bem::NumericalError if A is not definite.
Factorised factorise(const ContactProblem::Input& input, const Coupling& coupling,
                     const Loads& loads, const RigidConstraints& rigid) {
  const DenseAlgebra& algebra = input.stiffness.algebra();
  const Rows mine = algebra.myRows(input.space.displacements());
  Matrix a =
      subtractStabilisation(algebra, input.stiffness.stiffness().unpacked(), coupling);
  Vector load = loads.load;
  axpy(-1, algebra.multiplySymmetric(a, loads.prescribed), load);
  return {algebra.cholesky(constrain(std::move(a), mine, loads, rigid),
                           "the stiffness matrix"),
          std::move(load)};
}

/// The γ₀ with which A is definite for sure where the first choice has failed.
/// \throws IndefiniteStiffness if the choice was the user's.
double safeGamma0(const ContactProblem::Input& input, const Coupling& coupling,
                  const Loads& loads, const RigidConstraints& rigid) {
  const double first = input.stabilization.firstGamma0();
  const double definiteBelow = limit(input, coupling, loads, rigid);
  if (input.stabilization.gamma0)
    throw IndefiniteStiffness(first, definiteBelow);
  return std::min(first, definiteBelow) / 4;
}

Matrix rowsOf(const Matrix& a, const Rows& mine) {
  Matrix rows(mine.size(), a.columns());
  for (Index j = 0; j < a.columns(); ++j)
    std::copy_n(a.column(j) + mine.begin, mine.size(), rows.column(j));
  return rows;
}

/// D = B A⁻¹ Bᵀ + M - Σ (B r)(B r)ᵀ, full and on every process; half = L⁻¹ Bᵀ.
Matrix condense(const DenseAlgebra& algebra, const Matrix& half, Matrix mass,
                const Matrix& coupledRigid) {
  const Index m = half.columns();
  const Rows mine = algebra.myRows(m);
  Matrix lower = mine.size() == m ? std::move(mass) : rowsOf(mass, mine);
  for (Index k = 0; k < coupledRigid.columns(); ++k)
    for (Index j = 0; j < m; ++j)
      for (Index i = 0; i < mine.size(); ++i)
        lower(i, j) -= coupledRigid(i + mine.begin, k) * coupledRigid(j, k);
  Matrix d = algebra.replicate(algebra.addGram(std::move(lower), half), m);
  for (Index j = 0; j < m; ++j)
    for (Index i = j + 1; i < m; ++i)
      d(j, i) = d(i, j);
  return d;
}

/// What Fix makes of the prescribed displacement: the whole of u has no mean motion.
Vector withoutFixedMotions(const RigidModes& modes, const RigidConstraints& rigid,
                           const Vector& prescribed) {
  Vector result = prescribed;
  for (Index k = 0; k < rigid.fixed(); ++k) {
    const Vector functional = columnOf(modes.functionals, rigid.fixedModes[at(k)]);
    axpy(-dot(functional, prescribed), columnOf(rigid.allowed, k), result);
  }
  return result;
}

}  // namespace

IndefiniteStiffness::IndefiniteStiffness(double used, double limit)
    : bem::NumericalError(
          bem::message("the stabilised stiffness S - S^ is not positive definite: "
                       "Discretization->Stabilization->",
                       "Gamma0 = ", used, " is too large for this mesh; below ", limit,
                       " it is definite, and a quarter of that is safe")),
      gamma0(used),
      limitGamma0(limit) {}

double limitGamma0(const ContactProblem::Input& input) {
  const Loads loads = makeLoads(input.space, input.conditions, input.units);
  const MultiplierSpace multiplier(input.space.mesh(), input.basis, input.conditions);
  const Coupling coupling = makeCoupling(input, multiplier);
  if (coupling.stabilisationColumns() == 0)
    return std::numeric_limits<double>::infinity();
  return limit(
      input, coupling, loads,
      makeRigidConstraints(makeRigidModes(input.space), loads, input.conditions.fix));
}

ContactProblem::ContactProblem(const Input& input) {
  if (input.basis.sharesNodes && input.stabilization.form != Stabilization::Form::None)
    throw bem::InputError(bem::message("the multiplier '", input.basis.name,
                                       "' needs the stabilisation's form None"));
  const DenseAlgebra& algebra = input.stiffness.algebra();

  Loads loads = makeLoads(input.space, input.conditions, input.units);
  RigidModes modes = makeRigidModes(input.space);
  RigidConstraints rigid = makeRigidConstraints(modes, loads, input.conditions.fix);
  MultiplierSpace multiplier(input.space.mesh(), input.basis, input.conditions);
  Coupling coupling = makeCoupling(input, multiplier);
  Obstacle obstacle = makeObstacle(input.space.mesh(), multiplier, input.units);

  const bool stabilised = coupling.stabilisationColumns() > 0;
  double gamma0 = stabilised || coupling.response ? input.stabilization.firstGamma0() : 0;
  Factorised factorised;
  try {
    factorised = factorise(input, coupling, loads, rigid);
  } catch (const bem::NumericalError&) {
    if (!stabilised)
      throw;
  }
  if (!factorised.factor) {
    gamma0 = safeGamma0(input, coupling, loads, rigid);
    coupling.weaken(gamma0 / input.stabilization.firstGamma0());
    factorised = factorise(input, coupling, loads, rigid);
  }

  Vector constant = withoutFixedMotions(modes, rigid, loads.prescribed);
  BalancedStiffness stiffness(input.stiffness, std::move(modes), coupling);

  parts_ = std::make_unique<Parts>(Parts{{},
                                         std::move(multiplier),
                                         std::move(loads),
                                         std::move(rigid),
                                         std::move(factorised.factor),
                                         &input.stiffness,
                                         &algebra,
                                         input.space.displacements(),
                                         std::move(factorised.load),
                                         std::move(constant),
                                         std::move(obstacle.gap),
                                         std::move(coupling),
                                         gamma0,
                                         std::move(stiffness)});
  parts_->numbers = parts_->condensed(std::move(obstacle));
}

Problem ContactProblem::Parts::condensed(Obstacle obstacle) const {
  Problem problem;
  const Index m = multiplier.size();
  Matrix transposed = coupling.transposed(*algebra);
  const Matrix coupledRigid = pullColumns(*algebra, transposed, rigid.allowed);
  Vector u = respond(load);
  axpy(1, constant, u);
  problem.offset = pull(*algebra, transposed, u);
  for (std::size_t i = 0; i < gap.size(); ++i)
    problem.offset[i] -= gap[i];
  clearClamped(transposed, algebra->myRows(unknowns), loads);
  problem.flexibility = condense(*algebra, factor->forward(std::move(transposed)),
                                 coupling.multiplierMass(), coupledRigid);
  problem.normals = multiplier.normals();
  problem.tangentials = std::move(obstacle.tangentials);

  const Index fixed = rigid.fixed();
  problem.rigid = Matrix(m, rigid.free());
  for (Index k = 0; k < rigid.free(); ++k) {
    std::copy_n(coupledRigid.column(fixed + k), m, problem.rigid.column(k));
    problem.rigidLoad.push_back(dot(columnOf(rigid.allowed, fixed + k), load));
  }
  // dimensionless: strains and stresses are of one size
  const double size =
      loads.largestTraction + loads.largestDisplacement + obstacle.largestPenetration;
  problem.stress = size > 0 ? size : 1;
  if (const auto amplification = multiplier.basis().amplification)
    for (const auto& element : multiplier.elements())
      problem.amplification =
          std::max(problem.amplification, amplification(element.degree));
  return problem;
}

ContactProblem::~ContactProblem() = default;
ContactProblem::ContactProblem(ContactProblem&&) noexcept = default;

const Problem& ContactProblem::numbers() const { return parts_->numbers; }
const MultiplierSpace& ContactProblem::multiplier() const { return parts_->multiplier; }
const Vector& ContactProblem::gap() const { return parts_->gap; }
const Vector& ContactProblem::load() const { return parts_->loads.load; }
double ContactProblem::gamma0() const { return parts_->gamma0; }
double ContactProblem::gamma(std::size_t contactElement) const {
  return parts_->coupling.gamma[contactElement];
}

Vector ContactProblem::displacement(const State& state) const {
  const Parts& parts = *parts_;
  Vector u = parts.respond(parts.force(parts.load, state));
  axpy(1, parts.constant, u);
  for (Index k = 0; k < static_cast<Index>(state.rigid.size()); ++k)
    axpy(state.rigid[static_cast<std::size_t>(k)],
         columnOf(parts.rigid.allowed, parts.rigid.fixed() + k), u);
  // What the factor leaves is ε |A| |u|.
  const Vector force = parts.force(parts.loads.load, state);
  return refined(std::move(u), [&](const Vector& now) {
    return parts.respond(parts.stiffness.residual(force, now));
  });
}

Vector ContactProblem::density(const State& state, const Vector& displacement) const {
  const Parts& parts = *parts_;
  if (parts.coupling.response == nullptr)
    return parts.operators->density(displacement);
  return parts.operators->density(displacement,
                                  parts.coupling.weighted(state.multiplier));
}

// With w = N λ:  uᵀ A u - 2 uᵀ R w + wᵀ X w - ψᵀ G ψ, which has no differences of what grows
// as ν -> 1/2 while γ is there.
double ContactProblem::strainEnergy(const State& state,
                                    const Vector& displacement) const {
  const Parts& parts = *parts_;
  double twice = dot(displacement, parts.operators->apply(displacement));
  const Coupling& coupling = parts.coupling;
  if (coupling.response == nullptr)
    return 0.5 * twice;
  const Vector w = coupling.weighted(state.multiplier);
  const Matrix& x = coupling.response->density;
  twice -= 2 * dot(displacement,
                   parts.algebra->multiply(*coupling.columns, parts.unknowns, w));
  for (Index j = 0; j < x.columns(); ++j)
    for (Index i = 0; i < x.rows(); ++i)
      twice += w[at(i)] * x(i, j) * w[at(j)];
  const Vector psi = density(state, displacement);
  for (std::size_t k = 0; k < coupling.compliance.size(); ++k) {
    const double value = psi[at(coupling.response->densities[k])];
    twice -= coupling.compliance[k] * value * value;
  }
  return 0.5 * twice;
}

bool ContactProblem::byDensity() const { return parts_->coupling.response != nullptr; }

bem::Vec2 ContactProblem::meanSlack(std::size_t contactElement, const State& state,
                                    const Vector& density) const {
  const Coupling& coupling = parts_->coupling;
  if (coupling.response == nullptr)
    return {};
  // P_0 is 1: its rows of N λ and of G ψ are integrals
  const Vector w = coupling.weighted(state.multiplier);
  const Index first = coupling.start[contactElement];
  const auto integral = [&](Index k) {
    return w[at(k)] +
           coupling.compliance[at(k)] * density[at(coupling.response->densities[at(k)])];
  };
  const double length = coupling.compliance[at(first)] / coupling.gamma[contactElement];
  return (1 / length) * bem::Vec2{integral(first), integral(first + 1)};
}

Vector ContactProblem::clampWork(const State& state, const Vector& displacement) const {
  const Parts& parts = *parts_;
  const RigidModes& modes = parts.stiffness.modes();
  Vector work(3, 0.0);
  if (std::none_of(parts.loads.clamped.begin(), parts.loads.clamped.end(),
                   [](char clamped) { return clamped != 0; }))
    return work;
  Vector rest =
      parts.stiffness.residual(parts.force(parts.loads.load, state), displacement);
  rest = parts.stiffness.residual(rest, onlyRounding(parts.respond(rest), displacement));
  for (std::size_t i = 0; i < rest.size(); ++i)
    for (Index k = 0; k < 3 && parts.loads.clamped[i] != 0; ++k)
      work[static_cast<std::size_t>(k)] -=
          rest[i] * modes.motions(static_cast<Index>(i), k);
  work[2] += modes.centroid.x * work[1] - modes.centroid.y * work[0];
  return work;
}

Vector ContactProblem::fixedReactions(const State& state) const {
  const Parts& parts = *parts_;
  const Vector force = parts.force(parts.load, state);
  Vector reactions(3, 0.0);
  for (Index k = 0; k < parts.rigid.fixed(); ++k)
    reactions[static_cast<std::size_t>(
        parts.rigid.fixedModes[static_cast<std::size_t>(k)])] =
        -dot(columnOf(parts.rigid.allowed, k), force);
  return reactions;
}

}  // namespace epafi::contact
