#include "drivers/scene/RunOptions.hpp"

#include "drivers/scene/GeometryReader.hpp"

#include <Teuchos_ParameterList.hpp>

namespace epafi::drivers {

using bem::Kind;
using bem::Row;

bem::SchemaRows limitRows() {
  const RunLimits defaults;
  return {
      Row("Tolerance", Kind::Real,
          "a run ends at the first level whose estimated error is at most this part of "
          "the "
          "energy norm of the solution, on a path in every step; alone it means Strategy "
          "= "
          "Graded hp and Maximum Levels = 100")
          .unit("1")
          .range({0, 1, true, true}),
      Row("Target Estimate", Kind::Real,
          "a run ends at the first level with a smaller estimate")
          .unit("as the estimate: root of stress length^2 under Weights Energy")
          .standard(defaults.estimate)
          .range(bem::from(0)),
      Row("Maximum Levels", Kind::Whole, "levels computed, the first included")
          .unit("1")
          .standard(defaults.levels)
          .range(bem::from(1)),
      Row("Maximum Degrees of Freedom", Kind::Whole,
          "a level with more, displacement and contact stress together, is not computed")
          .unit("1")
          .standard(static_cast<double>(defaults.degreesOfFreedom))
          .range(bem::from(1)),
      Row("Maximum Memory", Kind::Real,
          "a level that is foretold to take more, all processes together, is not "
          "computed; without it what the machine and its control groups have free")
          .unit("MiB")
          .range(bem::above(0)),
  };
}

RunLimits parseLimits(const Teuchos::ParameterList& list) {
  RunLimits limits{list.get<int>("Maximum Levels"),
                   list.get<int>("Maximum Degrees of Freedom"),
                   list.get<double>("Target Estimate"),
                   {},
                   {}};
  if (list.isParameter("Tolerance"))
    limits.tolerance = list.get<double>("Tolerance");
  if (list.isParameter("Maximum Memory"))
    limits.memory = list.get<double>("Maximum Memory");
  return limits;
}

bem::SchemaRows outputRows() {
  const OutputOptions defaults;
  return {
      Row("Fields", Kind::Flag,
          "write boundary.csv, the pictures' data, and solution.hdf, which restarts and "
          "epafi fields read")
          .standard(defaults.fields ? "true" : "false"),
      Row("Contact Samples per Element", Kind::Whole, "points in contact.csv")
          .unit("1")
          .standard(defaults.contactSamples)
          .range({1, 1000}),
      Row("Interior Points", Kind::Points, "points inside the body for interior.csv")
          .unit("length"),
  };
}

OutputOptions parseOutput(const Teuchos::ParameterList& list) {
  OutputOptions output;
  output.contactSamples = list.get<int>("Contact Samples per Element");
  output.fields = list.get<bool>("Fields");
  if (list.isParameter("Interior Points"))
    output.interiorPoints = pointsOf(list, "Interior Points");
  return output;
}

}  // namespace epafi::drivers
