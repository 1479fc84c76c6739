#include "drivers/scene/LinearMethod.hpp"

#include "drivers/process/Ranks.hpp"

#include <Teuchos_ParameterList.hpp>

namespace epafi::drivers {

namespace {

using Solver = std::unique_ptr<const bem::SingleLayerSolver>;

Solver factors(const Ranks&, const LinearOptions&) { return nullptr; }

Solver belos(const Ranks& ranks, const LinearOptions& options) {
  return ranks.belosSolver(options.belos);
}

}  // namespace

bem::Family<LinearMethod>& linearMethods() {
  static bem::Family<LinearMethod> family(
      "linear method", {
                           {"Dense", "Cholesky's factors", factors},
                           {"Belos", "conjugate gradients, for each column", belos},
                       });
  return family;
}

bem::SchemaRows linearRows() {
  bem::SchemaRows rows = {
      bem::Row("Method", bem::Kind::Text,
               "how the single layer potential is inverted; " + meanings(linearMethods()))
          .standard(LinearOptions().method)
          .allowed(linearMethods().names())};
  append(rows, bem::belosRows());
  return rows;
}

LinearOptions parseLinear(const Teuchos::ParameterList& list) {
  return {list.get<std::string>("Method"), bem::parseBelos(list)};
}

}  // namespace epafi::drivers
