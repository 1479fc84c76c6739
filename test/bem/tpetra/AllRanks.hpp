#pragma once

#include "bem/tpetra/MpiProcesses.hpp"

#include <Tpetra_Core.hpp>

namespace epafi::test {

inline bem::MpiProcesses allRanks() {
  return bem::MpiProcesses(Tpetra::getDefaultComm());
}

}  // namespace epafi::test
