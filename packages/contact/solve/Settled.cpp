#include "contact/solve/Settled.hpp"

#include "contact/solve/DefectCorrection.hpp"

namespace epafi::contact {

Settled settled(ContactSystem& system,
                const std::function<Solution(const State* before)>& solve,
                const bem::Processes& processes) {
  constexpr double same = 1e-12;
  constexpr double almost = 1e-8;  // where rounding changes it on and on
  constexpr int most = 400;        // a shear compliance alone may leave 3/4 of a change
  Settled result{solve(nullptr)};
  Solution& solved = result.solution;
  double last = 1;
  for (int k = 0; solved.report.converged() && system.wearsBySlip(); ++k) {
    const double change = system.wearBy(system.configuration(solved.state));
    if (processes.agreed(change <= same || (change < almost && change > last / 2)))
      break;
    if (k == most) {
      solved.report.status = Status::NotConverged;
      result.wearChange = change;
      break;
    }
    last = change;
    Solution next = solve(&solved.state);
    next.report = joined(std::move(next.report), solved.report);
    solved = std::move(next);
  }
  if (solved.report.converged())
    result.at = worn(system, corrected(system, solved.state, processes));
  return result;
}

Configuration worn(ContactSystem& system, Configuration at) {
  return system.wearBy(at) > 0 ? system.configuration(std::move(at.state))
                               : std::move(at);
}

}  // namespace epafi::contact
