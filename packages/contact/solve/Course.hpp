#pragma once

#include "contact/solve/Report.hpp"

#include <algorithm>
#include <cstddef>

namespace epafi::contact {

/// A solve on its way through a plan: one problem, one report, one budget of steps.
class Course {
 public:
  /// Of how many runs of full length the budget is.
  static constexpr int runs = 20;

  /// `run`: Newton's steps of one run.
  Course(const Problem& problem, const State& start, int run)
      : problem_(problem),
        state_(unpack(problem, pack(problem, start))),
        best_(pack(problem, start)),
        run_(run),
        budget_(runs * run) {}

  const Problem& problem() const { return problem_; }
  const State& state() const { return state_; }
  const Vector& best() const { return best_; }  ///< of Newton's last run
  const Report& report() const { return report_; }

  /// Steps that are left, and how many of them one run may make.
  int left() const { return std::max(budget_ - report_.newtonIterations, 0); }
  int run() const { return std::min(run_, left()); }
  bool isOver() const {
    return report_.converged() || (left() == 0 && !report_.stages.empty());
  }

  /// One more run of Newton's: goes where it ended.  Each of its steps updates a bound
  /// that depends on the pressure.
  void add(Stage stage, const NewtonRun& run);
  /// One more method: goes where it ended; `report` is of this method alone.
  void add(Solution solution);

  /// What comes is no mere Newton's method.
  void globalise() { report_.globalised = true; }

  Solution solution() && { return {std::move(state_), std::move(report_)}; }

 private:
  const Problem& problem_;
  State state_;
  Vector best_;
  Report report_;
  int run_;
  int budget_;
};

/// A row of a plan: when a stage applies and what it does to a course.
template <class CourseOfKind>
struct PlannedStage {
  Stage stage;
  bool (*applies)(const CourseOfKind& course);
  void (*run)(CourseOfKind& course, Stage stage);
};

/// The stages that apply, in order, until one converges or the budget is spent.
template <class CourseOfKind, std::size_t N>
Solution follow(const PlannedStage<CourseOfKind> (&plan)[N], CourseOfKind course) {
  for (const PlannedStage<CourseOfKind>& row : plan)
    if (!course.isOver() && row.applies(course))
      row.run(course, row.stage);
  return std::move(course).solution();
}

}  // namespace epafi::contact
