#pragma once

#include "bem/mesh/Surfaces.hpp"
#include "bem/operators/RingLaplace.hpp"
#include "bem/quadrature/LegendreSeries.hpp"
#include "contact/conditions/RingSources.hpp"

#include <array>

namespace epafi::contact {

/// On the surface of a solid of revolution, of T and q less what c₀ + c₁ z and sources have, by
/// integrals along it:  S' = r q,  Ψ' = t_r S/r + t_z T,  so that ∇Ψ = (S/r, T).
///                                                             [doc/theory/body-loads.md]
class RingPotential {
 public:
  using Series = bem::LegendreSeries<double>;
  using Free = std::array<double, 2>;  ///< c₀, c₁
  /// An element, divided where it is long beside its distance from the axis.
  struct Part {
    int element = 0;
    double from = -1;  ///< of the element
    double to = 1;
    Series temperature{};  ///< T and q as they were given
    Series flow{};
    Series rest{};       ///< ∂Ψ/∂z
    Series restSlope{};  ///< along the surface
    Series restFlow{};
    Series around{};     ///< S/r²
    Series potential{};  ///< Ψ
  };

  /// \param data  Cauchy data on a space of heat, see MixedLaplace
  RingPotential(const bem::Space& space, const bem::Vector& data);

  /// Integrates what is left of T and q.  What a surface gains by errors is spread over it.
  void follow(const RingSources& sources, const Free& free);
  /// Adds to S, and to Ψ at the surface's start.
  void addStarts(std::size_t surface, double flow, double potential) {
    flowStarts_[surface] += flow;
    potentialStarts_[surface] += potential;
  }

  const std::vector<Part>& parts() const { return parts_; }
  /// Of the parts, of the largest degree.
  const bem::Mesh& mesh() const { return mesh_; }
  /// The same with degrees beyond those of the elements of the body's mesh.
  bem::Mesh meshOf(const bem::Mesh& mesh, int more) const;
  /// Of parts.
  const std::vector<bem::Surface>& surfaces() const { return surfaces_; }
  /// visit(part, t, area) of the points of a rule on a surface.
  template <class Visit>
  void forEachPoint(std::size_t surface, const Visit& visit) const {
    const bem::Rule& rule = bem::gaussLegendre(bem::largestDegree + 1);
    for (const int e : surfaces_[surface].elements)
      for (std::size_t q = 0; q < rule.points.size(); ++q)
        visit(e, rule.points[q], rule.weights[q] * mesh_.measure(e, rule.points[q]));
  }
  /// What Ψ gains around a closed surface.
  double gain(std::size_t surface) const { return gains_[surface]; }

 private:
  static std::vector<Part> partsOf(const bem::Mesh& mesh);
  void take(const bem::Space& space, const bem::Vector& data);
  void integrateFlow(std::size_t surface);
  double integrateSlope(std::size_t surface);

  std::vector<Part> parts_;
  bem::Mesh mesh_;
  std::vector<bem::Surface> surfaces_;
  bem::Vector flowStarts_;  ///< S and Ψ where the surfaces start
  bem::Vector potentialStarts_;
  bem::Vector gains_;
};

}  // namespace epafi::contact
