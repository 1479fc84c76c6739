#include "drivers/output/ContactTable.hpp"

#include "bem/space/LocalField.hpp"
#include "contact/path/PathMemory.hpp"
#include "contact/results/Resolution.hpp"
#include "drivers/output/BoundaryLines.hpp"
#include "drivers/output/Csv.hpp"
#include "drivers/output/Inside.hpp"
#include "drivers/output/SideStarts.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::drivers {

namespace {

using contact::ContactPoint;
using Element = contact::ContactFields::Element;

/// Normal stress along the surface, and around an axis of revolution.
struct SurfaceStress {
  double along;
  double around;
};

SurfaceStress stressAt(const contact::Solved& solved, const bem::Material& material,
                       int element, double t, double pressure) {
  const bem::Element& on = solved.space.mesh()[element];
  const bem::LocalField field = bem::localField(
      solved.space, solved.displacement,
      bem::Vector(static_cast<std::size_t>(solved.space.densities())), element);
  const bem::Complex slope = bem::evaluate(field.slope, on.degree - 1, t);
  const double nu = material.poissonsRatio;
  const double strain = dot({slope.real(), slope.imag()}, on.curve.tangent(t));
  double around = 0;
  if (solved.units.isAxisymmetric) {
    const double radius = solved.space.mesh().scaledPoint(element, t).x;
    around =
        radius > 0 ? bem::evaluate(field.value, on.degree, t).real() / radius : strain;
  }
  const double e = material.youngsModulus;
  SurfaceStress ofInside{};
  if (const contact::BodyLoadSolution& inside = solved.conditions.inside) {
    const bem::Vec2 along = on.curve.tangent(t);
    const auto stress = inside->on(solved.space.mesh(), element, t).stress;
    ofInside = {solved.units.stress * dot(stress.on(along), along),
                solved.units.stress * stress.hoop};
    pressure +=
        solved.units.stress * dot(stress.on(on.curve.normal(t)), on.curve.normal(t));
  }
  if (material.planeStress)
    return {ofInside.along + e * strain - nu * pressure, 0};
  const double stiffness = e / (1 - nu * nu);
  const double across = nu / (1 - nu) * pressure;
  return {ofInside.along + stiffness * (strain + nu * around) - across,
          ofInside.around + stiffness * (around + nu * strain) - across};
}

/// Of each element of a mesh the contact that it is in, or none.
std::vector<const contact::Conditions::Contact*> contactsOf(
    const contact::ContactFields& fields, const bem::Mesh& mesh) {
  std::vector<const contact::Conditions::Contact*> on(bem::at(mesh.size()));
  for (const Element& element : fields.elements())
    on[element.element] = element.condition;
  return on;
}

}  // namespace

CsvRow ContactTable::pathCells(const contact::Solved& solved,
                               const bem::Material& material, const bem::Vector& work,
                               const Element& element, double t, const ContactPoint& p) {
  const auto [stress, around] =
      stressAt(solved, material, element.element, t, p.pressure);
  const double slip = p.tangential - p.sliding;
  if (point_ == traces_.size())
    traces_.push_back({slip, slip, slip});
  Trace& here = traces_[point_++];
  here.least = std::min(here.least, slip);
  here.most = std::max(here.most, slip);
  here.shear = std::max(here.shear, std::abs(p.shear));
  here.tension = std::max(here.tension, stress);
  const double amplitude = (here.most - here.least) / 2;
  CsvRow row = {
      {"slip", exactly(slip - here.first)},
      {"work", exactly(solved.units.stress * solved.units.length *
                       solved.problem.multiplier().at(work, element, t).tangential)},
      {"slip_amplitude", exactly(amplitude)},
      {"stress_t", exactly(stress)},
      {"ruiz_1", exactly(here.shear * amplitude)},
      {"ruiz_2", exactly(here.tension * here.shear * amplitude)},
      {"worn_depth", exactly(p.worn)},
      {"slip_distance", exactly(p.distance)}};
  if (solved.units.isAxisymmetric)
    row.emplace_back(hoop, exactly(around));
  return row;
}

std::string ContactTable::next(const SolvedStep& step) {
  const Scene& scene = step.spaces.scene();
  const int samples = scene.output.contactSamples;
  std::string csv;
  point_ = 0;
  bem::Vector work;
  if (scene.history)
    work = contact::frictionWorkDensity(step.system->multiplier(), step.frictionWork);
  for (std::size_t b = 0; b < step.bodies.size(); ++b) {
    const contact::Solved& solved = step.bodies[b];
    const bem::Mesh& mesh = solved.space.mesh();
    const contact::ContactFields fields(solved);
    const bem::Vector continuous = fields.continuous();
    const bem::Vector starts = startsAlong(mesh, contactsOf(fields, mesh));
    for (const Element& element : fields.elements()) {
      const double start = starts[element.element];
      const auto doubt = contact::resolutionOf(fields, element).error;
      for (int k = 0; k < samples; ++k) {
        const double t = -1 + (2.0 * k + 1) / samples;
        const ContactPoint p = fields.at(element, t);
        const std::string& name = element.condition->name;
        CsvRow row = {{"boundary", scene.boundaryName({false, b, *element.boundary})},
                      {"element", number(element.element)},
                      {"x", exactly(p.place.x)},
                      {"y", exactly(p.place.y)},
                      {"lambda_n", exactly(p.pressure)},
                      {"lambda_t", exactly(p.shear)},
                      {"u_n", exactly(p.normal)},
                      {"u_t", exactly(p.tangential)},
                      {"gap", exactly(p.gap)},
                      {"bound", exactly(p.bound)},
                      {"contact", number(p.closed)},
                      {"friction", number(numberOf(p.friction))},
                      {"body", scene.bodies[b].name},
                      {"contact_name", name.empty() ? *element.boundary : name},
                      {"s", exactly(solved.units.length *
                                    (start + mesh[element.element].half * (1 + t)))}};
        if (scene.history)
          append(row, pathCells(solved, scene.bodies[b].material, work, element, t, p));
        const auto stress = fields.inUnits(continuous, element, t);
        append(row, {{"normal_closing", exactly(p.closing)},
                     {"pressure", exactly(stress.normal)},
                     {"shear", exactly(stress.tangential)},
                     {"pressure_error", exactly(doubt.normal)},
                     {"shear_error", exactly(doubt.tangential)},
                     {"d_x", exactly(p.direction.unit.x)},
                     {"d_y", exactly(p.direction.unit.y)}});
        addRow(row, csv);
      }
    }
  }
  return csv;
}

}  // namespace epafi::drivers
