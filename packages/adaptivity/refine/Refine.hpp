#pragma once

#include "bem/mesh/Mesh.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"
#include "contact/problem/Problem.hpp"

#include <vector>

namespace epafi::adaptivity {

/// The multiplier of one mesh as a function on another mesh of the same outline, in the
/// other's coefficients: values at the Gauss points of each contact element.
///
/// Exact where a new element lies in one old one and has at least its degree, in every
/// basis but those that share nodes, where a common coefficient is the mean of two.
/// \throws bem::NumericalError where the other mesh has contact and this one has none.
contact::Vector carryMultiplier(const bem::Mesh& fromMesh,
                                const contact::MultiplierSpace& from,
                                const contact::Vector& multiplier,
                                const bem::Mesh& toMesh,
                                const contact::MultiplierSpace& to);

/// Refinement of an element for the next level.
class Mark {
 public:
  enum Kind { None, Bisect, RaiseDegree, Cut };

  /// Implicit: a kind other than Cut says everything.
  // NOLINTNEXTLINE(google-explicit-constructor)
  Mark(Kind kind = None) : kind_(kind) {}

  /// Cut at places of (-1, 1), in increasing order; piece k gets degree degrees[k], one
  /// more of them than places.
  static Mark cut(std::vector<double> places, std::vector<int> degrees);

  Kind kind() const { return kind_; }
  const std::vector<double>& places() const { return places_; }
  const std::vector<int>& degrees() const { return degrees_; }

  friend bool operator==(const Mark& mark, Kind kind) { return mark.kind_ == kind; }
  friend bool operator==(const Mark& a, const Mark& b) {
    return a.kind_ == b.kind_ && a.places_ == b.places_ && a.degrees_ == b.degrees_;
  }
  friend bool operator!=(const Mark& mark, Kind kind) { return mark.kind_ != kind; }

 private:
  Kind kind_;
  std::vector<double> places_;
  std::vector<int> degrees_;
};

/// One mark per element.
using Marks = std::vector<Mark>;

/// Is any mark not None?
bool anyMarked(const Marks& marks);

/// The next mesh: bisected elements become two equal ones of the same degree, cut ones
/// what their mark says.
///
/// Positions are halved from both ends of their edge, so that a node next to either
/// vertex keeps its digits through any number of bisections.
/// \throws bem::InputError where a degree would exceed bem::largestDegree.
bem::Mesh refine(const bem::Mesh& mesh, const Marks& marks);

/// The state on one mesh carried over to another one of the same outline, as on the next mesh.
///
/// λ restricted to a new element is a polynomial of at most its degree: it is met
/// exactly in every basis but those that share nodes, where it is met nearly.  Its
/// coefficients need not be admissible any more (Newton's first step sees to that); the
/// rigid motions stay.  An empty state stays empty.
contact::State carry(const bem::Mesh& from, const contact::MultiplierSpace& multiplier,
                     const contact::State& state, const bem::Mesh& to,
                     const contact::Conditions& conditions);

}  // namespace epafi::adaptivity
