#pragma once

#include "adaptivity/mark/Grading.hpp"
#include "adaptivity/refine/Refine.hpp"
#include "adaptivity/singular/SingularPoints.hpp"
#include "bem/base/Processes.hpp"

#include <string>
#include <vector>

namespace epafi::adaptivity {

/// Data of a body of a solved level, from which a strategy computes marks.
struct LevelData {
  const bem::Mesh& mesh;
  std::vector<int> worst;      ///< elements that carry the marking fraction, see doerfler
  std::vector<bool> analytic;  ///< of each element, see looksAnalytic
  SingularPoints singular;
  GradingOptions grading{};
};

/// Start of the iteration on the next level.
enum class Start {
  Zero,    ///< as if it were the first level, so that levels can be compared
  Carried  ///< from this level's state, see refine
};

/// Whether it obeys GradingOptions.
enum class Grading { Ignored, Obeyed };

/// Name and parameters of a strategy.
struct StrategyOptions {
  std::string name = "None";          ///< a name of strategies()
  double markingFraction = 0.6;       ///< of the squared estimate, in (0, 1]
  double analyticityThreshold = 0.5;  ///< see looksAnalytic
  GradingOptions grading;

  void keys(bem::Keys& keys);
};

/// Whether there is another level than the first.
enum class Levels { One, Many };

/// A refinement strategy.
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
                              std::size_t body,
                              const std::vector<contact::ContactStates>& states);

/// The marks of the strategy on rank 0, without those that cut short elements.  Collective.
Marks decide(const Strategy& strategy, const LevelData& level,
             const bem::Processes& processes);

/// All strategies; a program may add others before it reads its first scene.  A built-in
/// one is one line in Strategy.cpp.
bem::Family<Strategy>& strategies();

/// Dörfler's marking: the smallest set of elements whose squared indicators sum up to at
/// least `fraction` of all, 0 < fraction <= 1.                          [P Alg. 25 (c)]
///
/// Elements that equal the smallest one of the set within 1e-5 are marked as well, so that
/// symmetric scenes stay symmetric and their images alike: indicators that ought to be equal
/// differ by their quadrature, up to 2e-6 (BoundaryFields).  In increasing order; empty when
/// all squares are zero.
std::vector<int> doerfler(const bem::Vector& squares, double fraction);

/// Marking over the elements of all bodies together; returns the marked elements of each body.
std::vector<std::vector<int>> doerfler(const std::vector<bem::Vector>& squares,
                                       double fraction);

}  // namespace epafi::adaptivity
