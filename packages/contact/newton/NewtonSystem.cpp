#include "contact/newton/NewtonSystem.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/body/IterativeRefinement.hpp"
#include "contact/newton/Factoring.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::contact {

using bem::dot;

namespace {

// How much of a solution by a kept factor its last refinement may change; another one would
// change the square of it.
constexpr double enoughOfKept = 1e-7;
// What a refinement by a kept factor has to leave of the one before.
constexpr double progressOfKept = 1e-3;

}  // namespace

NewtonSystem::NewtonSystem(const Equation& equation, const LinearRows& at,
                           FactorMemory* memory)
    : reduction_(equation, at) {
  if (!reduction_.problem.flexibility.isFormed())
    byOperator_ = operatorFactoring(reduction_);
  else if (memory != nullptr)
    byKept_ = keptFactoring(reduction_, *memory);
  if (byOperator_ == nullptr && byKept_ == nullptr)
    byEntries_ = denseFactoring(reduction_);
}

double NewtonSystem::refine(const Factoring& factoring, const Vector& b,
                            Vector& d) const {
  Vector defect = reduction_.equation.jacobianTimes(reduction_.e, d);
  for (std::size_t i = 0; i < b.size(); ++i)
    defect[i] = b[i] - defect[i];
  const Vector correction = factoring.solve(defect);
  bem::axpy(1, correction, d);
  return largestEntry(correction);
}

Vector NewtonSystem::solve(const Vector& b) const {
  if (byOperator_ != nullptr) {
    Vector d = byOperator_->solve(b);
    refine(*byOperator_, b, d);
    return d;
  }
  if (byEntries_ == nullptr) {
    Vector d = byKept_->solve(b);
    double last = largestEntry(d);
    for (bool converges = true; converges;) {
      const double change = refine(*byKept_, b, d);
      if (change <= enoughOfKept * largestEntry(d))
        return d;
      converges = change <= progressOfKept * last;
      last = change;
    }
    byEntries_ = denseFactoring(reduction_);
  }
  Vector d = byEntries_->solve(b);
  refine(*byEntries_, b, d);
  return d;
}

Vector NewtonSystem::unheld(const Vector& b) const {
  const Reduction& r = reduction_;
  if (r.loose.columns() == 0)
    return {};
  const Vector rest = r.balance(b, r.knownChanges(b));
  Vector direction(at(r.k), 0.0);
  for (Index j = 0; j < r.loose.columns(); ++j) {
    const Vector motion = columnOf(r.loose, j);
    const double share = dot(motion, rest);
    for (Index m = 0; m < r.k; ++m)
      direction[at(m)] += r.motionScale[at(m)] * motion[at(m)] * share;
  }
  // Rounding in the balance is no demand.
  double demand = 0;
  for (Index m = 0; m < r.k; ++m)
    demand =
        std::max(demand, std::abs(direction[at(m)]) / r.motionScale[at(m)] /
                             (r.motionScale[at(m)] * r.equation.balanceScales()[at(m)]));
  return demand > 1e-10 * r.problem.stress ? direction : Vector{};
}

}  // namespace epafi::contact
