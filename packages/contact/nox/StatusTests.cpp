#include "contact/nox/StatusTests.hpp"

#include "contact/nox/ContactJacobian.hpp"

#include <NOX_Solver_LineSearchBased.H>

#include <algorithm>
#include <cmath>
#include <utility>

namespace epafi::contact {

namespace {

constexpr double growthLimit = 1e6;
constexpr double mostRounding =
    1e-8;                       // of products with the compressed D of slender bodies
constexpr double isLeft = 0.9;  // of the residual after a step without effect
constexpr double hasFallen = 0.999;  // a cycle repeats its merit up to rounding
constexpr int many = 16;             // set changes; while they halve, that is progress
constexpr std::size_t memory = 4;    // steps in which a coefficient must have changed

std::vector<Index> changing(const std::vector<ContactStates>& sets) {
  std::vector<Index> result;
  const std::size_t begin = sets.size() > memory ? sets.size() - memory : 0;
  for (std::size_t i = 0; i < sets.back().size(); ++i)
    for (std::size_t s = begin; s + 1 < sets.size(); ++s)
      if (sets[s][i] != sets[s + 1][i]) {
        result.push_back(static_cast<Index>(i));
        break;
      }
  return result;
}

}  // namespace

void StepTest::record(const Evaluation& e, Measured measured) {
  run_.last = e.unknowns;
  run_.residual = e.scaled;
  run_.tolerance = e.tolerance;
  run_.merits.push_back(measured.merit);
  if (sets_.empty())
    first_ = e.scaled;
  else
    run_.setChanges.push_back(differences(sets_.back(), e.states));
  if (sets_.empty() || e.scaled < 0.5 * improved_) {
    improved_ = e.scaled;
    progress_ = sets_.size();
  }
  if (!sets_.empty() && run_.setChanges.back() < settling_ / 2) {
    settling_ = run_.setChanges.back();
    if (settling_ >= many)
      progress_ = sets_.size();
  }
  if (sets_.empty() || measured.merit < least_) {
    least_ = measured.merit;
    run_.best = e.unknowns;
  }
  sets_.push_back(e.states);
  run_.changing = changing(sets_);
}

NOX::StatusTest::StatusType StepTest::checkStatus(const NOX::Solver::Generic& solver,
                                                  NOX::StatusTest::CheckType) {
  const auto point = model_->at(solver.getSolutionGroup());
  const Evaluation& e = point->evaluation();
  const Equation& equation = point->equation();
  const Measured measured{e.scaled,
                          std::sqrt(2 * merit(equation, e)) / equation.problem().stress};
  record(e, measured);

  status_ = NOX::StatusTest::Unconverged;
  const auto fail = [&](End end) {
    run_.end = end;
    status_ = NOX::StatusTest::Failed;
  };
  if (!std::isfinite(e.scaled)) {
    fail(End::NotFinite);
  } else if (e.converged) {
    run_.end = End::Converged;
    status_ = NOX::StatusTest::Converged;
  } else {
    const auto& newton = dynamic_cast<const NOX::Solver::LineSearchBased&>(solver);
    if (equation.bound() == Equation::Bound::Differentiated &&
        newton.getStepSize() == 1 && isRounding(e.states, e.scaled)) {
      run_.end = End::Converged;
      run_.tolerance = e.scaled;
      return status_ = NOX::StatusTest::Converged;
    }
    // the same set twice in a row is no cycle: a law that is not piecewise linear bends, and where
    // its slope begins infinite residuals are any number on the way
    const bool bends = !point->equation().problem().surface.places.empty();
    const bool isNew = e.states != std::exchange(last_, e.states);
    const auto before = seen_.find(e.states);
    const bool cycles = isNew && before != seen_.end() &&
                        measured.merit >= hasFallen * before->second.merit &&
                        --patience_.cycles <= 0;
    if (cycles || sets_.size() > progress_ + patience_.steps)
      fail(End::Cycling);
    else if (!bends && e.scaled > growthLimit * std::max(first_, 1.0))
      fail(End::Growth);
    seen_[e.states] = measured;
  }
  return status_;
}

bool StepTest::isRounding(const ContactStates& set, double scaled) const {
  const auto before = seen_.find(set);
  return before != seen_.end() && set == last_ && scaled <= mostRounding &&
         scaled >= isLeft * before->second.residual;
}

std::ostream& StepTest::print(std::ostream& stream, int indent) const {
  return stream << std::string(static_cast<std::size_t>(indent), ' ') << status_
                << "scaled residual = " << run_.residual << " (tolerance "
                << run_.tolerance << ")\n";
}

}  // namespace epafi::contact
