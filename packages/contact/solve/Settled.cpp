#include "contact/solve/Settled.hpp"

#include "contact/solve/DefectCorrection.hpp"
#include "contact/solve/SlipResponse.hpp"

namespace epafi::contact {

Settled settled(ContactSystem& system,
                const std::function<Solution(const State* before)>& solve,
                const bem::Processes& processes) {
  constexpr double same = 1e-12;
  constexpr double almost = 1e-8;  // where rounding changes it on and on,
  constexpr int idlest = 4;        // at least in as many solves
  constexpr int most = 400;        // a shear compliance alone may leave 3/4 of a change
  constexpr double missed = 1e-8;
  constexpr int further = 6;
  Settled result{solve(nullptr)};
  Solution& solved = result.solution;
  double halved = 1;
  int idle = 0;
  for (int k = 0; solved.report.converged() && system.wearsBySlip(); ++k) {
    const Configuration at = system.placed(solved.state);
    const double change = system.wearBy(
        at, system.wear().wantsResponse() ? slipResponse(system, at) : bem::Matrix());
    idle = change <= halved / 2 ? 0 : idle + 1;
    if (idle == 0)
      halved = change;
    if (processes.agreed(change <= same || (change < almost && idle >= idlest)))
      break;
    if (k == most) {
      solved.report.status = Status::NotConverged;
      result.wearChange = change;
      break;
    }
    Solution next = solve(&solved.state);
    next.report = joined(std::move(next.report), solved.report);
    solved = std::move(next);
  }
  if (!solved.report.converged())
    return result;
  result.at = corrected(system, solved.state, processes);
  // with beddings D's solution may have other states, to which Newton's steps alone do not lead
  for (int k = 0; system.depth() > 0 && result.at.defect > missed && k < further; ++k) {
    system.takeDefect(system.placed(solved.state));
    Solution next = solve(&solved.state);
    if (!next.report.converged())
      break;
    next.report = joined(std::move(next.report), solved.report);
    solved = std::move(next);
    Configuration at = corrected(system, solved.state, processes);
    if (at.defect < result.at.defect)
      result.at = std::move(at);
  }
  result.at = worn(system, std::move(result.at));
  return result;
}

Configuration worn(ContactSystem& system, Configuration at) {
  if (!system.wearsBySlip())
    return at;
  // those of the state alone, to the last digit: so a restart finds them
  system.forgetIterations();
  system.wearBy(at);
  return system.configuration(std::move(at.state));
}

}  // namespace epafi::contact
