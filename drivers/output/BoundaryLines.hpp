#pragma once

#include "contact/results/ContactFields.hpp"
#include "contact/results/Summary.hpp"
#include "drivers/output/VtkGrid.hpp"
#include "drivers/run/Level.hpp"
#include "drivers/scene/Scene.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// The boundary as short straight segments with the fields at their ends, for plots.  All
/// values are in the user's units; vectors have three components.
///
/// Elements of degree p have at least 2(p+1) segments, arcs at least one per 5 degrees;
/// they share no points, since tractions jump.  Points without contact have NaN as
/// pressure, shear and gap, -1 as states, which are numbered as in contact.csv.
struct BoundaryLines {
  std::vector<double> points;        ///< x, y, 0 of the undeformed boundary
  std::vector<double> displacement;  ///< ux, uy, 0
  std::vector<double> traction;      ///< tx, ty, 0
  std::vector<double> pressure;      ///< λₙ
  std::vector<double> shear;         ///< λₜ
  std::vector<double> gap;
  std::vector<int> contact;
  std::vector<int> friction;

  std::vector<long long> ends;  ///< indices of the two end points of each segment
  std::vector<int> element;     ///< of each segment
  std::vector<int> degree;
  std::vector<int> boundary;  ///< index into namesOfBoundaries
  std::vector<int> body;

  /// For steps/<k>/boundary.vtu and solution.hdf.  Refers to this.
  VtkGrid grid() const;
};

/// The boundaries of all bodies in the order of the scene, rigid bodies last with edges
/// as elements.  Boundaries are numbered in the same order, by namesOfBoundaries.
BoundaryLines boundaryLines(const Scene& scene, const SolvedLevel& level);
std::vector<std::string> namesOfBoundaries(const Scene& scene);

/// The number of a friction state in the files: 0 none, 1 stick, 2 slip.
inline int numberOf(contact::FrictionKind friction) { return static_cast<int>(friction); }

/// boundary.csv: displacement and traction at the points of all elastic bodies, element
/// by element, with boundary, number and degree of the element.  The traction is the
/// density ψ plus the traction of the particular solution for body loads.
std::string boundaryCsv(const Scene& scene, const BoundaryLines& grid);

}  // namespace epafi::drivers
