#include "drivers/scene/LinearMethod.hpp"

#include "bem/base/Error.hpp"
#include "contact/compressed/CompressedStiffness.hpp"
#include "drivers/process/Ranks.hpp"
#include "drivers/scene/Scene.hpp"

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
      "linear method",
      {
          {"Dense", "Cholesky's factors", factors},
          {"Belos", "conjugate gradients, for each column", belos},
          {"Compressed",
           "by skeletons, time and memory nearly proportional to the elements; "
           "Stabilization->Form Density or None",
           factors, LinearMethod::Operators::Compressed},
          {"Automatic",
           "Compressed where that is possible, from 3100 displacements and densities of "
           "one "
           "body on, later where bodies meet, on meshes graded by less than 1e6 of "
           "bodies "
           "that are not slender; else Dense; never changes Stabilization->Form",
           factors, LinearMethod::Operators::Cheaper},
      });
  return family;
}

bem::SchemaRows linearRows() {
  bem::SchemaRows rows = {
      bem::Row("Method", bem::Kind::Text,
               "how systems with the boundary operators are solved; " +
                   meanings(linearMethods()))
          .standard(LinearOptions().method)
          .allowed(linearMethods().names())};
  append(rows, bem::belosRows());
  append(rows, {bem::Row("Compression Tolerance", bem::Kind::Real,
                         "Compressed: of what groups of elements do to others")
                    .unit("1")
                    .standard(LinearOptions().compression.tolerance)
                    .range({1e-13, 1e-4, false, false})});
  return rows;
}

void checkLinear(const Scene& scene) {
  const LinearMethod& method = linearMethods().at(scene.linear.method);
  const std::string reason = contact::whyNotCompressed(scene.stabilization);
  if (method.operators == LinearMethod::Operators::Compressed && !reason.empty())
    throw bem::InputError("Solver->Linear->Method = ", method.name, ": ", reason,
                          "; Dense, Belos and Automatic are possible");
}

LinearOptions parseLinear(const Teuchos::ParameterList& list) {
  LinearOptions options{list.get<std::string>("Method"), bem::parseBelos(list), {}};
  options.compression.tolerance = list.get<double>("Compression Tolerance");
  return options;
}

}  // namespace epafi::drivers
