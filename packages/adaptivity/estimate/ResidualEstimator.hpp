#pragma once

#include "adaptivity/estimate/Indicators.hpp"
#include "bem/base/Processes.hpp"
#include "bem/base/SchemaRow.hpp"
#include "contact/results/Summary.hpp"

#include <string>

namespace Teuchos {
class ParameterList;
}

namespace epafi::adaptivity {

struct EstimatorOptions {
  std::string weights = "Energy";  ///< a name of weightings()
  /// > 0; multiplies the squares of Neumann, Contact and Density, including the term of the
  /// stabilisation in Contact.
  double residualFactor = 1;
};

/// Schema rows of EstimatorOptions; options of a validated list.
bem::SchemaRows estimatorRows();
EstimatorOptions parseEstimator(const Teuchos::ParameterList& list);

/// A body's solution and its density ψ, see ContactProblem::density.
struct Estimated {
  const contact::Solved& solved;
  const Vector& density;
};

/// Residual error indicators of states of one body on one mesh, one per state: [P]
/// Theorem 22, Corollary 23 and, with bounds that depend on the pressure, Theorem 24;
/// norms by the scaled L² norms of [P sec. 8].
///
/// With Weights "Energy", equivalentMultiplier() replaces λʰ unless an opposite body is
/// elastic, and γ |λʰ + S u|² is added to Contact.  With Form Density this term is
/// replaced by the mean of γ (λʰ + ψ), added to Density with all Weights.
///
/// The Neumann residual contains the given traction, not its interpolant, and the
/// tractions that hold fixed rigid motions.  Free components on a Dirichlet side count as
/// Neumann.  The interpolation error of prescribed displacements is contained, in
/// Density, with body loads only.
///
/// Squares are energies [stress length²] with Weights "Energy".  Collective: processes
/// share the elements; each gets all indicators.
std::vector<Indicators> estimateResiduals(const std::vector<Estimated>& states,
                                          const bem::Lame& lame,
                                          const EstimatorOptions& options,
                                          const bem::Processes& processes);

}  // namespace epafi::adaptivity
