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

Friction parseFriction(const Teuchos::ParameterList& list, const FieldOf& field) {
  Friction friction{parseLaw(frictionLaws(), list.get<std::string>("Law"), list, field)};
  if (list.isParameter("Compliance"))
    friction.compliance = field("Compliance");
  return friction;
}

}  // namespace epafi::contact
