#include "drivers/scene/BodyLoadsReader.hpp"

#include "bem/algebra/LuFactor.hpp"
#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Box.hpp"
#include "bem/base/Error.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "drivers/scene/Readers.hpp"
#include "drivers/scene/Revolution.hpp"

#include <algorithm>
#include <array>
#include <boost/math/special_functions/binomial.hpp>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace epafi::drivers {

namespace {

using bem::asVector;
using bem::Complex;
using bem::InputError;
using bem::Vec2;

constexpr int highest = 4;  ///< highest degree of the polynomial

/// Powers i, j of monomials xⁱ yʲ, around an axis of revolution of x²ⁱ yʲ.
std::vector<std::array<int, 2>> powersOf(bool isAxisymmetric) {
  std::vector<std::array<int, 2>> powers;
  const int step = isAxisymmetric ? 2 : 1;
  for (int i = 0; step * i <= highest; ++i)
    for (int j = 0; step * i + j <= highest; ++j)
      powers.push_back({i, j});
  return powers;
}

using Coefficients = std::map<std::pair<int, int>, Complex>;

double binomial(int n, int k) { return boost::math::binomial_coefficient<double>(n, k); }

/// Adds c xⁱ yʲ in powers of z and z̄, by x = (z + z̄)/2, y = (z - z̄)/(2i).
void addInPlane(int i, int j, double c, Vec2 size, Coefficients& all) {
  const Complex scaled =
      c / (std::pow(2 * size.x, i) * std::pow(Complex(0, 2 * size.y), j));
  for (int a = 0; a <= i; ++a)
    for (int b = 0; b <= j; ++b)
      all[{i - a + j - b, a + b}] +=
          scaled * (binomial(i, a) * binomial(j, b) * (b % 2 == 0 ? 1 : -1));
}

/// Least squares fit of the values by monomials in x and y, each scaled to [-1, 1]: on a
/// thin body monomials in z would be nearly linearly dependent.  Around an axis of revolution x² about
/// `middle` takes the place of x.
contact::BodyLoads::Terms fit(const std::vector<Complex>& points,
                              const std::vector<double>& values,
                              std::optional<double> middle) {
  const auto powers = powersOf(middle.has_value());
  const auto radial = [&](Complex z) {
    return middle ? z.real() * z.real() - *middle : z.real();
  };
  Vec2 size{0, 0};
  for (const Complex z : points)
    size = {std::max(size.x, std::abs(radial(z))), std::max(size.y, std::abs(z.imag()))};
  bem::Matrix rows(static_cast<bem::Index>(points.size()),
                   static_cast<bem::Index>(powers.size()));
  for (std::size_t k = 0; k < points.size(); ++k) {
    bem::Index column = 0;
    for (const auto& [i, j] : powers)
      rows(static_cast<bem::Index>(k), column++) =
          std::pow(radial(points[k]) / size.x, i) *
          std::pow(points[k].imag() / size.y, j);
  }
  const bem::LuFactor factor(bem::transposedProduct(rows, rows));
  bem::Vector c(powers.size(), 0.0);
  bem::Vector left = values;
  for (int round = 0; round < 2; ++round) {  // one step of iterative refinement
    bem::Vector more = transposedProduct(rows, left);
    factor.solve(more);
    bem::axpy(1, more, c);
    left = values;
    bem::axpy(-1, product(rows, c), left);
  }
  Coefficients all;
  for (std::size_t k = 0; k < powers.size(); ++k) {
    const auto [i, j] = powers[k];
    if (!middle)
      addInPlane(i, j, c[k], size, all);
    for (int a = 0; middle && a <= i; ++a)
      all[{2 * a, j}] += c[k] / (std::pow(size.x, i) * std::pow(size.y, j)) *
                         binomial(i, a) * std::pow(-*middle, i - a);
  }
  contact::BodyLoads::Terms terms;
  for (const auto& [powersOfBoth, value] : all)
    terms.push_back({powersOfBoth.first, powersOfBoth.second, value});
  return terms;
}

}  // namespace

bem::SchemaRows bodyLoadsRows() {
  using bem::Kind;
  using bem::Row;
  return {
      Row("Gravity X", Kind::Expression, "force / mass",
          "acceleration; the force per volume is Density times it; in t and constants; "
          "none of solids of revolution"),
      Row("Gravity Y", Kind::Expression, "force / mass",
          "acceleration along y, down is negative; in t and constants"),
      Row("Force X", Kind::Expression, "stress / length",
          "instead of Gravity X: the force per volume; of solids of revolution outwards"),
      Row("Force Y", Kind::Expression, "stress / length",
          "instead of Gravity Y: the force per volume along y"),
      Row("Spin", Kind::Expression, "radian / time",
          "angular velocity about Center; the force per volume is Density times its "
          "square times the way from there; in t and constants"),
      Row("Angular Acceleration", Kind::Expression, "radian / time^2",
          "the body's own about Center, counter-clockwise; not taken from Spin; "
          "in t and constants"),
      Row("Center", Kind::Reals, "length",
          "of Spin and Angular Acceleration; without it the origin; of solids of "
          "revolution "
          "the axis, which is not given"),
      Row("Temperature", Kind::Expression, "temperature",
          "difference from the stress-free state, a polynomial in x and y of degree at "
          "most 4 with coefficients in t, of solids of revolution even in x; of elastic "
          "bodies"),
  };
}

bem::SchemaRows thermalRows() {
  using bem::Kind;
  using bem::Row;
  return {
      Row("Temperature", Kind::Expression, "temperature",
          "held here: difference from the stress-free state; on one boundary at least"),
      Row("Heat Flux", Kind::Expression, "conductivity temperature / length",
          "instead of Temperature: heat into the body"),
  };
}

BodyLoadsReader::BodyLoadsReader(const Part& root, const std::string& body)
    : body_(root.sub("Bodies").sub(body)),
      thermal_(body_.sub("Thermal Conditions")),
      loads_(body_.sub("Body Loads")),
      own_(loads_.isGiven()),
      symmetry_(parseSymmetry(root.list->sublist("Geometry"))),
      isAxisymmetric_(parseRevolution(root.list->sublist("Geometry"))) {
  if (!own_)
    loads_ = root.sub("Body Loads");
}

double BodyLoadsReader::value(const char* key) const {
  return loads_.has(key) ? loads_.number(key) : 0;
}

double BodyLoadsReader::ofMaterial(const char* property, const std::string& why) const {
  const Part material = body_.sub("Material");
  if (!material.has(property))
    throw InputError(material.path(property), ": missing; ", why, " needs it");
  return material.list->get<double>(property);
}

BodyLoadsReader::Force BodyLoadsReader::forceAt(Vec2 origin) const {
  const auto along = [&](const char* weight, const char* force) {
    if (!loads_.has(weight))
      return value(force);
    if (loads_.has(force))
      throw InputError(loads_.path(force), ": give this or ", weight, ", not both");
    return ofMaterial("Density", loads_.path(weight)) * value(weight);
  };
  Force force{{along("Gravity X", "Force X"), along("Gravity Y", "Force Y")}, {}};
  if (loads_.has("Spin"))
    force.linear +=
        ofMaterial("Density", loads_.path("Spin")) * std::pow(value("Spin"), 2);
  if (loads_.has("Angular Acceleration"))
    force.linear -= ofMaterial("Density", loads_.path("Angular Acceleration")) *
                    Complex(0, value("Angular Acceleration"));
  const Vec2 center = loads_.has("Center") ? loads_.point("Center") : Vec2{};
  if (!isAxisymmetric_)
    force.uniform += force.linear * asComplex(origin - center);
  checkSymmetry(force, origin);
  return force;
}

// Checks the force at the origin of coordinates, which lies on the line of symmetry.
void BodyLoadsReader::checkSymmetry(const Force& force, Vec2 origin) const {
  constexpr double rounding = 1e-12;
  const Complex ofOrigin = isAxisymmetric_ ? 0 : force.linear * asComplex(origin);
  Vec2 uniform = asVector(force.uniform - ofOrigin);
  if (symmetry_ && (std::abs(symmetry_.across(uniform)) >
                        rounding * (std::abs(force.uniform) + std::abs(ofOrigin)) ||
                    force.linear.imag() != 0))
    throw InputError(
        loads_.place.path, ": of bodies that are symmetric about the line ",
        symmetry_.line(),
        " (Geometry->Symmetry) no force acts across it, Spin has its Center on "
        "it, and there is no Angular Acceleration");
}

// Fits at an 8 x 8 lattice in the bounding box, then tests the fit at a 9 x 9 lattice.
contact::BodyLoads::Terms BodyLoadsReader::temperature(
    const bem::Outline& outline) const {
  const bem::Function given = loads_.function("Temperature");
  bem::Box box;
  for (const bem::Edge& edge : outline.edges())
    for (const double t : {-1.0, -0.5, 0.0, 0.5, 1.0})
      box.add(edge.curve.point(t));
  const auto latticeOf = [&](int n, double shift) {
    std::vector<Complex> points;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        points.emplace_back(box.low.x + box.size().x * (i + shift) / n,
                            box.low.y + box.size().y * (j + shift) / n);
    return points;
  };
  const auto givenAt = [&](Complex y) {
    const bem::Vec2 x = outline.physical(asVector(y));
    return given({x.x, x.y, {}});
  };
  const std::vector<Complex> points = latticeOf(8, 0.5);
  std::vector<double> values;
  double largest = 0;
  for (const Complex y : points) {
    values.push_back(givenAt(y));
    largest = std::max(largest, std::abs(values.back()));
  }
  std::optional<double> middle;
  if (isAxisymmetric_)
    middle = 0.5 * (box.low.x * box.low.x + box.high.x * box.high.x);
  contact::BodyLoads::Terms terms = fit(points, values, middle);
  const contact::ParticularSolution fitted({{}, {}, terms, 0, 0, isAxisymmetric_},
                                           bem::Lame(bem::Material{}));
  double deviation = 0;
  for (const Complex y : latticeOf(9, 0.4))
    deviation =
        std::max(deviation, std::abs(givenAt(y) - fitted.temperature(asVector(y))));
  // in powers of z cancellation leaves eight digits on a body of aspect ratio 1 : 100
  if (deviation > 1e-7 * largest)
    throw InputError(loads_.path("Temperature"),
                     ": is not a polynomial in x and y of degree at most ", highest,
                     isAxisymmetric_
                         ? ", even in x: around an axis of revolution an odd power "
                           "of the radius x is no smooth temperature"
                         : "",
                     "; the nearest one is off by up to ", deviation);
  return terms;
}

contact::BodyLoadSolution BodyLoadsReader::inside(const bem::Outline& outline,
                                                  const bem::Material& material,
                                                  double stress) const {
  const bool conducts = thermal_.isGiven();
  if (!loads_.isGiven() && !conducts)
    return nullptr;
  const Force force = loads_.isGiven() ? forceAt(outline.scaling().origin) : Force{};
  const double length = outline.scaling().length;
  contact::BodyLoads loads;
  loads.isAxisymmetric = isAxisymmetric_;
  loads.uniform = force.uniform * (length / stress);
  loads.linear = force.linear * (length * length / stress);
  const bool isWarm = loads_.has("Temperature");
  if (isWarm && conducts)
    throw InputError(loads_.path("Temperature"), ": ", thermal_.place.path,
                     " have it conducted; give one of them");
  if (isWarm)
    loads.temperature = temperature(outline);
  if (isWarm || conducts) {
    const double alpha = ofMaterial(
        "Thermal Expansion", conducts ? thermal_.place.path : loads_.path("Temperature"));
    loads.expansion = material.planeStress ? alpha : (1 + material.poissonsRatio) * alpha;
    loads.across = material.planeStress || isAxisymmetric_
                       ? 0
                       : -alpha * material.youngsModulus / stress;
  }
  return std::make_shared<const contact::ParticularSolution>(loads,
                                                             bem::Lame(material, stress));
}

std::shared_ptr<const contact::ThermalConditions> BodyLoadsReader::heat(
    const bem::Outline& outline) const {
  if (!thermal_.isGiven())
    return nullptr;
  contact::ThermalConditions heat;
  heat.path = thermal_.place.path;
  heat.conductivity = body_.list->sublist("Material").get<double>("Conductivity");
  for (const auto& item : *thermal_.list) {
    Part part = thermal_.sub(item.first);
    checkNamed(item.first, part.place.path, outline);
    part.names.onBoundary = true;
    const bool isHeld = part.has("Temperature");
    if (isHeld == part.has("Heat Flux"))
      throw InputError(part.place.path, ": has ", isHeld ? "both" : "none",
                       " of Temperature and Heat Flux; a boundary has one of them");
    (isHeld ? heat.temperatures : heat.flows)[item.first] =
        part.function(isHeld ? "Temperature" : "Heat Flux");
  }
  if (heat.temperatures.empty())
    throw InputError(
        thermal_.place.path,
        ": no boundary has a Temperature; without one that is held heat flows "
        "alone do not say how warm the body is");
  return std::make_shared<const contact::ThermalConditions>(std::move(heat));
}

bool BodyLoadsReader::actsOnRigid() const {
  if (own_ && loads_.has("Temperature"))
    throw InputError(
        loads_.path("Temperature"),
        ": the body is rigid (Material->Rigid = true), heat does nothing to it");
  return loads_.isGiven() &&
         (own_ || body_.list->sublist("Material").isParameter("Density"));
}

// The body force is in balance with the tractions of its particular solution.
contact::Resultant BodyLoadsReader::resultant(const bem::Outline& outline,
                                              Vec2 pole) const {
  const double length = outline.scaling().length;
  const Force force = forceAt(outline.scaling().origin);
  const contact::ParticularSolution solution(
      {force.uniform * length, force.linear * length * length, {}, 0, 0, isAxisymmetric_},
      bem::Lame(bem::Material{}));
  constexpr double turn = 6.2831853071795865;
  const bem::Rule& rule = bem::gaussLegendre(bem::largestGaussOrder);
  contact::Resultant sum;
  for (const bem::Edge& edge : outline.edges())
    for (int q = 0; q < rule.size(); ++q) {
      const Vec2 y = edge.curve.point(rule.points[q]);
      const double around = isAxisymmetric_ ? turn * length * y.x : 1;
      const Vec2 b = -0.5 * length * around * edge.curve.length() * rule.weights[q] *
                     solution.stress(y).on(edge.curve.normal(rule.points[q]));
      sum.x += b.x;
      sum.y += b.y;
      sum.moment += cross(outline.physical(y) - pole, b);
    }
  return isAxisymmetric_ ? contact::Resultant{0, sum.y, 0} : sum;
}

}  // namespace epafi::drivers
