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

/// The two integral equations of (u, ψ) at points of the boundary, all in closed form.
///
/// Elements nearby are integrated exactly at points graded toward the ends of the element
/// and of its neighbours, where both fields have logarithms; far ones act through Gauss
/// points (error 1e-12 of their field), many of them together through their moments where
/// meshes are large, and are interpolated.  Squares of the fields are
/// integrated to 2e-6 of their size by the weights.
class BoundaryFields {
 public:
  BoundaryFields(const Space& space, const Lame& lame, const Vector& u,
                 const Vector& psi);

  /// Values on one element; calls are independent of each other.  The rule is cut at some
  /// places, where what the fields are compared with is not smooth.
  std::vector<BoundaryValue> on(int element, const Vector& cuts = {}) const;

  /// Values at chosen points, weights zero.
  std::vector<BoundaryValue> at(int element, const std::vector<EndPoint>& points) const;

 private:
  struct Sources;
  struct SmoothSeries;

  void addPoints(int f, int order, Vec2 middle, PointSources& points) const;
  void splitRun(int element, int r, Sources& sources) const;
  Sources split(int element) const;
  SmoothSeries smoothSeries(int element, const Sources& sources) const;
  std::vector<BoundaryValue> at(int element, const Sources& sources,
                                const std::vector<EndPoint>& points) const;
  BoundaryValue valueAt(int element, const EndPoint& point, const FieldSums& sums,
                        const SmoothSeries& series) const;

  Mesh mesh_;
  ElementRuns runs_;  ///< of mesh_
  Lame lame_;
  std::vector<LocalField> fields_;
  /// By order: all elements through that many Gauss points each, as far circles need.
  std::vector<PointSources> everything_;
  std::unique_ptr<const SourceGroups> groups_;
};

}  // namespace epafi::bem
