#include "contact/law/NormalLaw.hpp"

#include <Teuchos_ParameterList.hpp>

#include <boost/math/special_functions/log1p.hpp>
#include <cmath>
#include <limits>

namespace epafi::contact {

namespace {

using bem::Kind;
using bem::Row;

/// φ = c p, a compliant layer.
class LinearLaw final : public NormalLaw {
 public:
  static bem::SchemaRows rows() {
    return {Row("Compliance", Kind::Expression, "length/stress",
                "closing = compliance times pressure")
                .required()};
  }

  double closing(double p, const Vector& fields) const override { return fields[0] * p; }
  double slope(double /*p*/, const Vector& fields) const override { return fields[0]; }
  double energy(double p, const Vector& fields) const override {
    return 0.5 * fields[0] * p * p;
  }
  bool isLinear() const override { return true; }
};

bem::SchemaRows lengthAndPressure() {
  return {Row("Length", Kind::Expression, "length", "unit of the closing").required(),
          Row("Pressure", Kind::Expression, "stress", "unit of the pressure").required()};
}

/// φ = L (p/P)^e
class PowerLaw final : public NormalLaw {
 public:
  static bem::SchemaRows rows() {
    bem::SchemaRows rows = lengthAndPressure();
    rows.push_back(Row("Exponent", Kind::Real, "1", {0.1, 10, false, false},
                       "e: closing = Length (pressure/Pressure)^e")
                       .required());
    return rows;
  }

  explicit PowerLaw(double exponent) : exponent_(exponent) {}

  double closing(double p, const Vector& fields) const override {
    return fields[0] * std::pow(p / fields[1], exponent_);
  }
  double slope(double p, const Vector& fields) const override {
    return exponent_ * fields[0] / fields[1] * std::pow(p / fields[1], exponent_ - 1);
  }
  double energy(double p, const Vector& fields) const override {
    return exponent_ / (exponent_ + 1) * p * closing(p, fields);
  }

 private:
  double exponent_;
};

/// φ = L ln(1 + p/P), rough surfaces.
class ExponentialLaw final : public NormalLaw {
 public:
  static bem::SchemaRows rows() { return lengthAndPressure(); }

  double closing(double p, const Vector& fields) const override {
    return fields[0] * std::log1p(p / fields[1]);
  }
  double slope(double p, const Vector& fields) const override {
    return fields[0] / (fields[1] + p);
  }
  double energy(double p, const Vector& fields) const override {
    return -fields[0] * fields[1] * boost::math::log1pmx(p / fields[1]);
  }
};

}  // namespace

bem::Family<NormalLawMember>& normalLaws() {
  static bem::Family<NormalLawMember> laws(
      "normal law",
      {
          {"Rigid", {}, {}},
          lawOfFields<NormalLaw, LinearLaw>("Linear"),
          {"Power", PowerLaw::rows(),
           [](const Teuchos::ParameterList& list) {
             return std::make_shared<const PowerLaw>(list.get<double>("Exponent"));
           }},
          lawOfFields<NormalLaw, ExponentialLaw>("Exponential"),
      });
  return laws;
}

bem::SchemaRows normalRows() { return lawRows(normalLaws(), "normal law"); }

double PointClosing::closing(double pressure) const {
  if (pressure < 0)
    return law_->isLinear() ? slope(0) * pressure : 0;
  return law_->closing(units_.stress * pressure, fields_) / units_.length;
}

double PointClosing::slope(double pressure) const {
  return law_->slope(units_.stress * std::max(pressure, 0.0), fields_) * units_.stress /
         units_.length;
}

double PointClosing::energy(double pressure) const {
  return law_->energy(units_.stress * std::max(pressure, 0.0), fields_) /
         (units_.stress * units_.length);
}

// Newton's method in an interval that shrinks to the root.
double PointClosing::resolvent(double c, double z) const {
  constexpr int most = 200;
  constexpr double same = 4 * std::numeric_limits<double>::epsilon();
  double low = 0;
  double high = z;
  double p = z;
  for (int k = 0; k < most && high > 0; ++k) {
    const double rest = p + c * closing(p) - z;
    (rest < 0 ? low : high) = p;
    const double next = p - rest / (1 + c * slope(p));
    if (rest == 0 || std::abs(next - p) <= same * p)
      return p;
    // a root may be smaller by orders of magnitude
    constexpr double least = 1e-3;
    p = next > low && next < high ? next : low > 0 ? std::sqrt(low * high) : least * high;
  }
  return std::max(p, 0.0);
}

Normal makeNormal(const std::string& law, std::vector<bem::Function> fields) {
  return {makeLaw(normalLaws(), "normal law", law, std::move(fields), {})};
}

Normal parseNormal(const Teuchos::ParameterList& list, const FieldOf& field) {
  return {parseLaw(normalLaws(), list.get<std::string>("Law"), list, field)};
}

}  // namespace epafi::contact
