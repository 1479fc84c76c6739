#pragma once

#include "bem/moments/Tile.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <utility>
#include <vector>

namespace epafi::reference {

/// Compares the moments of pairs of elements with plain quadrature in 33 digits: errors
/// below 1e-13 of a pair's largest moment.
void testPairs(const bem::Mesh& mesh, const std::vector<std::pair<int, int>>& pairs,
               Teuchos::FancyOStream& out, bool& success);

}  // namespace epafi::reference
