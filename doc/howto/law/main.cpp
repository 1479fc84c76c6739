// epafi with one more friction law and one more normal law, which scenes then name like any other.
#include "contact/law/FrictionLaw.hpp"
#include "contact/law/NormalLaw.hpp"
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

/// φ = L p/(p + P): a soft layer that closes by no more than L.
class Layer final : public epafi::contact::NormalLaw {
 public:
  double closing(double p, const Vector& fields) const override {
    return fields[0] * p / (p + fields[1]);
  }
  double slope(double p, const Vector& fields) const override {
    return fields[0] * fields[1] / ((p + fields[1]) * (p + fields[1]));
  }
  double energy(double p, const Vector& fields) const override {
    return fields[0] * fields[1] * (std::log1p(p / fields[1]) - p / (p + fields[1]));
  }
};

}  // namespace

int main(int argc, char* argv[]) {
  epafi::contact::frictionLaws().add(
      {"Shaw",
       {Row("Coefficient", Kind::Expression, "1", "friction at low pressure").required(),
        Row("Cap", Kind::Expression, "stress", "shear at high pressure").required(),
        Row("Exponent", Kind::Real, "1", epafi::bem::from(1),
            "how sharply the one becomes the other")
            .defaultValue("2")},
       [](const Teuchos::ParameterList& list) {
         return std::make_shared<const Shaw>(list.get<double>("Exponent"));
       }});
  epafi::contact::normalLaws().add(
      {"Layer",
       {Row("Length", Kind::Expression, "length", "closing at high pressure").required(),
        Row("Pressure", Kind::Expression, "stress", "that closes half of it").required()},
       [](const Teuchos::ParameterList&) { return std::make_shared<const Layer>(); }});
  return epafi::program(argc, argv);
}
