#include "contact/law/FrictionLaw.hpp"

#include "contact/law/FrictionLaws.hpp"

#include <Teuchos_ParameterList.hpp>

namespace epafi::contact {

bem::Family<FrictionLawMember>& frictionLaws() {
  static bem::Family<FrictionLawMember> laws(
      "friction law", {
                          {"None", {}, {}},
                          lawOfFields<FrictionLaw, TrescaLaw>("Tresca"),
                          lawOfFields<FrictionLaw, CoulombLaw>("Coulomb"),
                          lawOfFields<FrictionLaw, CappedCoulombLaw>("Capped Coulomb"),
                          lawOfFields<FrictionLaw, TiedLaw>("Tied"),
                      });
  return laws;
}

bem::SchemaRows frictionRows() {
  bem::SchemaRows rows = lawRows(frictionLaws(), "friction law");
  bem::SchemaRow compliance =
      bem::Row("Compliance", bem::Kind::Expression, "length/stress",
               "of the surfaces to shear: slip is less by compliance times shear");
  compliance.only = frictionLaws().names();
  compliance.only.erase(compliance.only.begin());  // no friction, no shear
  append(rows, {compliance});
  return rows;
}

std::vector<bem::Function> PressureCoulombLaw::fields() {
  return {[](const bem::SurfacePoint& x) { return x.x; },
          [](const bem::SurfacePoint& x) { return x.y; },
          [](const bem::SurfacePoint& x) { return x.normal.x; },
          [](const bem::SurfacePoint& x) { return x.normal.y; }};
}

double PressureCoulombLaw::bound(double pressure, const Vector& fields) const {
  return pressure > 0
             ? pressure *
                   coefficient_({fields[0], fields[1], {fields[2], fields[3]}}, pressure)
             : 0;
}

double PressureCoulombLaw::slope(double pressure, const Vector& fields) const {
  const double h = 1e-3 * pressure;
  const auto difference = [&](double step) {
    return (bound(pressure + step, fields) - bound(pressure - step, fields)) / (2 * step);
  };
  const double slope = (4 * difference(h) - difference(2 * h)) / 3;
  const double mean = bound(pressure, fields) / pressure;
  if (slope < -1e-9 * mean)
    throw bem::InputError("at a pressure of ", pressure, ", (x, y) = (", fields[0], ", ",
                          fields[1], "), pressure times Coefficient = ", mean * pressure,
                          " decreases; it must not at any pressure: keep the pressure in "
                          "it below where that "
                          "begins, as in exp(-min(pressure, 100)/100)");
  return std::max(slope, 0.0);
}

double PointLaw::bound(double pressure) const {
  return factor_ *
         (law_ == nullptr
              ? bound_
              : law_->bound(stress_ * std::max(pressure, 0.0), fields_) / stress_);
}

double PointLaw::slope(double pressure) const {
  return law_ != nullptr && pressure > 0
             ? factor_ * law_->slope(stress_ * pressure, fields_)
             : 0;
}

double PointLaw::steepest() const {
  double largest = 0;
  const double first = bound(0);
  for (double pressure = 1e-18; pressure < 10 && followsPressure(); pressure *= 10)
    largest = std::max({largest, slope(pressure), (bound(pressure) - first) / pressure});
  return largest;
}

Friction makeFriction(const std::string& law, std::vector<bem::Function> fields) {
  return {makeLaw(frictionLaws(), "friction law", law, std::move(fields), {})};
}

Friction makePressureFriction(PressureCoefficient coefficient) {
  return {{std::make_shared<const PressureCoulombLaw>(std::move(coefficient)),
           PressureCoulombLaw::fields()}};
}

Friction parseFriction(const Teuchos::ParameterList& list, const FieldOf& field) {
  Friction friction{parseLaw(frictionLaws(), list.get<std::string>("Law"), list, field)};
  if (list.isParameter("Compliance"))
    friction.compliance = field("Compliance");
  return friction;
}

}  // namespace epafi::contact
