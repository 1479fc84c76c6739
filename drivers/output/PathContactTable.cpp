#include "drivers/output/PathContactTable.hpp"

#include "bem/space/LocalField.hpp"
#include "drivers/output/ContactTable.hpp"
#include "drivers/output/Csv.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::drivers {

namespace {

double stressAlong(const contact::Solved& solved, const bem::Material& material,
                   int element, double t, double pressure) {
  const bem::Element& on = solved.space.mesh()[element];
  const bem::LocalField field = bem::localField(
      solved.space, solved.displacement,
      bem::Vector(static_cast<std::size_t>(solved.space.densities())), element);
  const bem::Complex slope = bem::evaluate(field.slope, on.degree - 1, t);
  const double strain = dot({slope.real(), slope.imag()}, on.curve.tangent(t));
  const double nu = material.poissonsRatio;
  const double e = material.youngsModulus;
  double ofInside = 0;
  if (const contact::BodyLoadSolution& inside = solved.conditions.inside) {
    const bem::Vec2 along = on.curve.tangent(t);
    const auto stress = inside->stress(solved.space.mesh().scaledPoint(element, t));
    ofInside = solved.units.stress * dot(stress.on(along), along);
    pressure +=
        solved.units.stress * dot(stress.on(on.curve.normal(t)), on.curve.normal(t));
  }
  return ofInside + (material.planeStress
                         ? e * strain - nu * pressure
                         : e / (1 - nu * nu) * strain - nu / (1 - nu) * pressure);
}

}  // namespace

std::string PathContact::next(const SolvedLevel& level) {
  const PathStep& step = level.path->last();
  const bool isFirst = traces_.empty();
  std::vector<bem::Vector> densities;
  std::size_t elements = 0;
  for (std::size_t b = 0; b < level.bodies.size(); ++b) {
    const contact::MultiplierSpace& multiplier = level.bodies[b].problem.multiplier();
    densities.push_back(contact::frictionWorkDensity(level.bodies[b].space.mesh(),
                                                     multiplier, step.frictionWork[b]));
    elements += multiplier.elements().size();
  }
  traces_.resize(elements * static_cast<std::size_t>(scene_->output.contactSamples));
  auto trace = traces_.begin();
  return contactCsv(
      *scene_, level.bodies,
      {{"slip", "work", "slip_amplitude", "stress_t", "ruiz_1", "ruiz_2", "worn_depth",
        "slip_distance"},
       [&](std::size_t b, const contact::ContactFields::Element& element, double t,
           const contact::ContactPoint& point) {
         Trace& here = *trace++;
         const contact::Solved& solved = level.bodies[b];
         const double stress = stressAlong(solved, scene_->bodies[b].material,
                                           element.element, t, point.pressure);
         const double slip = point.tangential - point.sliding;
         if (isFirst)
           here.first = here.least = here.most = slip;
         here.least = std::min(here.least, slip);
         here.most = std::max(here.most, slip);
         here.shear = std::max(here.shear, std::abs(point.shear));
         here.tension = std::max(here.tension, stress);
         const double amplitude = (here.most - here.least) / 2;
         const double work =
             solved.units.stress * solved.units.length *
             solved.problem.multiplier().at(densities[b], element, t).tangential;
         return std::vector<std::string>{exactly(slip - here.first),
                                         exactly(work),
                                         exactly(amplitude),
                                         exactly(stress),
                                         exactly(here.shear * amplitude),
                                         exactly(here.tension * here.shear * amplitude),
                                         exactly(point.worn),
                                         exactly(point.distance)};
       }});
}

}  // namespace epafi::drivers
