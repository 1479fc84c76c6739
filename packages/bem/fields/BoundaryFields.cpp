#include "bem/fields/BoundaryFields.hpp"

#include "bem/fields/NearElements.hpp"
#include "bem/moments/RelativeTarget.hpp"

#include <algorithm>
#include <map>

namespace epafi::bem {

namespace {

/// Gauss points on an interval beyond the degree, for 2e-6 in the integrals of squares.
constexpr int smoothPoints = 6;

/// Gauss points on a source of a degree: its density has one less.
int pointsOn(int smoothOrder, int degree) { return smoothOrder + degree / 2; }

}  // namespace

struct BoundaryFields::Sources {
  /// Points from `first` to `last` of everything with `order` points an element.
  struct Stretch {
    int order;
    std::size_t first;
    std::size_t last;
  };
  struct Far {
    std::vector<Stretch> stretches;
    std::vector<const SourceGroups::Group*> groups;
    PointSources points;  ///< places relative to the middle of the target
  };
  std::vector<int> near;
  std::map<int, Far> far;  ///< by Gauss points on the target element
};

/// What is smooth on the target element, Legendre coefficients: fields of the far sources, and
/// half of the element's own density and slope.
struct BoundaryFields::SmoothSeries {
  std::vector<Complex> traction;
  std::vector<Complex> mismatch;
};

BoundaryFields::BoundaryFields(const Space& space, const Lame& lame, const Vector& u,
                               const Vector& psi)
    : mesh_(space.mesh().withDegreesOfDensities()), runs_(mesh_), lame_(lame) {
  int largest = 0;
  const Vector inner = space.withoutRotation(u);
  for (int e = 0; e < mesh_.size(); ++e) {
    fields_.push_back(localField(space, inner, psi, e));
    largest = std::max(largest, mesh_[e].degree);
  }
  everything_.resize(static_cast<std::size_t>(pointsOn(smoothOrderOfCircles, largest)) +
                     1);
  for (std::size_t order = 1; order < everything_.size(); ++order)
    for (int f = 0; f < mesh_.size(); ++f)
      addPoints(f, static_cast<int>(order), mesh_[f].curve.frame().middle,
                everything_[order]);
  groups_ = std::make_unique<const SourceGroups>(runs_, fields_);
}

/// Element f through Gauss points, `middle` its place.
void BoundaryFields::addPoints(int f, int order, Vec2 middle,
                               PointSources& points) const {
  const Element& source = mesh_[f];
  const LocalField& values = fields_[f];
  const Rule& rule = gaussLegendre(order);
  const auto place = [&](std::size_t q) {
    return asComplex(middle + source.curve.fromMiddle(rule.points[q]));
  };
  const auto size = static_cast<std::size_t>(order);
  const std::size_t first = static_cast<std::size_t>(f) * size;
  if (size < everything_.size() && first < everything_[size].size()) {
    points.add(everything_[size], first, size, place);
    return;
  }
  for (std::size_t q = 0; q < size; ++q) {
    const double t = rule.points[q];
    const double weight = source.half * rule.weights[q];
    points.add(place(q), weight * evaluate(values.density, source.densities - 1, t),
               weight * evaluate(values.slope, source.degree - 1, t));
  }
}

void BoundaryFields::splitRun(int element, int r, Sources& sources) const {
  FarBatch batch{};
  const ElementRun& run = runs_[r];
  const FarLanes chosen = runs_.choose(element, r, {run.first, run.last}, batch);
  if (chosen.atOnce) {
    const int order = pointsOn(chosen.smooth.inner, chosen.columns);
    const std::size_t first = run.first * order;
    const std::size_t last = run.last * order;
    // interpolation needs twice as many points as a product of two such fields
    auto& stretches = sources.far[2 * chosen.smooth.outer].stretches;
    if (!stretches.empty() && stretches.back().order == order &&
        stretches.back().last == first)
      stretches.back().last = last;
    else
      stretches.push_back({order, first, last});
    return;
  }
  const BoundaryPoint middle = mesh_.at(element, 0);
  for (int f = run.first; f < run.last; ++f) {
    const int lane = f - run.first;
    if (!chosen.far[lane]) {
      sources.near.push_back(f);
      continue;
    }
    const FarOrder& smooth = chosen.own[lane];
    addPoints(f, pointsOn(smooth.inner, mesh_[f].degree),
              -mesh_.difference(middle, mesh_.at(f, 0)),
              sources.far[2 * smooth.outer].points);
  }
}

BoundaryFields::Sources BoundaryFields::split(int element) const {
  Sources sources;
  const std::vector<SourceGroups::Group>& groups = groups_->groups();
  if (groups.empty())
    for (int r = 0; r < runs_.size(); ++r)
      splitRun(element, r, sources);
  const double half = mesh_[element].half;
  const Complex middle = asComplex(mesh_[element].curve.frame().middle);
  std::vector<int> waiting(groups.empty() ? 0 : 1, 0);
  while (!waiting.empty()) {
    const SourceGroups::Group& group = groups[waiting.back()];
    waiting.pop_back();
    if (SourceGroups::isFar(group, middle, half) && mesh_[element].curve.isStraight()) {
      const double z = (std::abs(middle - group.centre) - group.radius) / half;
      sources.far[2 * smoothOrder(z)].groups.push_back(&group);
    } else if (group.children[0] >= 0) {
      waiting.insert(waiting.end(), {group.children[1], group.children[0]});
    } else {
      for (int r = group.first; r < group.last; ++r)
        splitRun(element, r, sources);
    }
  }
  return sources;
}

BoundaryFields::SmoothSeries BoundaryFields::smoothSeries(int element,
                                                          const Sources& sources) const {
  const Element& target = mesh_[element];
  const Complex middle = asComplex(target.curve.frame().middle);
  SmoothSeries series;
  const LocalField& own = fields_[element];
  for (int k = 0; k < std::max(target.degree, target.densities); ++k) {
    series.traction.push_back(0.5 * own.density[k]);
    series.mismatch.push_back(-0.5 * own.slope[k]);
  }
  for (const auto& [order, far] : sources.far) {
    const std::size_t size = order;
    series.traction.resize(std::max(series.traction.size(), size));
    series.mismatch.resize(series.traction.size());
    const Rule& rule = gaussLegendre(order);
    std::vector<double> legendre(size);
    for (int q = 0; q < order; ++q) {
      legendreValues(order - 1, rule.points[q], legendre.data());
      const Complex normal = asComplex(target.curve.normal(rule.points[q]));
      const Complex offset = asComplex(target.curve.fromMiddle(rule.points[q]));
      FieldSums sums = far.points.at(offset);
      for (const Sources::Stretch& stretch : far.stretches)
        sums.add(
            everything_[stretch.order].at(middle + offset, stretch.first, stretch.last));
      for (const SourceGroups::Group* group : far.groups)
        sums.add(SourceGroups::at(*group, middle + offset));
      const Complex t = traction(lame_, normal, sums);
      const Complex m = mismatchSlope(lame_, normal, sums);
      for (std::size_t k = 0; k < size; ++k) {
        const double factor =
            rule.weights[q] * legendre[k] * (static_cast<double>(k) + 0.5);
        series.traction[k] += factor * t;
        series.mismatch[k] += factor * m;
      }
    }
  }
  return series;
}

std::vector<BoundaryValue> BoundaryFields::at(int element, const Sources& sources,
                                              const std::vector<EndPoint>& points) const {
  const SmoothSeries series = smoothSeries(element, sources);
  NearElements near(mesh_, element, points);
  for (const int f : sources.near)
    near.add(f, fields_[f]);
  std::vector<BoundaryValue> values;
  for (std::size_t q = 0; q < points.size(); ++q)
    values.push_back(valueAt(element, points[q], near.at(q), series));
  return values;
}

BoundaryValue BoundaryFields::valueAt(int element, const EndPoint& point,
                                      const FieldSums& sums,
                                      const SmoothSeries& series) const {
  const Complex normal = asComplex(mesh_[element].curve.normal(point.t));
  const int last = static_cast<int>(series.traction.size()) - 1;
  const Complex t =
      traction(lame_, normal, sums) + evaluate(series.traction, last, point.t);
  const Complex m =
      mismatchSlope(lame_, normal, sums) + evaluate(series.mismatch, last, point.t);
  return {point, 0, asVector(t), asVector(m)};
}

std::vector<BoundaryValue> BoundaryFields::at(int element,
                                              const std::vector<EndPoint>& points) const {
  return at(element, split(element), points);
}

std::vector<BoundaryValue> BoundaryFields::on(int element, const Vector& cuts) const {
  const Sources sources = split(element);
  std::vector<Feature> features;
  int degree = mesh_[element].degree;
  for (const int f : sources.near) {
    const Piece& piece = mesh_[f].piece;
    degree = std::max(degree, mesh_[f].degree);
    for (const Position& end : {piece.start, piece.end}) {
      const RelativeTarget seen = seenFrom(mesh_, element, {piece.edge, end, 0});
      features.push_back({seen.z().real(), std::abs(seen.b())});
    }
  }
  const GradedRule rule = softenedRule(features, degree + smoothPoints, cuts);
  std::vector<BoundaryValue> values = at(element, sources, rule.points);
  for (std::size_t q = 0; q < values.size(); ++q)
    values[q].weight = mesh_[element].half * rule.weights[q];
  return values;
}

}  // namespace epafi::bem
