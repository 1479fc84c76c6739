#pragma once

#include "contact/results/ContactFields.hpp"
#include "contact/results/Summary.hpp"
#include "drivers/run/Level.hpp"
#include "drivers/scene/Scene.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// The boundary as short straight lines with the fields on them, for pictures, in the
/// user's units; vectors as three numbers each.
///
/// An element of degree p has 2(p+1) lines and its own points at both ends, since
/// tractions jump from element to element.  Points without contact have no pressure,
/// shear and gap (NaN) and -1 as states; states are numbered as in contact.csv.
struct BoundaryLines {
  std::vector<double> points;        ///< x, y, 0, not displaced
  std::vector<double> displacement;  ///< ux, uy, 0
  std::vector<double> traction;      ///< tx, ty, 0
  std::vector<double> pressure;      ///< λₙ
  std::vector<double> shear;         ///< λₜ
  std::vector<double> gap;
  std::vector<int> contact;
  std::vector<int> friction;

  std::vector<long long> ends;  ///< of each line, two points
  std::vector<int> element;     ///< of each line
  std::vector<int> degree;
  std::vector<int> boundary;  ///< index into boundaryNames of all bodies
  std::vector<int> body;
};

/// Of all bodies, one after the other, those that do not deform last, their edges as elements;
/// boundaries are numbered likewise, and named so.
BoundaryLines boundaryLines(const Scene& scene, const SolvedLevel& level);
std::vector<std::string> namesOfBoundaries(const Scene& scene);

/// As files number them: 0 none, 1 stick, 2 slip.
inline int numberOf(contact::FrictionKind friction) { return static_cast<int>(friction); }

/// boundary.csv: displacement and traction along the whole boundary of what deforms, element
/// by element, both ends included, with the element's boundary, number and degree; the
/// traction is the density ψ of Steklov-Poincaré's operator.
std::string boundaryCsv(const Scene& scene, const BoundaryLines& grid);

}  // namespace epafi::drivers
