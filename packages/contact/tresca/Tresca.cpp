#include "contact/tresca/Tresca.hpp"

#include "contact/equation/Equilibrium.hpp"
#include "contact/newton/OffsetPath.hpp"
#include "contact/newton/Sweeps.hpp"

#include <Teuchos_ParameterList.hpp>

#include <algorithm>

namespace epafi::contact {

using bem::Kind;
using bem::Row;

bem::SchemaRows trescaRows() {
  const TrescaOptions defaults;
  return {
      Row("Complementarity", Kind::Text,
          "the equation that says contact or gap; " + meanings(complementarities()))
          .standard(defaults.complementarity)
          .allowed(complementarities().names()),
      Row("Tolerance", Kind::Real, "residual, relative to the load")
          .unit("1")
          .standard(defaults.tolerance)
          .range({0, 1, true, true}),
      Row("Maximum Iterations", Kind::Whole,
          bem::message(
              "Newton steps of one run; where one does not suffice, other methods "
              "follow, for about ",
              Course::runs, " times as many, and steps of the load for as many"))
          .unit("1")
          .standard(defaults.maximumIterations)
          .range(bem::from(1)),
  };
}

TrescaOptions parseTresca(const Teuchos::ParameterList& list) {
  return {list.get<std::string>("Complementarity"), list.get<double>("Tolerance"),
          list.get<int>("Maximum Iterations")};
}

NewtonCourse::NewtonCourse(const Problem& problem, const State& start,
                           const Tresca& tresca, Equation::Bound bound)
    : Course(problem, start, tresca.options().maximumIterations),
      tresca_(tresca),
      equation_(problem, complementarities().at(tresca.options().complementarity), bound,
                tresca.options().tolerance),
      sharp_(problem, projection(), Equation::Bound::Differentiated,
             tresca.options().tolerance),
      start_(start),
      hasStart_(std::any_of(start.multiplier.begin(), start.multiplier.end(),
                            [](double x) { return x != 0; })) {}

void NewtonCourse::steps(Stage stage, int most) {
  add(stage, tresca_.newton().run(equation_, pack(problem(), state()),
                                  std::min(most, left())));
}

void NewtonCourse::pivoting(Stage stage, const Equation& equation, const Vector& from) {
  add(stage, tresca_.newton().run(equation, smoothed(equation, from), run()));
}

void NewtonCourse::followOffset(Stage stage) {
  constexpr int polishing = 12;
  constexpr int directions = 4;
  constexpr int price = 3;  // of as many pivots as there are coefficients
  globalise();
  if (!problem().flexibility.isFormed()) {
    // Products in a tree have fewer digits than Newton's last steps want here.
    Problem formed = problem().copy();
    formed.flexibility = problem().flexibility.formed();
    NewtonCourse there(formed, state(), tresca_, equation_.bound());
    there.followOffset(stage);
    return add(std::move(there).solution());
  }
  const auto size = static_cast<int>(problem().size());
  Vector placement = state().rigid;
  for (int direction = 0; direction < directions && !isOver(); ++direction) {
    const OffsetPath path =
        contact::followOffset(problem(), placement, direction, run() * size / price);
    if (path.unknowns.empty())
      continue;
    NewtonRun last = tresca_.newton().run(sharp(), path.unknowns, std::min(polishing, run()));
    last.iterations += price * path.pivots / size;
    add(stage, last);
    placement = unpack(problem(), path.unknowns).rigid;
  }
}

namespace {

/// Without rigid motions D is definite, and so are all matrices of Newton's; a motion that
/// bounded friction does not hold, and pressure not at all, is a proof.
void requireSolvable(const NewtonCourse& course) {
  const Report& report = course.report();
  if (report.stages.back().end == End::NoBalance)
    throw NoBalance();
  if (report.stages.back().end == End::Singular && course.equation().hasActiveSets() &&
      course.problem().rigidMotions() == 0)
    throw bem::NumericalError(report.said);
}

bool always(const NewtonCourse&) { return true; }
bool startsAfar(const NewtonCourse& course) { return !course.knowsSets(); }
bool knowsSets(const NewtonCourse& course) { return course.knowsSets(); }

void fullSteps(NewtonCourse& course, Stage stage) {
  course.steps(stage, course.run());
  requireSolvable(course);
}

void pivoting(NewtonCourse& course, Stage stage) {
  const bool first = course.report().stages.empty();
  course.pivoting(stage, course.sharp(), course.best());
  if (first)
    requireSolvable(course);
}

void followOffset(NewtonCourse& course, Stage stage) { course.followOffset(stage); }

constexpr PlannedStage<NewtonCourse> trescaPlan[] = {
    {Stage::FullSteps, startsAfar, fullSteps},
    {Stage::Pivoting, knowsSets, pivoting},
    {Stage::FollowOffset, always, followOffset},
    {Stage::Pivoting, startsAfar, pivoting},
};

}  // namespace

Solution Tresca::solveSound(const Problem& problem, const State& start) const {
  return follow(trescaPlan,
                NewtonCourse(problem, start, *this, Equation::Bound::Differentiated));
}

}  // namespace epafi::contact
