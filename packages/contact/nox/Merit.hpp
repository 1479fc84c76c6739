#pragma once

#include "contact/nox/Newton.hpp"

#include <NOX_MeritFunction_Generic.H>
#include <Teuchos_RCP.hpp>

namespace epafi::contact {

class Group;

/// A merit function that also knows its change between two points, free of cancellation.
class Merit : public NOX::MeritFunction::Generic {
 public:
  /// merit(to) - merit(from)
  virtual double change(const Group& from, const Group& to) const = 0;
  /// Below this a change is rounding.
  virtual double rounding(const Group& from, const Group& to) const = 0;

  double computeSlope(const NOX::Abstract::Vector& direction,
                      const NOX::Abstract::Group& group) const override;
  double computeQuadraticModel(const NOX::Abstract::Vector& direction,
                               const NOX::Abstract::Group& group) const override;
  void computeQuadraticMinimizer(const NOX::Abstract::Group& group,
                                 NOX::Abstract::Vector& result) const override;
};

/// The merit function of a method on an equation:
///
///   fixed bounds, no rigid motions:   ½ λᵀDλ - d₀ᵀλ at P(λ), the energy of the programme
///   otherwise:                        ½ |F|² with Fischer-Burmeister's function
///
/// Both are continuously differentiable (the energy on the box), whatever complementarity
/// function Newton's method works with.
Teuchos::RCP<const Merit> makeMerit(const Equation& equation, NewtonMethod method);

}  // namespace epafi::contact
