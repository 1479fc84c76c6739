#pragma once

#include "bem/space/Space.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"
#include "contact/problem/Conditions.hpp"

#include <string>
#include <vector>

namespace epafi::contact {

using bem::Index;
using bem::Vector;

/// The numbering of the multiplier: on each contact element of degree p, p+1 normal
/// coefficients and, where there is friction, p+1 tangential ones.  No unknown exists
/// that the scene does not need.                                              [P (12),
/// (14), q = p]
class MultiplierSpace {
 public:
  struct ContactElement {
    int element = 0;  ///< of the mesh
    int degree = 1;
    const std::string* boundary = nullptr;
    const Conditions::Contact* condition = nullptr;
    Index normal = 0;       ///< number of the first normal coefficient
    Index tangential = -1;  ///< number of the first tangential one; -1: frictionless
  };

  /// Contact elements in the order of the mesh.
  MultiplierSpace(const bem::Mesh& mesh, const MultiplierBasis& basis,
                  const Conditions& conditions);

  const MultiplierBasis& basis() const { return *basis_; }
  const std::vector<ContactElement>& elements() const { return elements_; }
  Index normals() const { return normals_; }
  Index size() const { return size_; }

  /// λₙ and λₜ (dimensionless) at a point of a contact element; λₜ = 0 without friction.
  struct Value {
    double normal = 0;
    double tangential = 0;
  };
  Value at(const Vector& multiplier, const ContactElement& element, double t) const;

 private:
  const MultiplierBasis* basis_;
  std::vector<ContactElement> elements_;
  Index normals_ = 0;
  Index size_ = 0;
};

}  // namespace epafi::contact
