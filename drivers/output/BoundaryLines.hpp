#pragma once

#include "contact/results/Solved.hpp"
#include "drivers/output/Table.hpp"
#include "drivers/output/VtkGrid.hpp"
#include "drivers/run/SolvedStep.hpp"

#include <optional>
#include <string>
#include <vector>

namespace epafi::drivers {

/// The boundary as short straight segments with the fields at their ends, for plots, for
/// steps/<k>/boundary.vtu and solution.hdf: of all bodies in the order of the scene, rigid
/// bodies last with edges as elements.
///
/// Elements of degree p have at least 2(p+1) segments, arcs at least one per 5 degrees;
/// they share no points, since tractions jump.  Points without contact have NaN as
/// pressure, shear and gap, -1 as states, which are numbered as in contact.csv.
VtkGrid boundaryLines(const SolvedStep& solved);
/// In the order in which these segments number boundaries.
std::vector<std::string> namesOfBoundaries(const Scene& scene);

/// Adds a sentence if two bodies without a contact between them, or a body and its mirror image,
/// overlap once they are deformed, by more than a tenth of the largest displacement.
void findOverlap(const Scene& scene, const VtkGrid& grid,
                 std::vector<std::string>& warnings);

/// The number of a friction state in the files: 0 none, 1 stick, 2 slip.
inline int numberOf(contact::ContactState friction) {
  return friction == contact::ContactState::Frictionless ? 0 : slips(friction) ? 2 : 1;
}

/// A point of boundary.csv, in the user's units.
struct BoundaryRow {
  bem::Vec2 x{};
  bem::Vec2 displacement{};
  bem::Vec2 traction{};
  std::string boundary{};
  int element = 0;
  int degree = 0;
  std::string body{};
  int edge = 0;
  double along = 0;  ///< stress along the boundary
  double vonMises = 0;
  std::optional<double> around{};  ///< of solids of revolution
};
Cells cellsOf(const BoundaryRow& row);

/// boundary.csv: displacement and traction at the points of all elastic bodies, element
/// by element, with boundary, number and degree of the element, and the edge of the outline
/// on which it lies.  The traction is the density ψ plus the traction of the particular
/// solution for body loads.
std::string boundaryCsv(const Scene& scene, const VtkGrid& grid);

}  // namespace epafi::drivers
