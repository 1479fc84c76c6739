#include "contact/solve/DefectCorrection.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/equation/Equation.hpp"
#include "contact/newton/NewtonSystem.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::contact {

namespace {

// Of r over the deformation: what is left as it is, and where steps end.
constexpr double enough = 1e-10;
constexpr double goal = 1e-12;
// Of F over the load: more comes of coefficients in a wrong state.
constexpr double consistent = 1e-8;
// What a step has to leave of r for another one to be worth it.
constexpr double progress = 0.1;
constexpr int mostSteps = 20;

/// A configuration with its defect, and the conditions there.
struct Point {
  Configuration at;
  Evaluation evaluation;
  double missed = 0;  ///< r over the deformation
  bool isSolution = false;
};

/// The largest displacement, less the body's rigid motion.  \param alpha  of its first free one
double deformationOf(const ContactBody& body, const double* alpha, Vector u) {
  if (const Vector& rigid = body.loads().rigidPart; !rigid.empty())
    bem::axpy(-1, rigid, u);
  const Holding& holding = body.holding();
  for (Index k = 0; k < holding.free(); ++k)
    bem::axpy(-alpha[k], columnOf(holding.allowed, holding.fixed() + k), u);
  return bem::largestEntry(u);
}

Point pointOf(const ContactSystem& system, const Equation& equation,
              const bem::Processes& processes, State state) {
  Configuration at = system.placed(std::move(state));
  const Vector& r = at.penetration;
  const Vector lengths = system.multiplier().lengths();
  Evaluation e = equation.at(pack(system.numbers(), at.state), r);
  double displacement = 0;
  double deformation = 0;
  const double* alpha = at.state.rigid.data();
  for (std::size_t b = 0; b < system.size(); ++b) {
    const Vector& u = at.displacements[b];
    displacement = std::max(displacement, bem::largestEntry(u));
    deformation = std::max(deformation, deformationOf(system.body(b), alpha, u));
    alpha += system.body(b).holding().free();
  }
  Vector open(r.size());
  for (std::size_t i = 0; i < r.size(); ++i)
    if (e.rows[i].penetration != 0)
      open[i] = r[i] / lengths[i];
  const double largest = bem::largestEntry(open);
  const Vector decided = processes.broadcast(
      {displacement > 0 ? largest / displacement : 0,
       deformation > 0 ? largest / deformation : 0, e.scaled <= consistent ? 1.0 : 0});
  at.defect = decided[0];
  return {std::move(at), std::move(e), decided[1], decided[2] != 0};
}

/// Where a step of Newton's leads; empty if there is none.
Vector next(const Equation& equation, const Evaluation& e,
            const bem::Processes& processes) {
  const bool isFormed = equation.problem().flexibility.isFormed();
  Vector x;
  if (!isFormed || processes.rank() == 0)
    try {
      x = NewtonSystem(equation, e).solve(bem::times(-1, e.residual));
      bem::axpy(1, e.unknowns, x);
    } catch (const bem::NumericalError&) {  // on all ranks if on any
      x.clear();
    }
  return isFormed ? processes.broadcast(std::move(x)) : x;
}

}  // namespace

Configuration corrected(const ContactSystem& system, State state,
                        const bem::Processes& processes) {
  if (system.numbers().size() == 0)
    return system.configuration(std::move(state));
  const Equation equation(system.numbers(), Equation::Bound::Differentiated, 0);
  Point best = pointOf(system, equation, processes, std::move(state));
  if (best.missed <= enough)
    return system.withResults(std::move(best.at));
  Evaluation e = best.evaluation;
  int idle = 0;
  for (int step = 0; step < mostSteps && best.missed > goal; ++step) {
    const Vector x = next(equation, e, processes);
    if (x.empty())
      break;
    Point there = pointOf(system, equation, processes, unpack(system.numbers(), x));
    // on the way from one set of states to another there is no solution
    const bool isSettled = processes.agreed(there.evaluation.states == e.states);
    const bool isWorthAnother = there.missed <= progress * best.missed;
    e = there.evaluation;
    if (there.isSolution && there.missed < best.missed)
      best = std::move(there);
    idle = isSettled && !isWorthAnother ? idle + 1 : 0;
    if (idle > system.depth())
      break;
  }
  return system.withResults(std::move(best.at));
}

}  // namespace epafi::contact
