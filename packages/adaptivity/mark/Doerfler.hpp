#pragma once

#include "bem/base/Matrix.hpp"

#include <vector>

namespace epafi::adaptivity {

/// Dörfler's marking: the smallest set of elements whose squared indicators sum up to at
/// least `fraction` of all, 0 < fraction <= 1.                          [P Alg. 25 (c)]
///
/// Elements that equal the smallest one of the set within 1e-5 are marked as well, so that
/// symmetric scenes stay symmetric and their images alike: indicators that ought to be equal
/// differ by their quadrature, up to 2e-6 (BoundaryFields).  In increasing order; empty when
/// all squares are zero.
std::vector<int> doerfler(const bem::Vector& squares, double fraction);

/// Marking over the elements of all bodies together; returns the marked elements of each body.
std::vector<std::vector<int>> doerfler(const std::vector<bem::Vector>& squares,
                                       double fraction);

}  // namespace epafi::adaptivity
