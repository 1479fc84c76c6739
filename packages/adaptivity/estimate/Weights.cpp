#include "adaptivity/estimate/Weights.hpp"

#include "bem/base/Error.hpp"

namespace epafi::adaptivity {

namespace {

// What a dimensionless square means: residuals, tension and bound are (stress length)²,
// density and penetration length², complementarity and slip stress length².
constexpr Source stresses[] = {Source::Neumann, Source::Contact, Source::Tension,
                               Source::Bound};
constexpr Source lengths[] = {Source::Density, Source::Penetration};
constexpr Source energies[] = {Source::Complementarity, Source::Slip};

Contributions factors(double ofStresses, double ofLengths, double ofEnergies) {
  Contributions result{};
  for (const Source source : stresses)
    of(result, source) = ofStresses;
  for (const Source source : lengths)
    of(result, source) = ofLengths;
  for (const Source source : energies)
    of(result, source) = ofEnergies;
  return result;
}

// Everything is an energy: squares of stresses / μ, squares of lengths μ.
Contributions energy(const bem::Lame& lame, bem::Units units) {
  const double scale = units.stress * units.length * units.length;
  return factors(scale / lame.mu, scale * lame.mu, scale);
}

// The numbers as they stand in the user's units.
Contributions paper(const bem::Lame&, bem::Units units) {
  const double area = units.length * units.length;
  return factors(units.stress * units.stress * area, area, units.stress * area);
}

}  // namespace

const std::vector<Weights>& weightings() {
  static const std::vector<Weights> table = {
      {"Energy",
       "all terms as energies: residual, tension and bound divided by the shear modulus, "
       "density and penetration multiplied by it; of the multipliers that do the same "
       "work the best, slip of its admissible shear",
       energy, Bounds::Sharp},
      {"Paper", "as printed, in the scene's units, which then matter", paper,
       Bounds::Printed},
  };
  return table;
}

const Weights& weighting(const std::string& name) {
  std::string known;
  for (const Weights& weights : weightings()) {
    if (weights.name == name)
      return weights;
    known += (known.empty() ? "'" : ", '") + std::string(weights.name) + "'";
  }
  throw bem::InputError(bem::message("weights '", name, "'; known weights: ", known));
}

}  // namespace epafi::adaptivity
