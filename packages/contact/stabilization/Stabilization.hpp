#pragma once

#include "bem/base/Material.hpp"
#include "bem/base/SchemaRow.hpp"
#include "bem/mesh/Mesh.hpp"

#include <optional>

namespace epafi::contact {

/// How λ + S u is weighted and evaluated in the stabilisation of [P (13)].
struct Stabilization {
  enum class Form {
    Projected,  ///< S u projected onto polynomials of degree p on each element [P (42)]
    Exact,      ///< S u at quadrature points graded to the element's ends      [P sec. 6]
    Density,    ///< the density ψ in S u's place, an unknown (doc/theory/contact.md)
    None
  };
  enum class Scaling {
    Stiffness,  ///< γ = γ₀ min(1, 50(1-2ν)) (h/d)^β h p^(-2-η) / E; Density: without min
    Absolute  ///< γ = γ₀ h^(1+β) p^(-2-η), in the user's units, as printed in [P]
  };

  Form form = Form::Density;
  Scaling scaling = Scaling::Stiffness;
  /// γ₀ > 0. Empty: 0.5 for Density, which nothing is too large for; else 0.1 or, on a mesh
  /// where that loses definiteness, a quarter of where it is lost; only a number that is
  /// given can be too large.
  std::optional<double> gamma0;
  double beta = 0;  ///< >= 0
  double eta = 0;   ///< >= 0
  /// Whether ψ is of degree p on contact elements under Form::Density, not p - 1.
  bool raised = true;

  double firstGamma0() const {
    return gamma0.value_or(form == Form::Density ? 0.5 : 0.1);
  }
};

/// γ on an element, dimensionless: scaled as the inverse inequality ||S u||_E <= c p h^(-1/2) of
/// its neighbours demands, h the smallest size among them; zero under Form::None.
double gammaOn(const bem::Mesh& mesh, int element, const Stabilization& stabilization,
               double nu, bem::Units units);

/// The keys of a list of these, and what a list that they have completed says.
bem::SchemaRows stabilizationRows();
Stabilization parseStabilization(const Teuchos::ParameterList& list);

}  // namespace epafi::contact
