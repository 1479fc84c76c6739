#include "contact/law/FrictionLaw.hpp"

#include "contact/law/Laws.hpp"

#include <Teuchos_ParameterList.hpp>

#include <algorithm>

namespace epafi::contact {

namespace {

using bem::Kind;
using Teuchos::ParameterList;

template <class Law>
FrictionLawMember member(const char* name) {
  return {name, Law::rows(),
          [](const ParameterList&) { return std::make_shared<const Law>(); }};
}

bool isField(const bem::SchemaRow& row) { return row.kind == Kind::Expression; }

}  // namespace

bem::Family<FrictionLawMember>& frictionLaws() {
  static bem::Family<FrictionLawMember> laws(
      "friction law", {
                          {"None", {}, {}},
                          member<TrescaLaw>("Tresca"),
                          member<CoulombLaw>("Coulomb"),
                          member<CappedCoulombLaw>("Capped Coulomb"),
                          member<TiedLaw>("Tied"),
                      });
  return laws;
}

bem::SchemaRows frictionRows() {
  bem::SchemaRows table = {bem::Row("Law", Kind::Text, "friction law")
                               .standard(frictionLaws().front().name)
                               .allowed(frictionLaws().names())};
  for (const FrictionLawMember& law : frictionLaws()) {
    bem::SchemaRows rows = law.rows;
    for (bem::SchemaRow& row : rows)
      row.only = {law.name};
    append(table, rows);
  }
  return table;
}

double PointLaw::bound(double pressure) const {
  return law_ == nullptr
             ? bound_
             : law_->bound(stress_ * std::max(pressure, 0.0), fields_) / stress_;
}

double PointLaw::slope(double pressure) const {
  return law_ != nullptr && pressure > 0 ? law_->slope(stress_ * pressure, fields_) : 0;
}

double PointLaw::steepest() const {
  double largest = 0;
  const double first = bound(0);
  for (double pressure = 1e-18; pressure < 10 && followsPressure(); pressure *= 10)
    largest = std::max({largest, slope(pressure), (bound(pressure) - first) / pressure});
  return largest;
}

Vector Friction::fieldsAt(bem::Vec2 place) const {
  Vector values;
  for (const bem::Function& field : fields)
    values.push_back(field(place));
  return values;
}

Friction makeFriction(const std::string& law, std::vector<bem::Function> fields) {
  const FrictionLawMember& entry = frictionLaws().at(law);
  const auto wanted = std::count_if(entry.rows.begin(), entry.rows.end(), isField);
  if (static_cast<std::size_t>(wanted) != fields.size() ||
      entry.rows.size() != fields.size())
    throw bem::InputError("friction law '", law, "' has ", wanted, " fields and ",
                          entry.rows.size() - static_cast<std::size_t>(wanted),
                          " other keys; ", fields.size(), " fields are given");
  return {entry.make ? entry.make(ParameterList()) : nullptr, std::move(fields)};
}

Friction parseFriction(const ParameterList& list,
                       const std::function<bem::Function(const std::string&)>& field) {
  const FrictionLawMember& entry = frictionLaws().at(list.get<std::string>("Law"));
  Friction friction;
  if (!entry.make)
    return friction;
  friction.law = entry.make(list);
  for (const bem::SchemaRow& row : entry.rows)
    if (isField(row))
      friction.fields.push_back(field(row.name()));
  return friction;
}

}  // namespace epafi::contact
