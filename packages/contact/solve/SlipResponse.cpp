#include "contact/solve/SlipResponse.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"
#include "contact/newton/NewtonSystem.hpp"

#include <algorithm>

namespace epafi::contact {

// With F(x; s) = 0 and M_w alone dependent on s:  J dx = c ∂F/∂y ∂(M_w λ)/∂s,  S' = ± drₜ/ds.
bem::Matrix slipResponse(const ContactSystem& system, const Configuration& at) try {
  const Problem& problem = system.numbers();
  const Equation equation(problem, Equation::Bound::Differentiated, 0);
  const Evaluation e = equation.at(pack(problem, at.state), at.penetration);
  const NewtonSystem newton(equation, e);
  const bem::Matrix worn = system.wear().wornBy(at.state.multiplier);
  const Vector none =
      penetration(problem, unpack(problem, Vector(bem::at(equation.size()))));
  bem::Matrix response(worn.columns(), worn.columns());
  for (Index k = 0; k < worn.columns(); ++k) {
    Vector right(bem::at(equation.size()));
    for (Index i = 0; i < worn.rows(); ++i)
      right[bem::at(i)] =
          e.rows[bem::at(i)].penetration * e.weights[bem::at(i)] * worn(i, k);
    if (bem::largestEntry(right) == 0)
      continue;
    Vector slip = penetration(problem, unpack(problem, newton.solve(right)));
    for (std::size_t i = 0; i < slip.size(); ++i)
      slip[i] = at.penetration[i] < 0 ? none[i] - slip[i] : slip[i] - none[i];
    const Vector all = system.wear().atPoints(slip);
    std::copy(all.begin(), all.end(), response.column(k));
  }
  return response;
} catch (const bem::NumericalError&) {
  return {};
}

}  // namespace epafi::contact
