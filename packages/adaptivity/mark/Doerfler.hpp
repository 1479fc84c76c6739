#pragma once

#include "bem/base/Matrix.hpp"

#include <vector>

namespace epafi::adaptivity {

/// Dörfler's marking: the smallest set of elements whose squared indicators sum up to at
/// least `fraction` of all, 0 < fraction <= 1.                          [P Alg. 25 (c)]
///
/// Elements that equal the smallest one of the set within 1e-10 are marked as well, so
/// that rounding does not break symmetries.  In increasing order; empty when all squares
/// are zero.
std::vector<int> doerfler(const bem::Vector& squares, double fraction);

/// The same over the elements of all bodies together: of each body, its own.
std::vector<std::vector<int>> doerfler(const std::vector<bem::Vector>& squares,
                                       double fraction);

}  // namespace epafi::adaptivity
