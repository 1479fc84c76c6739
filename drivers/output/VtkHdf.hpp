#pragma once

#include "drivers/output/BoundaryLines.hpp"
#include "drivers/output/Hdf5Writer.hpp"

namespace epafi::drivers {

/// Writes the boundary as lines with the fields on them into the group /VTKHDF, which ParaView
/// opens.
void writeVtkHdf(const BoundaryLines& grid, Hdf5Writer& writer);

}  // namespace epafi::drivers
