#pragma once

#include "adaptivity/mark/Grading.hpp"
#include "adaptivity/refine/Refine.hpp"
#include "adaptivity/singular/SingularPoints.hpp"
#include "bem/base/Processes.hpp"

#include <string>
#include <vector>

namespace epafi::adaptivity {

/// What a strategy decides from: a body of a solved level, as numbers.
struct LevelData {
  const bem::Mesh& mesh;
  std::vector<int> worst;      ///< elements that carry the marking fraction, see doerfler
  std::vector<bool> analytic;  ///< of each element, see looksAnalytic
  SingularPoints singular;
  GradingOptions grading{};
};

/// Where the next level's iteration starts.
enum class Start {
  Zero,    ///< as if it were the first level, so that levels can be compared
  Carried  ///< from this level's state, see refine
};

/// Whether it obeys GradingOptions.
enum class Grading { Ignored, Obeyed };

/// Which strategy, and what its marks depend on.
struct StrategyOptions {
  std::string name = "None";          ///< a name of strategies()
  double markingFraction = 0.6;       ///< of the squared estimate, in (0, 1]
  double analyticityThreshold = 0.5;  ///< see looksAnalytic
  GradingOptions grading;
};

/// The keys of a list of these, and what a list that they have completed says.
bem::SchemaRows strategyRows();
StrategyOptions parseStrategy(const Teuchos::ParameterList& list);

/// Whether there is another level than the first.
enum class Levels { One, Many };

/// A way from one level to the next.
struct Strategy {
  const char* name;
  const char* meaning;
  Levels levels;
  Start start;
  Grading grading;
  /// No mark at all ends the run.
  Marks (*marks)(const LevelData& level);
};

/// The singular points of a body that the strategy looks at: those that the conditions tell
/// and, where it grades toward transitions, those of all states, of which there is at least
/// one.
SingularPoints singularPoints(const Strategy& strategy, const GradingOptions& options,
                              const bem::Mesh& mesh,
                              const contact::Conditions& conditions,
                              const contact::MultiplierSpace& multiplier,
                              const std::vector<contact::ContactState>& states);

/// The strategy's marks as rank 0 takes them; all processes must call.
Marks decide(const Strategy& strategy, const LevelData& level,
             const bem::Processes& processes);

/// All strategies; a program may add others before it reads its first scene.  A built-in
/// one is one line in Strategy.cpp.
bem::Family<Strategy>& strategies();

}  // namespace epafi::adaptivity
