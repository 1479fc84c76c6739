#pragma once

#include "adaptivity/refine/Refine.hpp"
#include "adaptivity/singular/SingularPoints.hpp"
#include "bem/base/Family.hpp"
#include "bem/base/Keys.hpp"
#include "bem/basis/Legendre.hpp"

#include <string>
#include <vector>

namespace epafi::adaptivity {

struct GradingOptions;

/// Treatment of transitions of contact or friction by the strategy Graded hp.
struct Transitions {
  const char* name;
  const char* meaning;
  bool areSingular;  ///< do changes of state count as singular points?
  /// Mark of an element with changes of state at these places.  \pre ascending, not empty
  Mark (*mark)(const std::vector<double>& changes, int degree,
               const GradingOptions& options);
};
bem::Family<Transitions>& transitions();

/// Treatment of elements that touch no singular point by Graded hp.
struct SmoothElements {
  const char* name;
  const char* meaning;
  bool (*raisesDegree)(bool analytic);
};
bem::Family<SmoothElements>& smoothElements();

/// Options of Graded hp.
struct GradingOptions {
  double ratio = 0.1;  ///< in (0, 1/2]: size of a piece next to a singular point
  int layers = 1;  ///< of such pieces that are cut off at once, each next to the next one
  int degreeStep = 1;  ///< >= 0: what the piece away from it gains
  int weakDegree = 4;  ///< a weak point is left to the degree below this one
  std::string transitions = "Node";        ///< a name of transitions()
  int largestDegree = bem::largestDegree;  ///< that is used: the multiplier's basis'
  std::string smooth = "Raise Degree";     ///< a name of smoothElements()

  void keys(bem::Keys& keys);
};

/// The mark of a refined element: cut toward singular points, a higher degree elsewhere.
///
/// Between its singular points the solution is analytic, so that sizes that fall
/// geometrically toward them and degrees that grow away from them converge exponentially
/// in the root of the unknowns.                                  [Gui & Babuska 1986]
///
/// `analytic`: do the element's Legendre coefficients decay?  See looksAnalytic.
Mark gradedMark(const bem::Mesh& mesh, int element, const SingularPoints& singular,
                bool analytic, const GradingOptions& options);

}  // namespace epafi::adaptivity
