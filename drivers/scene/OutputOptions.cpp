#include "drivers/scene/OutputOptions.hpp"

#include "drivers/scene/GeometryReader.hpp"

#include <Teuchos_ParameterList.hpp>

namespace epafi::drivers {

using bem::Kind;
using bem::Row;

bem::SchemaRows outputRows() {
  const OutputOptions defaults;
  return {
      Row("Fields", Kind::Flag, "write boundary.csv and the pictures' data")
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
