#include "contact/problem/Problem.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace epafi::contact {

namespace {

template <class Error>
void require(bool holds, const char* what) {
  if (!holds)
    throw Error(bem::message("the contact problem's ", what));
}

bool finite(const Vector& v) {
  return std::all_of(v.begin(), v.end(), [](double x) { return std::isfinite(x); });
}

}  // namespace

Problem Problem::copy() const {
  return {normals,   tangentials,    flexibility, offset,        rigid.copy(),
          rigidLoad, rigidStiffness, stress,      amplification, surface};
}

void Problem::check() const {
  using bem::InputError;
  using bem::NumericalError;
  const auto isNormal = [&](Index i) { return 0 <= i && i < normals; };
  require<InputError>(flexibility.size() == size(),
                      "flexibility is not of the multiplier's size");
  require<InputError>(static_cast<Index>(offset.size()) == size(),
                      "offset is not of the multiplier's size");
  require<InputError>(
      rigid.columns() == rigidMotions() && (rigid.empty() || rigid.rows() == size()),
      "rigid motions do not fit their loads or the multiplier");
  require<InputError>(rigidStiffness.empty() || rigidStiffness.size() == rigidLoad.size(),
                      "springs do not fit its rigid motions");
  for (const Tangential& t : tangentials)
    require<InputError>(t.isTied() || isNormal(t.normal()),
                        "slip bounds follow pressures that there are not");
  require<NumericalError>(stress > 0 && std::isfinite(stress), "stress is not positive");
  require<NumericalError>(finite(offset), "load holds a number that is not finite");
  require<NumericalError>(finite(rigidLoad),
                          "resultant holds a number that is not finite");
  require<NumericalError>(
      finite(rigidStiffness) && std::all_of(rigidStiffness.begin(), rigidStiffness.end(),
                                            [](double k) { return k >= 0; }),
      "springs are not all stiff and finite");
}

bool Problem::boundDependsOnPressure() const {
  return std::any_of(tangentials.begin(), tangentials.end(), [](const Tangential& t) {
    return t.followsPressure() && t.carries();
  });
}

Vector Problem::slipBounds(const Vector& multiplier) const {
  Vector bounds;
  bounds.reserve(tangentials.size());
  const Vector zero(multiplier.empty() ? static_cast<std::size_t>(normals) : 0, 0.0);
  for (const Tangential& t : tangentials)
    bounds.push_back(t.bound(multiplier.empty() ? zero : multiplier));
  return bounds;
}

Problem withSlipBounds(const Problem& problem, const Vector& bounds) {
  assert(bounds.size() == problem.tangentials.size());
  Problem fixed = problem.copy();
  for (std::size_t t = 0; t < bounds.size(); ++t)
    if (!problem.tangentials[t].isTied())
      fixed.tangentials[t] =
          Tangential(problem.tangentials[t].normal(), PointLaw(bounds[t]));
  return fixed;
}

Vector penetration(const Problem& problem, const State& state) {
  Vector r = problem.offset;
  bem::axpy(-1, problem.flexibility.times(state.multiplier), r);
  for (Index j = 0; j < problem.rigidMotions(); ++j)
    bem::axpy(state.rigid[at(j)], columnOf(problem.rigid, j), r);
  if (!problem.surface.empty())
    bem::axpy(-1, problem.surface.closing(state.multiplier), r);
  return r;
}

Problem withSlipBefore(const Problem& problem, const Vector& slipBefore) {
  assert(slipBefore.size() == problem.tangentials.size());
  Problem step = problem.copy();
  for (std::size_t t = 0; t < slipBefore.size(); ++t)
    step.offset[at(problem.normals) + t] -= slipBefore[t];
  return step;
}

}  // namespace epafi::contact
