#include "drivers/output/PathContact.hpp"

#include "bem/space/LocalField.hpp"
#include "drivers/output/Csv.hpp"
#include "drivers/output/FieldFiles.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::drivers {

double PathContact::stressAlong(const contact::Solved& solved, int element, double t,
                                double pressure) const {
  const bem::Element& on = solved.space.mesh()[element];
  const bem::LocalField field = bem::localField(
      solved.space, solved.displacement,
      bem::Vector(static_cast<std::size_t>(solved.space.densities())), element);
  const bem::Complex slope = bem::evaluate(field.slope, on.degree - 1, t);
  const double strain = dot({slope.real(), slope.imag()}, on.curve.tangent(t));
  const bem::Material& material = scene_->bodies.front().material;
  const double nu = material.poissonsRatio;
  const double e = material.youngsModulus;
  return material.planeStress ? e * strain - nu * pressure
                              : e / (1 - nu * nu) * strain - nu / (1 - nu) * pressure;
}

std::string PathContact::next(const SolvedLevel& level) {
  const contact::Solved& solved = level.bodies.front();
  const PathStep& step = *level.path->steps.back();
  const bool isFirst = traces_.empty();
  const contact::MultiplierSpace& multiplier = solved.problem.multiplier();
  traces_.resize(multiplier.elements().size() *
                 static_cast<std::size_t>(scene_->output.contactSamples));
  const bem::Vector density =
      contact::frictionWorkDensity(solved.space.mesh(), multiplier, step.frictionWork);
  auto trace = traces_.begin();
  return contactCsv(
      *scene_, level.bodies,
      {{"slip", "work", "slip_amplitude", "stress_t", "ruiz_1", "ruiz_2"},
       [&](const contact::ContactFields::Element& element, double t,
           const contact::ContactPoint& point) {
         Trace& here = *trace++;
         const double stress = stressAlong(solved, element.element, t, point.pressure);
         if (isFirst)
           here.first = here.least = here.most = point.tangential;
         here.least = std::min(here.least, point.tangential);
         here.most = std::max(here.most, point.tangential);
         here.shear = std::max(here.shear, std::abs(point.shear));
         here.tension = std::max(here.tension, stress);
         const double amplitude = (here.most - here.least) / 2;
         const double work = solved.units.stress * solved.units.length *
                             multiplier.at(density, element, t).tangential;
         return std::vector<std::string>{exactly(point.tangential - here.first),
                                         exactly(work),
                                         exactly(amplitude),
                                         exactly(stress),
                                         exactly(here.shear * amplitude),
                                         exactly(here.tension * here.shear * amplitude)};
       }});
}

}  // namespace epafi::drivers
