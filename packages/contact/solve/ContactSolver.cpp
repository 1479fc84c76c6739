#include "contact/solve/ContactSolver.hpp"

#include "contact/equation/Equilibrium.hpp"
#include "contact/newton/OffsetPath.hpp"
#include "contact/newton/Sweeps.hpp"

#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <limits>

namespace epafi::contact {

using bem::Kind;
using bem::Row;

Solution NonlinearSolver::solve(const Problem& problem, const State& start) const {
  problem.check();
  requireEquilibrium(problem);
  return solveSound(problem, start);
}

void ContactSolverOptions::keys(bem::Keys& keys) {
  keys.add(&tolerance, "Tolerance", "1", {0, 1, true, true},
           "residual, relative to the load");
  keys.add(&maximumIterations, "Maximum Iterations", "1", bem::from(1),
           "Newton steps of one run; where one does not suffice, complementary pivoting "
           "follows, for at most some four times as many, twelve where surfaces yield by "
           "curves");
}

namespace {

/// One problem, one equation, one report.
class Stages {
 public:
  Stages(const ContactSolver& solver, const Problem& problem, State start,
         Equation::Bound bound)
      : solver_(solver),
        problem_(problem),
        equation_(problem, bound, solver.options().tolerance),
        sharp_(problem, Equation::Bound::Differentiated, solver.options().tolerance),
        state_(std::move(start)) {}

  void fullSteps(int most) {
    const bool knowsSets = isDifferentiated() &&
                           std::any_of(state_.multiplier.begin(), state_.multiplier.end(),
                                       [](double x) { return x != 0; });
    const Vector start = pack(problem_, state_);
    add(Stage::FullSteps,
        solver_.newton().run(equation_, knowsSets ? smoothed(equation_, start) : start,
                             most));
    if (!problem_.boundDependsOnPressure())
      requireSolvable();
  }

  void followOffset() {
    if (!problem_.flexibility.isFormed())
      return followFormedOffset();
    constexpr int price = 3;  // of as many pivots as there are coefficients
    const int run = solver_.options().maximumIterations;
    constexpr int directions = 4;
    const bool linear = problem_.surface.places.empty();
    const int paths = linear ? directions : 3 * directions;
    const int polishing = linear ? 12 : run;
    const Index size = std::max<Index>(1, problem_.size());
    const double work = workOfPivot(size);
    double left = solver_.options().mostWork;
    // Where free motions are placed by springs, or a bound was a polygon's, a second path
    // begins at the first one's end or from another direction.  Paths of laws that are not linear
    // have the tangents of the best state, and at last, as that may not change, of the last end.
    Vector placement = state_.rigid;
    Vector reached;
    for (int direction = 0; direction < paths && !converged(); ++direction) {
      const auto mostPivots = static_cast<int>(
          std::min({static_cast<double>(run) * static_cast<double>(size) / price,
                    left / work, 1.0 * std::numeric_limits<int>::max()}));
      const OffsetPath path = contact::followOffset(
          sharp_.withTangent(sharp_.at(direction < directions || reached.empty()
                                           ? pack(problem_, state_)
                                           : reached)),
          placement, direction, mostPivots, solver_.watch());
      left -= path.pivots * work;
      if (!path.unknowns.empty()) {
        NewtonRun last =
            solver_.newton().run(sharp_, path.unknowns, std::min(polishing, run));
        last.iterations += static_cast<int>(price * path.pivots / size);
        add(Stage::FollowOffset, last);
        placement = unpack(problem_, path.unknowns).rigid;
        reached = path.unknowns;
      }
      if (!converged() && left < work)
        return end(End::TooLong);
    }
  }

  bool converged() const { return report_.converged(); }
  bool isDifferentiated() const {
    return equation_.bound() == Equation::Bound::Differentiated;
  }
  Solution solution() && { return {std::move(state_), std::move(report_)}; }

 private:
  void add(Stage stage, const NewtonRun& run) {
    report_ = extended(std::move(report_), stage, run, problem_);
    if (problem_.boundDependsOnPressure())
      report_.coulombIterations += run.iterations;
    state_ = unpack(problem_, converged() ? run.last : run.best);
  }

  // Of what is not tried, or no longer.
  void end(End why) {
    report_.stages.push_back({Stage::FollowOffset, 0, report_.residual, why});
  }

  // Products in a tree have fewer digits than Newton's last steps want here, so that the
  // solve goes on with the entries.
  void followFormedOffset() {
    if (problem_.size() > ContactSolver::mostToPivot)
      return end(End::TooLarge);
    Problem formed = problem_.copy();
    formed.flexibility = problem_.flexibility.formed();
    Stages there(solver_, formed, std::move(state_), equation_.bound());
    there.followOffset();
    state_ = std::move(there.state_);
    report_ = joined(std::move(there.report_), report_);
  }

  /// Without rigid motions D is definite, and so are all matrices of Newton's; a motion that
  /// bounded friction does not hold, and pressure not at all, is a proof.
  void requireSolvable() const {
    const End end = report_.stages.back().end;
    if (end == End::NoBalance)
      throw NoBalance(report_.failure);
    if (end == End::Singular && isDifferentiated() && problem_.rigidMotions() == 0)
      throw bem::NumericalError(report_.failure);
  }

  const ContactSolver& solver_;
  const Problem& problem_;
  Equation equation_;
  Equation sharp_;  // the same with the bound differentiated
  State state_;
  Report report_;
};

}  // namespace

Solution ContactSolver::inStages(const Problem& problem, const State& start,
                                 Equation::Bound bound, int steps) const {
  Stages stages(*this, problem, start, bound);
  stages.fullSteps(steps);
  if (!stages.converged())
    stages.followOffset();
  return std::move(stages).solution();
}

Solution ContactSolver::solveSound(const Problem& problem, const State& start) const {
  return inStages(problem, start, Equation::Bound::Differentiated,
                  options().maximumIterations);
}

}  // namespace epafi::contact
