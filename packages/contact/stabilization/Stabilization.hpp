#pragma once

#include "bem/base/Keys.hpp"
#include "bem/base/Material.hpp"
#include "bem/mesh/Mesh.hpp"
#include "bem/tractions/TractionRows.hpp"

#include <optional>

namespace epafi::contact {

/// Options of the stabilisation term γ (λ + S u) of [P (13)].
struct Stabilization {
  enum class Form {
    Projected,  ///< S u projected onto polynomials of degree p on each element [P (42)]
    Exact,      ///< S u at quadrature points graded to the ends of the element [P sec. 6]
    Density,    ///< the density ψ, an unknown, instead of S u (doc/theory/contact.md)
    None
  };
  enum class Scaling {
    Stiffness,  ///< γ = γ₀ min(1, 50(1-2ν)) (h/d)^β h p^(-2-η) / E; Density: without min
    Absolute  ///< γ = γ₀ h^(1+β) p^(-2-η), in the user's units, as printed in [P]
  };

  Form form = Form::Density;
  Scaling scaling = Scaling::Stiffness;
  /// γ₀ > 0.  Empty: 0.5 for Density, which is stable for any γ₀; else 0.1 or, if the matrix is
  /// then indefinite, a quarter of the largest γ₀ with a definite matrix.
  std::optional<double> gamma0;
  double beta = 0;  ///< >= 0
  double eta = 0;   ///< >= 0
  /// Whether ψ is of degree p on contact elements under Form::Density, not p - 1.
  bool raised = true;

  void keys(bem::Keys& keys);

  // What a form is: rows of a table in Stabilization.cpp.
  /// Is there a stabilisation?  Else γ = 0.
  bool isOn() const;
  /// Does the density ψ stand for S u?
  bool byDensity() const;
  /// How S u itself is evaluated; empty: it is not.
  std::optional<bem::TractionForm> tractions() const;
  double firstGamma0() const;
};

/// γ on an element, dimensionless, E of its body; h is the smallest size of the element and its neighbours, as
/// the inverse inequality ||S u||_E <= c p h^(-1/2) requires.  Zero for Form::None.
double gammaOn(const bem::Mesh& mesh, int element, const Stabilization& stabilization,
               const bem::Lame& lame, bem::Units units);

}  // namespace epafi::contact
