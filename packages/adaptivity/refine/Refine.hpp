#pragma once

#include "bem/mesh/Mesh.hpp"

#include <vector>

namespace epafi::adaptivity {

/// Refinement of an element for the next level.
class Mark {
 public:
  enum Kind { None, Bisect, RaiseDegree, Cut };

  /// Implicit, for all kinds but Cut.  \pre kind is not Cut
  // NOLINTNEXTLINE(google-explicit-constructor)
  Mark(Kind kind = None) : kind_(kind) {}

  /// Cut at n places in (-1, 1), in increasing order, into n + 1 elements of given degrees.
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

/// The distance of neighbouring numbers that hold the user's coordinates, in scaled coordinates.
double spacing(const bem::Outline& outline);

/// Is an element so short that coordinates would not tell places on parts of it apart?
bool isShort(const bem::Mesh& mesh, int element);

/// Without marks that cut short elements.
Marks withoutShort(const bem::Mesh& mesh, Marks marks);

/// The next mesh: Bisect gives two elements of equal length and the same degree, Cut
/// those of Mark::cut, RaiseDegree one with the next degree.
///
/// New nodes are computed as distances from both ends of the edge, so that nodes near a
/// vertex lose no digits by repeated bisection.
/// \throws bem::InputError where a degree would exceed bem::largestDegree.
bem::Mesh refine(const bem::Mesh& mesh, const Marks& marks);

}  // namespace epafi::adaptivity
