#pragma once

#include "adaptivity/refine/Refine.hpp"
#include "adaptivity/singular/SingularPoints.hpp"
#include "bem/base/Family.hpp"
#include "bem/base/SchemaRow.hpp"
#include "bem/basis/Legendre.hpp"

#include <string>
#include <vector>

namespace epafi::adaptivity {

struct GradingOptions;

/// What Graded hp does where contact or friction changes its state.
struct Transitions {
  const char* name;
  const char* meaning;
  bool areSingular;  ///< do changes of state count as singular points?
  /// Of an element with changes at these places, of which there are some, in order.
  Mark (*mark)(const std::vector<double>& changes, int degree,
               const GradingOptions& options);
};
bem::Family<Transitions>& transitions();

/// What it does with an element that touches no singular point.
struct SmoothElements {
  const char* name;
  const char* meaning;
  bool (*raisesDegree)(bool analytic);
};
bem::Family<SmoothElements>& smoothElements();

/// The ingredients of Graded hp, each of which can be changed alone.
struct GradingOptions {
  double ratio = 0.1;  ///< in (0, 1/2]: size of a piece next to a singular point
  int degreeStep = 1;  ///< >= 0: what the piece away from it gains
  int weakDegree = 4;  ///< a weak point is left to the degree below this one
  std::string transitions = "Node";        ///< a name of transitions()
  int largestDegree = bem::largestDegree;  ///< that is used: the multiplier's basis'
  std::string smooth = "Raise Degree";     ///< a name of smoothElements()
};

/// The keys of a list of these, and what a list that they have completed says.
bem::SchemaRows gradingRows();
GradingOptions parseGrading(const Teuchos::ParameterList& list);

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
