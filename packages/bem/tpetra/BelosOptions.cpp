#include "bem/tpetra/BelosOptions.hpp"

#include <Teuchos_ParameterList.hpp>

namespace epafi::bem {

SchemaRows belosRows() {
  const BelosOptions defaults;
  return {
      Row("Tolerance", Kind::Real, "Belos: residual relative to the right hand side")
          .unit("1")
          .standard(defaults.tolerance)
          .range({0, 1, true, true}),
      Row("Maximum Iterations", Kind::Whole,
          "Belos: steps for one column; beyond, the run ends with code 2")
          .unit("1")
          .standard(defaults.maximumIterations)
          .range(from(1)),
      Row("Block Size", Kind::Whole, "Belos: columns at once")
          .unit("1")
          .standard(defaults.blockSize)
          .range(from(1)),
  };
}

BelosOptions parseBelos(const Teuchos::ParameterList& list) {
  return {list.get<double>("Tolerance"), list.get<int>("Maximum Iterations"),
          list.get<int>("Block Size")};
}

}  // namespace epafi::bem
