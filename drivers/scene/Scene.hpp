#pragma once

#include "adaptivity/estimate/ResidualEstimator.hpp"
#include "adaptivity/mark/Strategy.hpp"
#include "bem/base/Material.hpp"
#include "bem/geometry/Outline.hpp"
#include "contact/conditions/Conditions.hpp"
#include "contact/coulomb/CoulombIteration.hpp"
#include "contact/problem/Stabilization.hpp"
#include "drivers/scene/LinearMethod.hpp"
#include "drivers/scene/RunLimits.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>

#include <memory>
#include <string>
#include <vector>

namespace epafi::drivers {

/// A scene, read and validated: everything that a run needs, in the user's units.
struct Scene {
  std::string title;
  std::string file;

  std::string body;
  bem::Material material;
  std::shared_ptr<const bem::Outline> outline;
  contact::Conditions conditions;

  std::vector<int>
      elementsPerEdge;  ///< one per edge of the outline, holes after the outer loop
  int degree = 1;
  std::string multiplier;
  contact::Stabilization stabilization;

  /// What a nonlinear solver is assembled from, see solve().
  struct Solver {
    contact::TrescaOptions tresca;
    contact::CoulombOptions coulomb;
    int loadSteps = 1;
    /// Handed to NOX in every run; null means Epafi's own choice.
    std::shared_ptr<const Teuchos::ParameterList> nox;
  } solver;

  LinearOptions linear;

  struct Adaptivity {
    adaptivity::StrategyOptions strategy;
    adaptivity::EstimatorOptions estimator;
    RunLimits limits;
  } adaptivity;

  struct Output {
    int contactSamples = 8;  ///< per element
    std::vector<bem::Vec2> interiorPoints;
    bool fields = true;  ///< write boundary.csv and what shows fields
  } output;

  /// The complete list with every default filled in: what used.xml says.
  Teuchos::RCP<Teuchos::ParameterList> used;
};

}  // namespace epafi::drivers
