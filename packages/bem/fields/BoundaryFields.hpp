#pragma once

#include "bem/base/Material.hpp"
#include "bem/fields/KernelRows.hpp"
#include "bem/fields/RingFields.hpp"
#include "bem/fields/SourceGroups.hpp"
#include "bem/moments/ElementRuns.hpp"
#include "bem/quadrature/Graded.hpp"
#include "bem/space/LocalField.hpp"

#include <memory>
#include <vector>

namespace epafi::bem {

/// Values of both integral equations at a point of an element, dimensionless; the residuals are
/// computed from them.
struct BoundaryValue {
  EndPoint place;
  double weight = 0;  ///< quadrature weight, by Mesh::measure
  Vec2 traction;      ///< W u + (K' + 1/2) ψ
  Vec2 mismatch;      ///< d/ds (V ψ - (K + 1/2) u)
};

/// Coefficient vectors (u, ψ).
struct BoundaryState {
  const Vector& displacement;
  const Vector& density;
};

/// Evaluates both integral equations for some states (u, ψ) at points of the boundary.  Kernels
/// are integrated once for all states: rows of a matrix times their coefficients, see KernelRows.
///
/// Near elements are integrated in closed form, at points graded toward the ends of the element
/// and its neighbours, where the values have logarithms.  Far elements are integrated with
/// Gauss points (error 1e-12 of their field), on large meshes by SourceGroups; their sum is
/// interpolated.  The weights integrate squares of the values to a relative error of 2e-6.
///
/// On solids of revolution they are polynomials, see RingFields; on the axis there are none.
class BoundaryFields {
 public:
  /// Refers to the space.
  BoundaryFields(const Space& space, const Lame& lame,
                 const std::vector<BoundaryState>& states);

  /// For each state the values at the points of a rule.
  using Values = std::vector<std::vector<BoundaryValue>>;

  /// Values on one element; thread-safe.
  /// \param cuts places where the data on the element are not smooth; the rule is cut there
  Values on(int element, const Vector& cuts = {}) const;

  /// Values at given points, weights zero.
  Values at(int element, const std::vector<EndPoint>& points) const;

 private:
  struct Sources;

  const Mesh& mesh() const { return sources_.mesh; }
  std::vector<LocalField> fieldsOf(int f) const;  ///< of the states
  void setSources();
  void split(int element, int r, Sources& sources) const;
  Sources split(int element) const;
  Matrix smoothSeries(int element, const Sources& sources) const;
  Values ofRings(int element, const std::vector<EndPoint>& points) const;
  Values at(int element, const Sources& sources,
            const std::vector<EndPoint>& points) const;

  FieldSources sources_;  ///< with the degrees of the densities
  ElementRuns runs_;      ///< of its mesh
  const Space& space_;
  Lame lame_;
  std::size_t states_;
  std::vector<Vector> displacements_;  ///< by state, P u of Rotation
  std::vector<Vector> densities_;
  std::unique_ptr<const SourceGroups> groups_;
  std::unique_ptr<const RingFields>
      rings_;  ///< of solids of revolution, in place of the others
};

}  // namespace epafi::bem
