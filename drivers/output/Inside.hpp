#pragma once

#include "bem/base/Material.hpp"
#include "bem/space/Space.hpp"
#include "drivers/output/Triangulation.hpp"
#include "drivers/run/BodySpaces.hpp"

namespace epafi::drivers {

/// Displacement and stress at a point inside a body, in the user's units.
struct InsideValue {
  bem::Vec2 displacement;
  double xx = 0;
  double yy = 0;
  double xy = 0;
  double zz = 0;        ///< across the plane: ν (σxx + σyy), or 0 in plane stress
  double vonMises = 0;  ///< √(½ Σ of squared differences of normal stresses + 3 σxy²)
  double principal1 = 0;  ///< the larger principal stress in the plane
  double principal2 = 0;
};

/// The fields inside a body whose boundary data are known: closed forms, as accurate next to
/// the boundary as far from it.                                [doc/theory/operators.md]
class Inside {
 public:
  /// `displacement`, `density`: all unknowns, dimensionless; kept by reference as the space.
  Inside(const bem::Space& space, const bem::Material& material, const bem::Units& units,
         const bem::Vector& displacement, const bem::Vector& density);

  const bem::Space& space() const { return space_; }

  /// At a point inside, in the user's coordinates.
  InsideValue at(bem::Vec2 point) const;
  /// At the boundary, t in [-1, 1] on element e: just inside, and off the element's ends,
  /// where the stress of a piecewise density has logarithms.
  InsideValue atBoundary(int e, double t) const;

 private:
  const bem::Space& space_;
  bem::Material material_;
  bem::Lame lame_;
  bem::Units units_;
  const bem::Vector& displacement_;
  const bem::Vector& density_;
};

/// The fields inside all elastic bodies on a solved level.
class BodyInsides {
 public:
  /// Refers to both.
  BodyInsides(const Scene& scene, const Level& level);

  std::size_t size() const { return insides_.size(); }
  const Inside& operator[](std::size_t b) const { return insides_[b]; }
  const bem::Mesh& mesh(std::size_t b) const { return insides_[b].space().mesh(); }

  /// At points each of which lies in a body; on all threads.
  std::vector<InsideValue> at(const std::vector<bem::Vec2>& points) const;
  /// x,y,ux,uy,sxx,syy,sxy,von_mises,body,szz,principal_1,principal_2: a row per point.
  std::string csv(const std::vector<bem::Vec2>& points,
                  const std::vector<InsideValue>& values) const;

 private:
  const Scene& scene_;
  BodySpaces spaces_;
  std::vector<Inside> insides_;
};

}  // namespace epafi::drivers
