// Epafi inside another application: mpirun -n 2 embed
//
// 1. A boundary value problem solved by the application's own Belos with S inside.
// 2. Frictional contact followed by LOCA over the friction factor.

#include "Elastic.hpp"
#include "Friction.hpp"

#include <Tpetra_Core.hpp>

#include <cmath>
#include <cstdio>

namespace {

int run(const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  const epafi::bem::MpiProcesses processes(comm);
  const embed::Block block(16);
  const embed::Elastic elastic = embed::solveElastic(block, processes);
  const std::vector<embed::Point> path = embed::followFriction(block, processes);

  bool good = std::abs(elastic.energy - elastic.exact) < 1e-10;
  if (comm->getRank() == 0) {
    std::printf("# pulled block: strain energy, exact\n%.12f %.12f\n", elastic.energy,
                elastic.exact);
    std::printf("# pressed block: friction factor, slip length, shear\n");
  }
  for (const embed::Point& point : path) {
    good = good && point.difference < 1e-9;
    if (comm->getRank() == 0)
      std::printf("%.12f %.12f %.12f\n", point.factor, point.slipLength, point.shear);
  }
  if (!good && comm->getRank() == 0)
    std::fprintf(stderr, "embed: the results are wrong\n");
  return good ? 0 : 1;
}

}  // namespace

int main(int argc, char* argv[]) {
  const Tpetra::ScopeGuard scope(&argc, &argv);
  try {
    return run(Tpetra::getDefaultComm());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "embed: %s\n", error.what());
    return 1;
  }
}
