#include "contact/stabilization/Stabilization.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::contact {

namespace {

using bem::above;
using bem::from;

constexpr bem::Named<Stabilization::Form> forms[] = {
    {"Density", Stabilization::Form::Density},
    {"Projected", Stabilization::Form::Projected},
    {"Exact", Stabilization::Form::Exact},
    {"None", Stabilization::Form::None},
};
/// All that the forms differ by.
struct FormRow {
  Stabilization::Form form = Stabilization::Form::None;
  bool isOn = false;
  bool byDensity = false;
  std::optional<bem::TractionForm> tractions{};
  double gamma0 = 0;
};
constexpr FormRow rows[] = {
    {Stabilization::Form::Density, true, true, {}, 0.5},
    {Stabilization::Form::Projected, true, false, bem::TractionForm::Projected, 0.1},
    {Stabilization::Form::Exact, true, false, bem::TractionForm::Exact, 0.1},
    {Stabilization::Form::None, false, false, {}, 0.1},
};

const FormRow& rowOf(Stabilization::Form form) {
  return *std::find_if(std::begin(rows), std::end(rows),
                       [form](const FormRow& row) { return row.form == form; });
}

constexpr bem::Named<bool> densityDegrees[] = {{"Raised", true}, {"Same", false}};
constexpr bem::Named<Stabilization::Scaling> scalings[] = {
    {"Stiffness", Stabilization::Scaling::Stiffness},
    {"Absolute", Stabilization::Scaling::Absolute},
};

}  // namespace

bool Stabilization::isOn() const { return rowOf(form).isOn; }
bool Stabilization::byDensity() const { return rowOf(form).byDensity; }
std::optional<bem::TractionForm> Stabilization::tractions() const {
  return rowOf(form).tractions;
}
double Stabilization::firstGamma0() const { return gamma0.value_or(rowOf(form).gamma0); }

double gammaOn(const bem::Mesh& mesh, int e, const Stabilization& s,
               const bem::Lame& lame, bem::Units units) {
  if (!s.isOn())
    return 0;
  const bem::Element& element = mesh[e];
  // a coarse element beside a tiny one would lose definiteness with its own size
  const double h =
      2 * std::min({element.half, mesh[element.previous].half, mesh[element.next].half});
  const double degrees = std::pow(element.degree, -2 - s.eta);
  if (s.scaling == Stabilization::Scaling::Absolute) {
    const double physical =
        s.firstGamma0() * std::pow(h * units.length, 1 + s.beta) * degrees;
    return physical * units.stress / units.length;
  }
  const double perStress = s.byDensity() ? 1 / (2 * lame.mu * (1 + lame.nu))
                                         : std::min(1.0, 50 * (1 - 2 * lame.nu));
  return s.firstGamma0() * perStress * std::pow(h, 1 + s.beta) * degrees;
}

void Stabilization::keys(bem::Keys& keys) {
  keys.add(
      &form, "Form", forms,
      "what stands for the boundary stress in the stabilisation: the density psi, an "
      "unknown; S u projected onto polynomials; S u exactly; None: none");
  keys.add(
      &gamma0, "Gamma0", "1, or as Scaling says", above(0),
      "strength gamma0. Form Density is stable with any, accurate from 1e-3 to 1e3. "
      "Forms Projected and Exact take 0.1 by default and lose definiteness near 0.6 "
      "under Scaling Stiffness: the default gives way then, what is written is refused",
      bem::shortest(firstGamma0()));
  keys.add(
      &raised, "Density Degree", densityDegrees,
      "degree of psi on contact elements under Form Density: p, or p - 1 as elsewhere");
  keys.add(&beta, "Beta", "1", from(0), "extra power of the element size");
  keys.add(&eta, "Eta", "1", from(0), "extra power of 1 / degree");
  keys.add(
      &scaling, "Scaling", scalings,
      "Stiffness: gamma = Gamma0 min(1, 50(1-2nu)) (h/d)^Beta h p^(-2-Eta) / E, without "
      "the min under Form Density; Absolute: gamma = Gamma0 h^(1+Beta) p^(-2-Eta) in "
      "the scene's units");
}

}  // namespace epafi::contact
