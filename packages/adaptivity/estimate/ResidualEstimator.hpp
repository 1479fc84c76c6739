#pragma once

#include "adaptivity/estimate/Indicators.hpp"
#include "bem/base/Keys.hpp"
#include "bem/base/Processes.hpp"
#include "contact/results/Summary.hpp"

#include <string>

namespace epafi::adaptivity {

struct EstimatorOptions {
  std::string weights = "Energy";  ///< a name of weightings()
  /// > 0; multiplies the squares of the first three sources, that of the contact residual
  /// with what the stabilisation adds to it.
  double residualFactor = 1;

  void keys(bem::Keys& keys);
};

/// A body's solution and its density ψ, see ContactBody::density.
struct Estimated {
  const contact::Solved& solved;
  const Vector& density;
};

/// Of each of some states of one body on one mesh the residual error estimator of [P] Theorem 22, Corollary 23 and, with bounds that
/// follow the pressure, Theorem 24; norms by the scaled L² norms of [P sec. 8].
///
/// Under Weights "Energy" the multiplier in it is not λʰ but one that does the same work,
/// see equivalentMultiplier, and γ |λʰ + S u|² is added to the contact residual; under Form
/// Density the mean of γ (λʰ + ψ) to the density's residual instead.
///
/// The Neumann residual is taken against the given traction itself, not its interpolant,
/// and with the uniform tractions that hold fixed rigid motions.  Free components on a
/// Dirichlet side count as Neumann.  Prescribed displacements are taken as met: what
/// interpolation leaves of them is not seen.
///
/// Squares are energies [stress length²] under Weights "Energy".  Elements are shared out
/// among the processes; every one gets all.  Some states at a time share their fields' kernels.
std::vector<Indicators> estimateResiduals(const std::vector<Estimated>& states,
                                          const bem::Lame& lame,
                                          const EstimatorOptions& options,
                                          const bem::Processes& processes);

}  // namespace epafi::adaptivity
