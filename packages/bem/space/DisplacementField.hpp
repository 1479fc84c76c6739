#pragma once

#include "bem/space/Space.hpp"

namespace epafi::bem {

/// A displacement u of the boundary at points of elements.  Refers to the space and the
/// coefficients.
class DisplacementField {
 public:
  /// Sums over all coefficients once on meshes with arcs, for ω(u) of Rotation.
  DisplacementField(const Space& space, const Vector& coefficients)
      : space_(&space),
        coefficients_(&coefficients),
        omega_(space.rotation() == nullptr ? 0 : space.rotation()->amount(coefficients)) {
  }

  const Space& space() const { return *space_; }
  /// ω(u) of Rotation; 0 on meshes without arcs.
  double turn() const { return omega_; }

  Vec2 at(int e, double t) const {
    const Vec2 value = space_->polynomialAt(*coefficients_, e, t);
    return omega_ == 0 ? value : value + omega_ * space_->rotationRest(e, t);
  }

 private:
  const Space* space_;
  const Vector* coefficients_;
  double omega_;
};

}  // namespace epafi::bem
