#include "contact/solve/Course.hpp"

#include <utility>

namespace epafi::contact {

void Course::add(Stage stage, const NewtonRun& run) {
  report_ = extended(std::move(report_), stage, run, problem_);
  if (problem_.boundDependsOnPressure())
    report_.coulombIterations += run.iterations;
  best_ = run.best;
  state_ = unpack(problem_, report_.converged() ? run.last : run.best);
}

void Course::add(Solution solution) {
  state_ = std::move(solution.state);
  report_ = joined(std::move(solution.report), report_);
}

}  // namespace epafi::contact
