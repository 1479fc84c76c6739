#pragma once

#include "bem/base/Processes.hpp"

namespace epafi::test {

/// What a suite runs on: this process, or all ranks together where it starts under mpirun.
const bem::Processes& processes();

}  // namespace epafi::test
