// What the dense algebra of one level costs on this many ranks:
//
//   mpirun -n 2 --bind-to none build/bin/bench_algebra [ROWS [REPETITIONS]]
//
// A line for each operation: the least seconds by the clock on the wall of the slowest
// rank, and the rate of floating point operations of all ranks together.
#include "bem/tpetra/TpetraAlgebra.hpp"

#include <Tpetra_Core.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

namespace epafi {

namespace {

using bem::Index;
using bem::Matrix;

/// Entries that fall off from the diagonal: dominated by it when `shift` is added there.
Matrix myEntries(const bem::DenseAlgebra& algebra, Index n, Index m, double shift) {
  const bem::Rows mine = algebra.myRows(n);
  Matrix rows(mine.size(), m);
  for (Index j = 0; j < m; ++j)
    for (Index i = 0; i < mine.size(); ++i) {
      const Index distance = std::abs(i + mine.begin - j);
      rows(i, j) =
          1 / (1.0 + static_cast<double>(distance)) + (distance == 0 ? shift : 0);
    }
  return rows;
}

class Stopwatch {
 public:
  explicit Stopwatch(const bem::DenseAlgebra& algebra) : algebra_(algebra) {}

  /// The result of an operation that all ranks begin together.
  template <class Operation>
  auto time(const std::string& name, double flops, const Operation& operation) {
    algebra_.sum({0});
    const double start = MPI_Wtime();
    auto result = operation();
    bem::Vector seconds(algebra_.processes());
    seconds[algebra_.rank()] = MPI_Wtime() - start;
    seconds = algebra_.sum(std::move(seconds));
    const double slowest = *std::max_element(seconds.begin(), seconds.end());
    const auto [entry, isNew] = least_.try_emplace(name, Cost{slowest, flops});
    if (!isNew)
      entry->second.seconds = std::min(entry->second.seconds, slowest);
    return result;
  }

  void print() const {
    if (algebra_.rank() == 0)
      for (const auto& [name, cost] : least_)
        std::printf("%-34s %8.3f s %8.1f Gflop/s\n", name.c_str(), cost.seconds,
                    cost.flops / cost.seconds * 1e-9);
  }

 private:
  struct Cost {
    double seconds;
    double flops;
  };
  const bem::DenseAlgebra& algebra_;
  std::map<std::string, Cost> least_;
};

void measure(const bem::TpetraAlgebra& algebra, Index n, int repetitions) {
  const Index few = n / 4;
  const auto size = static_cast<double>(n);
  const double cube = size * size * size;

  Stopwatch stopwatch(algebra);
  for (int r = 0; r < repetitions; ++r) {
    const auto factor = stopwatch.time("1 Cholesky, n", cube / 3, [&] {
      return algebra.cholesky(myEntries(algebra, n, n, 30), "A");
    });
    const Matrix half = stopwatch.time("2 L^-1 B, n columns", cube, [&] {
      return factor->forward(myEntries(algebra, n, n, 0));
    });
    Matrix sum = stopwatch.time("3 C + Y'Y, n columns", cube, [&] {
      return algebra.addGram(myEntries(algebra, n, n, 0), half);
    });
    const Matrix thin = stopwatch.time("4 L^-1 B, n/4 columns", cube / 4, [&] {
      return factor->forward(myEntries(algebra, n, few, 0));
    });
    stopwatch.time("5 X'Y, n and n/4 columns", cube / 2, [&] {
      return algebra.addTransposeTimes(Matrix(algebra.myRows(n).size(), few), half, thin);
    });
    stopwatch.time("6 C - XX', n/4 columns", cube / 4,
                   [&] { return algebra.addOuter(std::move(sum), thin, -1); });
    stopwatch.time("7 A^-1 b", 2 * size * size,
                   [&] { return factor->solve(bem::Vector(n)); });
  }
  stopwatch.print();
}

}  // namespace

}  // namespace epafi

int main(int argc, char* argv[]) {
  const Tpetra::ScopeGuard scope(&argc, &argv);
  epafi::measure(epafi::bem::TpetraAlgebra(Tpetra::getDefaultComm()),
                 argc > 1 ? std::atoi(argv[1]) : 2048, argc > 2 ? std::atoi(argv[2]) : 3);
}
