#include "adaptivity/estimate/Weights.hpp"

#include "adaptivity/estimate/ResidualEstimator.hpp"

namespace epafi::adaptivity {

namespace {

// Units of the squares: residuals, tension and bound (stress length)², density and
// penetration length², complementarity and slip stress length².
Contributions factors(double stress, double length, double energy) {
  return {stress, stress, length, energy, length, stress, stress, energy};
}

// All as energies: squares of stresses / μ, squares of lengths times μ.
Contributions energy(const bem::Lame& lame, bem::Units units) {
  const double scale = units.energy();
  return factors(scale / lame.mu, scale * lame.mu, scale);
}

// The squares in the user's units.
Contributions paper(const bem::Lame&, bem::Units units) {
  const double area = units.length * units.measure();
  return factors(units.stress * units.stress * area, area, units.stress * area);
}

}  // namespace

bem::Family<Weights>& weightings() {
  static bem::Family<Weights> table(
      "weights",
      {
          {"Energy",
           "all terms as energies: residual, tension and bound divided by the shear "
           "modulus, density and penetration multiplied by it; of the multipliers that "
           "do the same work the best, slip of its admissible shear",
           energy, Bounds::Sharp},
          {"Paper", "as printed, in the scene's units, which then matter", paper,
           Bounds::Printed},
      });
  return table;
}

void EstimatorOptions::keys(bem::Keys& keys) {
  keys.add(&weights, "Weights", weightings(), "how the estimate adds its terms up; ");
  keys.add(&residualFactor, "Residual Factor", "1", bem::above(0),
           "multiplies the squares of eta_neumann, eta_contact and eta_density");
}

}  // namespace epafi::adaptivity
