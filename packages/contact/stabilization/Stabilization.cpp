#include "contact/stabilization/Stabilization.hpp"

#include "bem/base/Named.hpp"

#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <cmath>

namespace epafi::contact {

namespace {

using bem::above;
using bem::from;
using bem::Kind;
using bem::Row;

constexpr bem::Named<Stabilization::Form> forms[] = {
    {"Density", Stabilization::Form::Density},
    {"Projected", Stabilization::Form::Projected},
    {"Exact", Stabilization::Form::Exact},
    {"None", Stabilization::Form::None},
};
constexpr bem::Named<bool> densityDegrees[] = {{"Raised", true}, {"Same", false}};
constexpr bem::Named<Stabilization::Scaling> scalings[] = {
    {"Stiffness", Stabilization::Scaling::Stiffness},
    {"Absolute", Stabilization::Scaling::Absolute},
};

}  // namespace

double gammaOn(const bem::Mesh& mesh, int e, const Stabilization& s, double nu,
               bem::Units units) {
  if (s.form == Stabilization::Form::None)
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
  const double nearlyIncompressible =
      s.form == Stabilization::Form::Density ? 1 : std::min(1.0, 50 * (1 - 2 * nu));
  return s.firstGamma0() * nearlyIncompressible * std::pow(h, 1 + s.beta) * degrees;
}

bem::SchemaRows stabilizationRows() {
  const Stabilization defaults;
  return {
      Row("Form", Kind::Text,
          "what stands for the boundary stress in the stabilisation: the density psi, an "
          "unknown; S u projected onto polynomials; S u exactly; None: none")
          .standard(forms[0].name)
          .allowed(bem::namesOf(forms)),
      Row("Gamma0", Kind::Real,
          "strength gamma0. Form Density is stable with any, accurate from 1e-3 to 1e3. "
          "Forms Projected and Exact take 0.1 "
          "by default and lose definiteness near 0.6 under Scaling Stiffness: the "
          "default gives way then, what is written is refused")
          .unit("1, or as Scaling says")
          .standard(defaults.firstGamma0())
          .range(above(0)),
      Row("Density Degree", Kind::Text,
          "degree of psi on contact elements under Form Density: p, or p - 1 as "
          "elsewhere")
          .standard(densityDegrees[0].name)
          .allowed(bem::namesOf(densityDegrees)),
      Row("Beta", Kind::Real, "extra power of the element size")
          .unit("1")
          .standard(defaults.beta)
          .range(from(0)),
      Row("Eta", Kind::Real, "extra power of 1 / degree")
          .unit("1")
          .standard(defaults.eta)
          .range(from(0)),
      Row("Scaling", Kind::Text,
          "Stiffness: gamma = Gamma0 min(1, 50(1-2nu)) (h/d)^Beta h p^(-2-Eta) / E, "
          "without the min under Form Density; Absolute: gamma = Gamma0 h^(1+Beta) "
          "p^(-2-Eta) in the scene's units")
          .standard(scalings[0].name)
          .allowed(bem::namesOf(scalings)),
  };
}

Stabilization parseStabilization(const Teuchos::ParameterList& list) {
  Stabilization stabilization;
  stabilization.form = bem::named(forms, list.get<std::string>("Form"));
  stabilization.raised =
      bem::named(densityDegrees, list.get<std::string>("Density Degree"));
  stabilization.scaling = bem::named(scalings, list.get<std::string>("Scaling"));
  if (!list.getEntry("Gamma0").isDefault())
    stabilization.gamma0 = list.get<double>("Gamma0");
  stabilization.beta = list.get<double>("Beta");
  stabilization.eta = list.get<double>("Eta");
  return stabilization;
}

}  // namespace epafi::contact
