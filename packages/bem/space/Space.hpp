#pragma once

#include "bem/base/Matrix.hpp"
#include "bem/space/Rotation.hpp"

#include <memory>
#include <numeric>
#include <utility>

namespace epafi::bem {

/// Discrete spaces on a mesh and their numbering.                       [P (10), (11)]
///
///   displacements: continuous, of degree p on each element (DisplacementBasis); on a mesh
///                  with arcs they represent rotations exactly (Rotation),
///   densities:     discontinuous Legendre series with Element::densities terms: p, or
///                  more.
///
/// Component c is 0 for x and 1 for y.  Displacements are numbered element by element: all
/// components of the start node, then of the bubbles; densities likewise.  A scalar field and its
/// flux have one component.
class Space {
 public:
  /// \param components 1 or 2
  explicit Space(Mesh mesh, int components = 2);

  const Mesh& mesh() const { return mesh_; }
  int components() const { return components_; }

  Index displacements() const { return displacementStart_.back(); }
  Index densities() const { return densityStart_.back(); }

  /// Number of the local basis function k (0 start node, 1 end node, k >= 2 bubble) on e.
  Index displacement(int e, int k, int c) const {
    if (k == 1)
      return displacementStart_[mesh_[e].next] + c;
    return displacementStart_[e] + components_ * (k == 0 ? 0 : k - 1) + c;
  }

  /// Number of P_i on element e.
  Index density(int e, int i, int c) const {
    return densityStart_[e] + components_ * i + c;
  }

  /// Polynomial part of a displacement at a point of an element; all of it:
  /// DisplacementField.  A missing component is zero, here and below.
  Vec2 polynomialAt(const Vector& u, int e, double t) const;
  /// Value of a density at a point of an element.
  Vec2 densityAt(const Vector& psi, int e, double t) const;

  /// Interpolant of `field` (a function of a scaled point): equal at the nodes, with the best
  /// L² approximation of the derivative on each element.  Exact up to rounding for linear
  /// fields.
  template <class Field>
  Vector interpolate(const Field& field) const {
    std::vector<int> all(mesh_.size());
    std::iota(all.begin(), all.end(), 0);
    return interpolateOn(all, field);
  }

  /// Interpolant on some elements; `field` is evaluated only there, and unknowns of other
  /// elements are zero.
  template <class Field>
  Vector interpolateOn(const std::vector<int>& elements, const Field& field) const {
    return interpolatePlaces(
        elements, [&](int e, double t) { return field(mesh_.scaledPoint(e, t)); });
  }
  /// Interpolant on some elements of a function field(e, t).
  template <class Field>
  Vector interpolatePlaces(const std::vector<int>& elements, const Field& field) const {
    std::vector<Vec2> samples;
    for (const int e : elements)
      for (const double t : samplePoints(mesh_[e].degree))
        samples.push_back(field(e, t));
    return interpolateSamples(elements, samples);
  }

  /// Null if all elements are straight, since polynomials then represent rotations, and for solids
  /// of revolution and scalar fields, which have none.
  std::shared_ptr<const Rotation> rotation() const { return rotation_; }
  /// P u of Rotation.
  Vector withoutRotation(Vector u) const {
    return rotation_ == nullptr ? u : rotation_->without(std::move(u));
  }
  /// r - r_I of Rotation at a point of an element; zero on a straight one.
  Vec2 rotationRest(int e, double t) const;

  /// Columns: the rigid motions (1,0), (0,1), (-y, x) about the origin of the scaled
  /// outline; a solid of revolution has the second one alone, the others are zero.  A scalar
  /// field has one column, the constant.
  Matrix rigidMotions() const;

 private:
  /// All components from a number on.
  Vec2 coefficient(const Vector& x, Index first) const {
    return {x[at(first)], components_ == 2 ? x[at(first) + 1] : 0};
  }
  Vector interpolateSamples(const std::vector<int>& elements,
                            const std::vector<Vec2>& samples) const;
  std::vector<double> samplePoints(int degree) const;

  Mesh mesh_;
  int components_;
  std::vector<Index> displacementStart_;
  std::vector<Index> densityStart_;
  std::shared_ptr<const Rotation> rotation_;
};

}  // namespace epafi::bem
