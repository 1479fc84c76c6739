#include "drivers/output/FieldFiles.hpp"

#include "bem/fields/Interior.hpp"
#include "contact/problem/ContactFields.hpp"
#include "drivers/output/Csv.hpp"
#include "drivers/output/FieldGrid.hpp"

#include <cmath>

namespace epafi::drivers {

namespace {

/// √(½ Σ of the squared differences of the normal stresses + 3 σxy²)
double vonMises(const bem::InteriorValue& stress, const bem::Material& material) {
  const double zz =
      material.planeStress ? 0 : material.poissonsRatio * (stress.xx + stress.yy);
  const double a = stress.xx - stress.yy;
  const double b = stress.yy - zz;
  const double c = zz - stress.xx;
  return std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * stress.xy * stress.xy);
}

}  // namespace

std::string contactCsv(const contact::Solved& solved, int samples) {
  const contact::ContactFields fields(solved.problem, solved.space, solved.units,
                                      solved.state, solved.displacement);
  Csv csv({"boundary", "element", "x", "y", "lambda_n", "lambda_t", "u_n", "u_t", "gap",
           "bound", "contact", "friction"});
  for (const auto& element : fields.elements())
    for (int k = 0; k < samples; ++k) {
      const double t = -1 + (2.0 * k + 1) / samples;
      const contact::ContactPoint p = fields.at(element, t);
      csv.row({*element.boundary, std::to_string(element.element), exactly(p.place.x),
               exactly(p.place.y), exactly(p.pressure), exactly(p.shear),
               exactly(p.normal), exactly(p.tangential), exactly(p.gap), exactly(p.bound),
               p.closed ? "1" : "0", std::to_string(numberOf(p.friction))});
    }
  return csv.text();
}

std::string boundaryCsv(const contact::Solved& solved, const bem::Vector& density) {
  const bem::Mesh& mesh = solved.space.mesh();
  Csv csv({"x", "y", "ux", "uy", "tx", "ty", "boundary", "element", "degree"});
  for (int e = 0; e < mesh.size(); ++e) {
    const int intervals = 2 * (mesh[e].degree + 1);
    for (int k = 0; k <= intervals; ++k) {
      const double t = -1 + 2.0 * k / intervals;
      const bem::Vec2 x = mesh.physicalPoint(e, t);
      const bem::Vec2 u =
          solved.units.length * solved.space.displacementAt(solved.displacement, e, t);
      const bem::Vec2 traction =
          solved.units.stress * solved.space.densityAt(density, e, t);
      csv.row({exactly(x.x), exactly(x.y), exactly(u.x), exactly(u.y),
               exactly(traction.x), exactly(traction.y), mesh.boundary(e),
               std::to_string(e), std::to_string(mesh[e].degree)});
    }
  }
  return csv.text();
}

std::string interiorCsv(const contact::Solved& solved, const bem::Vector& density,
                        const bem::Material& material,
                        const std::vector<bem::Vec2>& points) {
  const bem::Lame lame(material);
  const bem::Outline& outline = solved.space.mesh().outline();
  Csv csv({"x", "y", "ux", "uy", "sxx", "syy", "sxy", "von_mises"});
  for (const bem::Vec2& point : points) {
    const bem::InteriorValue value = bem::evaluateInterior(
        solved.space, lame, solved.displacement, density, outline.scaled(point));
    const double stress = solved.units.stress;
    csv.row({exactly(point.x), exactly(point.y),
             exactly(solved.units.length * value.displacement.x),
             exactly(solved.units.length * value.displacement.y),
             exactly(stress * value.xx), exactly(stress * value.yy),
             exactly(stress * value.xy), exactly(stress * vonMises(value, material))});
  }
  return csv.text();
}

}  // namespace epafi::drivers
