#include "contact/newton/NewtonStep.hpp"

#include "contact/newton/NewtonSystem.hpp"
#include "contact/newton/RigidPlacement.hpp"

namespace epafi::contact {

namespace {

Vector negative(Vector v) {
  for (double& value : v)
    value = -value;
  return v;
}

// A point's rows with every closed place of Coulomb friction taken to stick: from there
// the pressure, and with it the bound, can be found although everything slips now.
LinearRows bonded(const Problem& problem, const Evaluation& e, LinearRows rows) {
  for (std::size_t t = 0; t < problem.tangentials.size(); ++t) {
    const Tangential& tangential = problem.tangentials[t];
    const std::size_t i = at(problem.normals) + t;
    if (!tangential.followsPressure() || !tangential.carries())
      continue;
    const bool closed =
        e.unknowns[at(tangential.normal())] + e.penetration[at(tangential.normal())] > 0;
    if (!closed)
      continue;
    rows.rows[i] = {-e.penetration[i], 0, -1, 0};
    rows.residual[i] = -e.penetration[i];
  }
  return rows;
}

}  // namespace

Vector placingStep(const Equation& equation, const Evaluation& e, const LinearRows& rows,
                   const Vector& motion, FactorMemory* memory) {
  if (equation.problem().boundDependsOnPressure()) {
    const LinearRows sticking = bonded(equation.problem(), e, rows);
    const NewtonSystem bondedSystem(equation, sticking, memory);
    const Vector bondedRight = negative(sticking.residual);
    if (bondedSystem.unheld(bondedRight).empty())
      return bondedSystem.solve(bondedRight);
  }
  return rigidPlacement(equation, e, motion);
}

Vector newtonStep(const Equation& equation, const Evaluation& e, const LinearRows& rows,
                  FactorMemory* memory) {
  const NewtonSystem system(equation, rows, memory);
  const Vector right = negative(rows.residual);
  const Vector motion = system.unheld(right);
  return motion.empty() ? system.solve(right)
                        : placingStep(equation, e, rows, motion, memory);
}

}  // namespace epafi::contact
