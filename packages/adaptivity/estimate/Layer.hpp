#pragma once

#include "bem/base/Material.hpp"
#include "bem/fields/BoundaryFields.hpp"
#include "contact/conditions/Conditions.hpp"

#include <limits>

namespace epafi::adaptivity {

/// What is behind an element, through its body: a thin layer if it is nearer than the element is
/// long.                                             [doc/theory/estimators.md, Thin layers]
struct Layer {
  double thickness = std::numeric_limits<double>::infinity();  ///< way to the side behind
  bool isHeld = false;  ///< is the side behind in contact, or its displacement given?

  /// Stiffness over μ against motions across and along the layer.
  struct Stiffness {
    double across = 0;
    double along = 0;
  };
  /// By how much a layer is stiffer than a half plane, 1/length, against displacements of one
  /// side that vary on a length.
  Stiffness beyondHalfPlane(const bem::Lame& lame, double length) const;

  /// Σ across |m_n|² + along |m_t|² of the Legendre terms of m on an element, the one of degree
  /// k with the stiffness for the length h/k; m has the mean zero, given are the values of m'.
  double square(const bem::Lame& lame, const bem::Mesh& mesh, int element,
                const std::vector<bem::BoundaryValue>& values) const;
};

/// The layer behind the middle of an element; infinitely thick if only its own edge or the edges
/// next to it are behind.
Layer layerBehind(const bem::Mesh& mesh, const contact::Conditions& conditions,
                  int element);

}  // namespace epafi::adaptivity
