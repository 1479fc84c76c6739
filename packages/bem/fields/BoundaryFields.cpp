#include "bem/fields/BoundaryFields.hpp"

#include "bem/algebra/Products.hpp"
#include "bem/base/Parallel.hpp"
#include "bem/quadrature/Gauss.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace epafi::bem {

namespace {

/// Gauss points on an interval beyond the degree, for 2e-6 in the integrals of squares.
constexpr int smoothPoints = 6;

/// So many runs of elements cost what the expansions of a group do.
constexpr int smallestGroup = 16;

/// Gauss points on a source of a degree: its density has one less.
int pointsOn(int smoothOrder, int degree) { return smoothOrder + degree / 2; }

/// Gauss points on a target for the sum of what so many points on it resolve times such a sum: twice
/// as many, in whole packs.
int pointsOfTargets(int smoothOrder) {
  return (2 * smoothOrder + lanes - 1) / lanes * lanes;
}

/// At points of an element, the last one again up to a whole pack.
template <class Points, class Function>
std::vector<ComplexLanes> packed(const Points& points, const Function& function) {
  std::vector<ComplexLanes> packs((points.size() + lanes - 1) / lanes);
  for (std::size_t k = 0; k < packs.size() * lanes; ++k)
    packs[k / lanes].set(asInt(static_cast<Index>(k % lanes)),
                         asComplex(function(points[std::min(k, points.size() - 1)])));
  return packs;
}

/// Adds what groups do at a point of all states: x and y of both equations.
void addGroups(const std::vector<const SourceGroups::Group*>& groups, const Lame& lame,
               Complex x, Complex normal, Index row, Matrix& to) {
  std::vector<FieldSums> sums(at(to.columns() / 4));
  for (const SourceGroups::Group* group : groups)
    SourceGroups::addAt(*group, x, sums);
  for (Index j = 0; j < to.columns(); j += 4) {
    const Complex force = traction(lame, normal, sums[at(j / 4)]);
    const Complex slope = mismatchSlope(lame, normal, sums[at(j / 4)]);
    to(row, j) += force.real();
    to(row, j + 1) += force.imag();
    to(row, j + 2) += slope.real();
    to(row, j + 3) += slope.imag();
  }
}

}  // namespace

struct BoundaryFields::Sources {
  struct Far {
    std::vector<FarSource> elements{};
    std::vector<const SourceGroups::Group*> groups{};
  };
  std::vector<int> near{};
  std::map<int, Far> far{};  ///< by Gauss points on the target element
};

BoundaryFields::BoundaryFields(const Space& space, const Lame& lame,
                               const std::vector<BoundaryState>& states)
    : sources_{space.mesh().withDegreesOfDensities(), {}, {0}, {}},
      runs_(sources_.mesh),
      space_(space),
      lame_(lame),
      states_(states.size()) {
  for (const BoundaryState& state : states) {
    displacements_.push_back(space.withoutRotation(state.displacement));
    densities_.push_back(state.density);
  }
  if (mesh().outline().isAxisymmetric()) {
    std::vector<LocalField> fields;
    for (int e = 0; e < mesh().size(); ++e)
      for (const LocalField& field : fieldsOf(e))
        fields.push_back(field);
    rings_ = std::make_unique<const RingFields>(mesh(), lame_, fields, states_);
    return;
  }
  setSources();
  const auto densities = [this](int f, const Rule& rule, std::vector<Complex>& g) {
    const Element& source = mesh()[f];
    const std::vector<LocalField> fields = fieldsOf(f);
    auto next = g.begin();
    for (const double t : rule.points)
      for (const LocalField& field : fields) {
        *next++ = evaluate(field.density, source.densities - 1, t);
        *next++ = evaluate(field.slope, source.degree - 1, t);
      }
  };
  groups_ =
      std::make_unique<const SourceGroups>(runs_, 2 * states_, densities, smallestGroup);
}

void BoundaryFields::setSources() {
  int largest = 0;
  for (const Element& element : mesh().elements()) {
    largest = std::max(largest, element.degree);
    sources_.firsts.push_back(sources_.firsts.back() +
                              std::max(element.degree, element.densities));
  }
  sources_.coefficients =
      Matrix::unset(sources_.firsts.back(), 4 * static_cast<Index>(states_));
  sources_.places.resize(bem::at(pointsOn(smoothOrderOfCircles, largest)) + 1);
  for (std::vector<Vec2>& places : sources_.places)
    places.resize(bem::at(mesh().size()) *
                  static_cast<std::size_t>(&places - sources_.places.data()));
  constexpr double ofField = 300;  // ns
  const Index size = mesh().size();
  parallelFor(
      {size, ofField * static_cast<double>(size) * static_cast<double>(states_), 16},
      [&](Index f) {
        const std::vector<LocalField> fields = fieldsOf(asInt(f));
        Index column = 0;
        for (const LocalField& field : fields)
          for (const auto series : {&LocalField::density, &LocalField::slope}) {
            const Index first = sources_.firsts[bem::at(f)];
            for (Index row = first; row < sources_.firsts[bem::at(f) + 1]; ++row) {
              const Complex value = (field.*series)[bem::at(row - first)];
              sources_.coefficients(row, column) = value.real();
              sources_.coefficients(row, column + 1) = value.imag();
            }
            column += 2;
          }
        for (std::size_t order = 1; order < sources_.places.size(); ++order)
          for (std::size_t q = 0; q < order; ++q)
            sources_.places[order][bem::at(f) * order + q] =
                mesh()[asInt(f)].curve.fromMiddle(
                    gaussLegendre(asInt(static_cast<Index>(order))).points[q]);
      });
}

std::vector<LocalField> BoundaryFields::fieldsOf(int f) const {
  std::vector<LocalField> fields;
  fields.reserve(states_);
  for (std::size_t k = 0; k < states_; ++k)
    fields.push_back(localField(space_, displacements_[k], densities_[k], f));
  return fields;
}

void BoundaryFields::split(int element, int r, Sources& sources) const {
  const ElementLanes& run = runs_[r];
  const ElementLanes chosen = runs_.choose(element, r, {run.first, run.last});
  for (int f = run.first; f < run.last; ++f) {
    const int lane = f - run.first;
    if (!chosen.far[lane]) {
      sources.near.push_back(f);
      continue;
    }
    const Nearness& smooth = chosen.own[lane];
    sources.far[pointsOfTargets(smooth.outer)].elements.push_back(
        {f,
         pointsOn(smooth.inner, mesh()[f].degree),
         {chosen.wx[lane], chosen.wy[lane]}});
  }
}

BoundaryFields::Sources BoundaryFields::split(int element) const {
  Sources sources;
  const Element& target = mesh()[element];
  const Complex middle = asComplex(target.curve.frame().middle);
  groups_->visit(
      middle, target.half,
      [&](const SourceGroups::Group& group) {
        const double z = (std::abs(middle - group.centre) - group.radius) / target.half;
        sources.far[pointsOfTargets(farOrder(target.curve.angle(), z))].groups.push_back(
            &group);
      },
      [&](int r) { split(element, r, sources); });
  return sources;
}

/// Legendre coefficients of what is smooth on the element, columns as of KernelRows::equations: the
/// fields of far sources, and half of its own density and slope.
Matrix BoundaryFields::smoothSeries(int element, const Sources& sources) const {
  const Element& target = mesh()[element];
  const Index first = sources_.firsts[bem::at(element)];
  const Index own = sources_.firsts[bem::at(element) + 1] - first;
  const Index size =
      sources.far.empty() ? own : std::max<Index>(own, sources.far.rbegin()->first);
  Matrix series(size, sources_.coefficients.columns());
  for (Index j = 0; j < series.columns(); ++j)
    for (Index k = 0; k < own; ++k)
      series(k, j) = (j % 4 < 2 ? 0.5 : -0.5) * sources_.coefficients(first + k, j);
  for (const auto& [order, far] : sources.far) {
    const Rule& rule = gaussLegendre(order);
    const auto places =
        packed(rule.points, [&](double t) { return target.curve.fromMiddle(t); });
    const auto normals =
        packed(rule.points, [&](double t) { return target.curve.normal(t); });
    KernelRows rows(sources_, rule.points.size());
    for (const FarSource& source : far.elements)
      rows.add(source, places);
    Matrix values = rows.equations(lame_, normals);
    Matrix legendre = Matrix::unset(order, order);
    for (int q = 0; q < order; ++q) {
      const std::size_t lane = bem::at(q) % lanes;
      if (!far.groups.empty())
        addGroups(
            far.groups, lame_,
            asComplex(target.curve.frame().middle) + places[bem::at(q) / lanes][lane],
            normals[bem::at(q) / lanes][lane], q, values);
      legendreValues(order - 1, rule.points[bem::at(q)], legendre.column(q));
      for (int k = 0; k < order; ++k)
        legendre(k, q) *= rule.weights[bem::at(q)] * (k + 0.5);
    }
    addProduct(1, legendre, values, MatrixView(series).rowsBetween(0, order));
  }
  return series;
}

BoundaryFields::Values BoundaryFields::at(int element, const Sources& sources,
                                          const std::vector<EndPoint>& points) const {
  const Element& target = mesh()[element];
  KernelRows near(sources_, points.size());
  for (const int f : sources.near)
    near.add(f, seenFrom(mesh(), f, element, points));
  Matrix equations = near.equations(lame_, packed(points, [&](const EndPoint& point) {
                                      return target.curve.normal(point.t);
                                    }));
  const Matrix series = smoothSeries(element, sources);
  Matrix legendre = Matrix::unset(series.rows(), equations.rows());
  for (Index q = 0; q < legendre.columns(); ++q)
    legendreValues(asInt(series.rows()) - 1,
                   points[std::min(bem::at(q), points.size() - 1)].t, legendre.column(q));
  addTransposedProduct(1, legendre, series, equations);
  Values values(states_);
  Index column = 0;
  for (std::vector<BoundaryValue>& of : values) {
    const auto vectorAt = [&](Index row, Index x) -> Vec2 {
      return {equations(row, column + x), equations(row, column + x + 1)};
    };
    of.reserve(points.size());
    for (Index q = 0; q < static_cast<Index>(points.size()); ++q)
      of.push_back({points[bem::at(q)], 0, vectorAt(q, 0), vectorAt(q, 2)});
    column += 4;
  }
  return values;
}

BoundaryFields::Values BoundaryFields::at(int element,
                                          const std::vector<EndPoint>& points) const {
  return rings_ != nullptr ? ofRings(element, points)
                           : at(element, split(element), points);
}

BoundaryFields::Values BoundaryFields::ofRings(
    int element, const std::vector<EndPoint>& points) const {
  Values values(states_);
  if (mesh().isAxis(element))
    return values;
  const int terms = rings_->terms(element);
  std::array<double, largestDegree + 2> slopes{};
  std::array<double, largestDegree + 2> legendre{};
  for (const EndPoint& point : points) {
    legendreValues(terms, point.t, legendre.data());
    slopes[1] = 1;
    for (int k = 2; k < terms; ++k)
      slopes[k] = slopes[k - 2] + (2 * k - 1) * legendre[k - 1];
    for (std::size_t state = 0; state < states_; ++state) {
      const RingFields::Series& series = rings_->of(element, state);
      Complex force = 0;
      Complex slope = 0;
      for (int k = 0; k < terms; ++k) {
        force += legendre[k] * series.traction[k];
        slope += slopes[k] / mesh()[element].half * series.mismatch[k];
      }
      values[state].push_back({point, 0, asVector(force), asVector(slope)});
    }
  }
  return values;
}

BoundaryFields::Values BoundaryFields::on(int element, const Vector& cuts) const {
  const Sources sources = rings_ != nullptr ? Sources{} : split(element);
  std::vector<Feature> features;
  int degree = mesh()[element].degree;
  for (const int f : sources.near) {
    degree = std::max(degree, mesh()[f].degree);
    appendEnds(mesh(), element, f, features);
  }
  const GradedRule rule = softenedRule(features, degree + smoothPoints, cuts);
  Values values = rings_ != nullptr ? ofRings(element, rule.points)
                                    : at(element, sources, rule.points);
  for (std::vector<BoundaryValue>& of : values)
    for (std::size_t q = 0; q < of.size(); ++q)
      of[q].weight = mesh().measure(element, rule.points[q].t) * rule.weights[q];
  return values;
}

}  // namespace epafi::bem
