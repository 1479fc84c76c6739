// epafi with one more friction law, which scenes then name like any other.
#include "contact/law/FrictionLaw.hpp"
#include "drivers/Program.hpp"

#include <Teuchos_ParameterList.hpp>

#include <cmath>

namespace {

using epafi::bem::Kind;
using epafi::bem::Row;
using epafi::contact::Vector;

/// s = F p / (1 + (F p / C)^n)^(1/n): Coulomb's law that bends smoothly to a cap C.
class Shaw final : public epafi::contact::FrictionLaw {
 public:
  explicit Shaw(double exponent) : n_(exponent) {}

  double bound(double pressure, const Vector& fields) const override {
    const double coulomb = fields[0] * pressure;
    return coulomb / std::pow(1 + std::pow(coulomb / fields[1], n_), 1 / n_);
  }
  double slope(double pressure, const Vector& fields) const override {
    const double part = std::pow(fields[0] * pressure / fields[1], n_);
    return fields[0] / std::pow(1 + part, 1 + 1 / n_);
  }

 private:
  double n_;
};

}  // namespace

int main(int argc, char* argv[]) {
  epafi::contact::frictionLaws().add(
      {"Shaw",
       {Row("Coefficient", Kind::Expression, "friction at low pressure")
            .unit("1")
            .required(),
        Row("Cap", Kind::Expression, "shear at high pressure").unit("stress").required(),
        Row("Exponent", Kind::Real, "how sharply the one becomes the other")
            .unit("1")
            .standard("2")
            .range(epafi::bem::from(1))},
       [](const Teuchos::ParameterList& list) {
         return std::make_shared<const Shaw>(list.get<double>("Exponent"));
       }});
  return epafi::program(argc, argv);
}
