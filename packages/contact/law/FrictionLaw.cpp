#include "contact/law/FrictionLaw.hpp"

#include "bem/base/Error.hpp"

#include <algorithm>

namespace epafi::contact {

const std::vector<FrictionLaw>& frictionLaws() {
  static const std::vector<FrictionLaw> laws = {
      {"None", "", "frictionless", false, false,  //
       [](double, double) { return 0.0; }, [](double, double) { return 0.0; }},
      {"Tresca", "Threshold", "largest shear stress, independent of the pressure", false,
       true, [](double, double strength) { return strength; },
       [](double, double) { return 0.0; }},
      {"Coulomb", "Coefficient",
       "friction coefficient: shear up to coefficient times pressure", true, false,
       [](double pressure, double strength) {
         return strength * std::max(pressure, 0.0);
       },
       [](double pressure, double strength) { return pressure > 0 ? strength : 0.0; }},
  };
  return laws;
}

const FrictionLaw& frictionLaw(const std::string& name) {
  std::string known;
  for (const FrictionLaw& law : frictionLaws()) {
    if (law.name == name)
      return law;
    known += (known.empty() ? "'" : ", '") + std::string(law.name) + "'";
  }
  throw bem::InputError(bem::message("friction law '", name, "'; known laws: ", known));
}

}  // namespace epafi::contact
