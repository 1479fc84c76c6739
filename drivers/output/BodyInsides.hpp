#pragma once

#include "drivers/output/Inside.hpp"
#include "drivers/output/Triangulation.hpp"
#include "drivers/run/BodySpaces.hpp"

namespace epafi::drivers {

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
