#pragma once

#include "bem/mesh/Mesh.hpp"
#include "reference/QuadMoments.hpp"

#include <vector>

namespace epafi::reference {

/// The double integrals of bem::Tile for two elements, segments or arcs, by plain
/// quadrature in 33 digits, to about 1e-15: both are bisected until each pair of parts is as
/// far apart as the longer one is long; what is left next to a common point is smaller than
/// 1e-16.  An element with itself: over s - t, graded to 0.
class ArcMoments {
 public:
  enum Field { Log, PhaseReal, PhaseImag, Direct, Reverse, Fields };

  ArcMoments(const bem::Mesh& mesh, int e, int f, int largestDegree);

  /// ∫∫ P_i(s) P_j(t) field: log|w|, w/conj(w), (w·n_F)/|w|² h_F/2, (-w·n_E)/|w|² h_E/2.
  double operator()(Field field, int i, int j) const;

 private:
  struct Arc {
    QuadVec from;
    QuadVec middleTangent;
    Quad half;
    Quad alpha;
    QuadVec point(const Quad& t) const;
    QuadVec tangent(const Quad& t) const;
  };
  struct Part {
    Quad from;
    Quad to;
  };

  static Arc arcOf(const bem::Mesh& mesh, int e);
  void bisect(Part s, Part t, int level);
  void addApart(Part s, Part t);
  void addSelf();
  void addPoint(const Quad& s, const Quad& t, const Quad& weight);
  Quad& value(int field, int i, int j) {
    return values_[(field * (degree_ + 1) + i) * (degree_ + 1) + j];
  }

  Arc e_;
  Arc f_;
  int degree_;
  QuadRule rule_;
  std::vector<Quad> values_;
};

}  // namespace epafi::reference
