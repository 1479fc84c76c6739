#pragma once

#include "bem/base/DenseAlgebra.hpp"
#include "contact/problem/Summary.hpp"
#include "drivers/output/Hdf5Writer.hpp"

namespace epafi::drivers {

/// The boundary as short straight lines with the fields on them, for pictures: this
/// process's elements, in the user's units.
///
/// An element of degree p has 2(p+1) lines and its own points at both ends, since
/// tractions jump from element to element.  Points without contact have no pressure,
/// shear and gap (NaN) and -1 as states; states are numbered as in contact.csv.
struct FieldGrid {
  Slice<double> points;        ///< x, y, 0, not displaced
  Slice<double> displacement;  ///< ux, uy, 0
  Slice<double> traction;      ///< tx, ty, 0
  Slice<double> pressure;      ///< λₙ
  Slice<double> shear;         ///< λₜ
  Slice<double> gap;
  Slice<int> contact;
  Slice<int> friction;

  Slice<long long> ends;  ///< of each line, two points
  Slice<int> element;     ///< of each line
  Slice<int> degree;
  Slice<int> boundary;  ///< index into boundaryNames
};

FieldGrid fieldGrid(const contact::Solved& solved, const bem::Vector& density,
                    const bem::DenseAlgebra& algebra);

/// The names of a mesh's boundaries, in the order of the outline's edges.
std::vector<std::string> boundaryNames(const bem::Outline& outline);

}  // namespace epafi::drivers
