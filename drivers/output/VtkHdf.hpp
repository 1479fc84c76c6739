#pragma once

#include "drivers/output/FieldGrid.hpp"
#include "drivers/output/Hdf5Writer.hpp"

namespace epafi::drivers {

/// Writes the boundary as lines with the fields on them into the group /VTKHDF, which ParaView
/// opens.
void writeVtkHdf(const FieldGrid& grid, Hdf5Writer& writer);

}  // namespace epafi::drivers
