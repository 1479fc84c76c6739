#pragma once

#include "Largest.hpp"
#include "bem/moments/Tile.hpp"

namespace epafi::test {

/// Of moments from those of another table, and how large these are.
struct MomentErrors {
  Largest difference;
  Largest size;

  /// A lane of each, for elements of these degrees.
  void take(const bem::Tile& a, int lane, const bem::Tile& b, int lane2, int rows,
            int columns) {
    using bem::Tile;
    for (const auto table :
         {&Tile::log, &Tile::along, &Tile::across, &Tile::direct, &Tile::reverse})
      for (int i = 0; i < rows + (table == &Tile::reverse ? 1 : 0); ++i)
        for (int j = 0; j < columns + (table == &Tile::direct ? 1 : 0); ++j) {
          const int at = i * Tile::stride + j;
          difference.take((a.*table)[at][lane] - (b.*table)[at][lane2]);
          size.take((b.*table)[at][lane2]);
        }
  }
};

}  // namespace epafi::test
