#include "drivers/output/ContactTable.hpp"

#include "bem/space/LocalField.hpp"
#include "contact/path/PathMemory.hpp"
#include "contact/results/Resolution.hpp"
#include "drivers/output/BoundaryLines.hpp"
#include "drivers/output/Inside.hpp"
#include "drivers/output/SideStarts.hpp"
#include "drivers/output/Table.hpp"

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

Cells cellsOf(const ContactRow& row, const std::optional<ContactHistory>& history) {
  const ContactPoint& p = row.point;
  Cells cells = {
      {"boundary", row.boundary,
       "the boundary, with several bodies body:boundary; the element's number in the "
       "mesh"},
      {"element", row.element},
      {"x", p.place.x, "the point", "length"},
      {"y", p.place.y},
      {"lambda_n", p.pressure,
       "pressure along d and shear along t, λ = -σ n = `lambda_n` d + `lambda_t` t; d is "
       "the "
       "[direction of contact](theory/contact.md#directions), before obstacles given by "
       "`Gap` and in bonds the outward normal n; t is d turned counter-clockwise. The "
       "[coefficients](theory/multipliers.md) satisfy pressure >= 0 and shear within "
       "`bound`; between their points the polynomial may exceed these limits a little "
       "where the state changes",
       "stress"},
      {"lambda_t", p.shear},
      {"u_n", p.normal,
       "displacement along d and t, between bodies the relative displacement; `u_n` "
       "without "
       "what arcs that turn about their own centres would add",
       "length"},
      {"u_t", p.tangential},
      {"gap", p.gap, "gap along d in the undeformed state", "length"},
      {"bound", p.bound,
       "the largest shear that the friction law allows there at the pressure `lambda_n`; "
       "`inf` where the law is Tied",
       "stress"},
      {"contact", p.closed, "0 open, 1 closed"},
      {"friction", numberOf(p.friction),
       "0 none, 1 stick, 2 slip; under Tresca also where open"},
      {"body", row.body,
       "the body; the name under `Contacts`, or of the boundary if the opposite side is "
       "an "
       "obstacle"},
      {"contact_name", row.contact},
      {"s", row.s, "arc length from the side's start, along the outline", "length"}};
  if (history) {
    const ContactHistory& h = *history;
    append(
        cells,
        {{"slip", h.slip,
          "with a History ([load paths](theory/paths.md)): sliding since the end of the "
          "first step, a prescribed sliding of the opposite side included",
          "length"},
         {"work", h.work, "likewise: friction's work so far per unit of length",
          "stress length"},
         {"slip_amplitude", h.amplitude, "likewise: half the range of `slip` so far",
          "length"},
         {"stress_t", h.along,
          "likewise: stress along the surface, tension positive, of the strain along it "
          "and "
          "the stress -`lambda_n` across it ([fretting](theory/paths.md#fretting)); "
          "where "
          "`Rigid Motions->Fix` holds a body by a uniform traction, ν/(1-ν) times its "
          "component along n is missing (ν times in plane stress)",
          "stress"},
         {"ruiz_1", h.shear * h.amplitude, "likewise: Ruiz' fretting parameters",
          "stress length, stress² length"},
         {"ruiz_2", h.tension * h.shear * h.amplitude},
         {"worn_depth", p.worn,
          "likewise: what has worn off so far ([surfaces](theory/surfaces.md), Wear); 0 "
          "without it",
          "length"},
         {"slip_distance", p.distance,
          "likewise: how far the sides have slid so far while closed, forth and back, "
          "`Cycle "
          "Jump` times in a step",
          "length"}});
    if (h.around)
      cells.push_back(
          {hoop, *h.around,
           "likewise, of [solids of revolution](tutorial.md#revolution): stress "
           "around the axis, at the surface",
           "stress"});
  }
  append(
      cells,
      {{"normal_closing", p.closing,
        "distance by which the surfaces close under the pressure "
        "([surfaces](theory/surfaces.md)); 0 without a normal law",
        "length"},
       {"pressure", row.shown.normal,
        "λ without its jumps at nodes, which have no effect in the discrete equations; "
        "where a state changes they are closer to the exact stress than `lambda_n` and "
        "`lambda_t` ([multipliers](theory/multipliers.md), What is shown)",
        "stress"},
       {"shear", row.shown.tangential},
       {"pressure_error", row.doubt.normal,
        "by how much `lambda_n` and `lambda_t` may be wrong on the element, the sum of "
        "the "
        "sizes of the two highest Legendre coefficients (degree 1: of the highest). "
        "Beside "
        "singular points one to two times the error, elsewhere more than it",
        "stress"},
       {"shear_error", row.doubt.tangential},
       {"d_x", p.direction.unit.x, "the direction d", "1"},
       {"d_y", p.direction.unit.y}});
  return cells;
}

ContactHistory ContactTable::historyAt(const contact::Solved& solved,
                                       const bem::Material& material,
                                       const bem::Vector& work, const Element& element,
                                       double t, const ContactPoint& p) {
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
  ContactHistory history{slip - here.first,
                         solved.units.stress * solved.units.length *
                             solved.problem.multiplier().at(work, element, t).tangential,
                         (here.most - here.least) / 2,
                         stress,
                         here.shear,
                         here.tension};
  if (solved.units.isAxisymmetric)
    history.around = around;
  return history;
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
        const std::string& name = element.condition->name;
        ContactRow row{
            scene.boundaryName({false, b, *element.boundary}),
            scene.bodies[b].name,
            name.empty() ? *element.boundary : name,
            element.element,
            solved.units.length * (start + mesh[element.element].half * (1 + t)),
            fields.at(element, t),
            fields.inUnits(continuous, element, t),
            doubt};
        std::optional<ContactHistory> history;
        if (scene.history)
          history =
              historyAt(solved, scene.bodies[b].material, work, element, t, row.point);
        addRow(cellsOf(row, history), csv);
      }
    }
  }
  return csv;
}

}  // namespace epafi::drivers
