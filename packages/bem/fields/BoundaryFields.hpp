#pragma once

#include "bem/base/Material.hpp"
#include "bem/fields/PointSources.hpp"
#include "bem/fields/SourceGroups.hpp"
#include "bem/moments/ElementRuns.hpp"
#include "bem/quadrature/Graded.hpp"
#include "bem/space/LocalField.hpp"

#include <memory>
#include <vector>

namespace epafi::bem {

/// The residuals' ingredients at a point of an element, dimensionless.
struct BoundaryValue {
  EndPoint place;
  double weight = 0;  ///< of a quadrature rule over the element, by arc length
  Vec2 traction;      ///< W u + (K' + 1/2) ψ
  Vec2 mismatch;      ///< d/ds (V ψ - (K + 1/2) u)
};

/// A displacement and a density, (u, ψ).
struct BoundaryState {
  const Vector& displacement;
  const Vector& density;
};

/// The two integral equations of some states (u, ψ) at points of the boundary.  Kernels are
/// evaluated once for all states: eight take half of their time.
///
/// Elements nearby are integrated exactly at points graded toward the ends of the element
/// and of its neighbours, where both fields have logarithms; far ones act through Gauss
/// points (error 1e-12 of their field), many of them together through their moments where
/// meshes are large, and are interpolated.  Squares of the fields are
/// integrated to 2e-6 of their size by the weights.
class BoundaryFields {
 public:
  BoundaryFields(const Space& space, const Lame& lame,
                 const std::vector<BoundaryState>& states);

  /// Of each state at the points of one rule.
  using Values = std::vector<std::vector<BoundaryValue>>;

  /// Values on one element; calls are independent of each other.  The rule is cut at some
  /// places, where what the fields are compared with is not smooth.
  Values on(int element, const Vector& cuts = {}) const;

  /// Values at chosen points, weights zero.
  Values at(int element, const std::vector<EndPoint>& points) const;

 private:
  struct Stretch;
  struct Far;
  struct Sources;
  struct SmoothSeries;

  void addPlaces(int f, int order, Vec2 middle, PointSources& points) const;
  void carry(int f, int order, PointSources& points) const;
  void addFar(int f, int order, Vec2 middle, PointSources& points) const;
  void splitRun(int element, int r, Sources& sources) const;
  Sources split(int element) const;
  std::vector<SmoothSeries> smoothSeries(int element, const Sources& sources) const;
  Values at(int element, const Sources& sources,
            const std::vector<EndPoint>& points) const;

  Mesh mesh_;
  ElementRuns runs_;  ///< of mesh_
  Lame lame_;
  std::size_t states_;
  std::vector<LocalField> fields_;  ///< of the first element all states, and so on
  /// By order: all elements through that many Gauss points each, as far circles need.
  std::vector<PointSources> everything_;
  std::unique_ptr<const SourceGroups> groups_;
};

}  // namespace epafi::bem
