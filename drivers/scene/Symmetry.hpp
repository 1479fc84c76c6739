#pragma once

#include "bem/geometry/Outline.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace epafi::drivers {

/// Geometry->Symmetry: the line x = 0 or y = 0 about which a scene is symmetric; only one
/// half of the scene is drawn.
struct Symmetry {
  int axis = -1;  ///< normal of the line: 0 for x, 1 for y; -1: no symmetry

  explicit operator bool() const { return axis >= 0; }
  /// Number of copies of the drawn part in the whole scene.
  double copies() const { return axis < 0 ? 1 : 2; }
  double& across(bem::Vec2& v) const { return axis == 0 ? v.x : v.y; }
  bem::Vec2 mirrored(bem::Vec2 v) const {
    across(v) = -across(v);
    return v;
  }
  /// Does the line cut the body, so that the outline has a roller on it?  Otherwise the
  /// body has a mirror image.
  bool cuts(const bem::Outline& outline) const;
  /// "x = 0"
  std::string line() const { return axis == 0 ? "x = 0" : "y = 0"; }

  /// The name of all rollers on the line.
  static constexpr const char* boundary = "symmetry";
  /// The name of edges without a name of their own.
  static constexpr const char* unnamed = "any";
};

/// Reads the validated list Geometry at the root.
Symmetry parseSymmetry(const Teuchos::ParameterList& geometry);

/// \throws bem::InputError, ending with `why`, if a condition or a contact of a validated scene names
/// this boundary of a body.
void requireUnnamed(const Teuchos::ParameterList& scene, const std::string& body,
                    const std::string& boundary, const std::string& why);

/// The outlines of all bodies of a validated scene, in order: vertices near the line are
/// moved onto it, and rollers on it are named Symmetry::boundary.  Those are the edges on it
/// named `symmetry` or `any`; of a body without such all those without a condition of their own.
/// Others on it, such as cracks, keep their condition or are free.  A body whose edges on it
/// all meet obstacles touches its mirror image.
/// \throws bem::InputError if they lie on both sides of the line, if no edge is on it or one
///   off it is named Symmetry::boundary, if a condition or a contact names rollers, or if a
///   body without rollers has a load, a support or another body at edges on the line.
std::vector<bem::Loops> alignedWith(const Symmetry& symmetry,
                                    std::vector<bem::Loops> loops,
                                    const Teuchos::ParameterList& scene);

}  // namespace epafi::drivers
