#pragma once

#include "bem/geometry/Outline.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace epafi::drivers {

/// Geometry->Symmetry: the line x = 0 or y = 0 about which a scene is symmetric, of which one
/// half is drawn.
struct Symmetry {
  int axis = -1;  ///< across the line: 0 along x, 1 along y; -1: there is no such line

  explicit operator bool() const { return axis >= 0; }
  /// How many times what is drawn is there.
  double copies() const { return axis < 0 ? 1 : 2; }
  double& across(bem::Vec2& v) const { return axis == 0 ? v.x : v.y; }
  bem::Vec2 mirrored(bem::Vec2 v) const {
    across(v) = -across(v);
    return v;
  }
  /// Does an outline have an edge on the line?  The body then is one half of a whole one; others
  /// are one of two that are mirror images.
  bool cuts(const bem::Outline& outline) const;
  /// "x = 0"
  std::string line() const { return axis == 0 ? "x = 0" : "y = 0"; }

  /// What all edges on the line are called.
  static constexpr const char* boundary = "symmetry";
};

/// Of the validated list Geometry at the root.
Symmetry parseSymmetry(const Teuchos::ParameterList& geometry);

/// The outlines of the bodies of a scene's validated list, in their order, with vertices near the
/// line on it and edges on it called Symmetry::boundary.
/// \throws bem::InputError if they lie on both sides of the line, none has an edge on it, another
///   edge is called so, or a condition or a contact names edges on it.
std::vector<bem::Loops> alignedWith(const Symmetry& symmetry,
                                    std::vector<bem::Loops> loops,
                                    const Teuchos::ParameterList& scene);

}  // namespace epafi::drivers
