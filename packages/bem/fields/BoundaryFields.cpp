#include "bem/fields/BoundaryFields.hpp"

#include "bem/base/Parallel.hpp"
#include "bem/moments/ElementPotential.hpp"
#include "bem/simd/Dispatch.hpp"

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

/// Adds what carriers have of the fields of each state at eight points.
struct Combination {
  const ElementPotential& kernels;
  const std::vector<Complex>& shares;
  PointSources::Sums* sums;

  template <Division>
  EPAFI_INLINE void run() const {
    const auto count = static_cast<std::size_t>(kernels.size());
    for (std::size_t k = 0; k < shares.size() / count; ++k) {
      Pack sum[6] = {};
      for (std::size_t i = 0; i < count; ++i) {
        const KernelLanes& of = kernels[static_cast<int>(i)];
        PointSources::addProducts(shares[k * count + i], of.overConj.load(),
                                  of.cubic.load(), sum);
      }
      for (std::size_t part = 0; part < 6; ++part)
        add(sums[k / 2].of[k % 2][part].lane, sum[part]);
    }
  }
};

/// What elements do at points of another one in some states, in closed form.  Refers to its
/// arguments.
class NearElements {
 public:
  NearElements(const Mesh& mesh, int element, const std::vector<EndPoint>& points,
               std::size_t states)
      : mesh_(mesh),
        element_(element),
        points_(points),
        states_(states),
        sums_((points.size() + lanes - 1) / lanes * states) {}

  /// Adds an element, its field in each state.
  void add(int source, const std::vector<LocalField>& fields) {
    const Element& y = mesh_[source];
    ElementPotential kernels(y.curve, std::max(y.degree, y.densities));
    std::vector<Complex> shares;  // densities and slopes of the first state, and so on
    for (std::size_t state = 0; state < states_; ++state)
      for (const auto series : {&LocalField::density, &LocalField::slope})
        for (int k = 0; k < kernels.size(); ++k)
          shares.push_back(kernels.share(fields[state].*series, k));
    PointSources::Sums* to = sums_.data();
    for (const TargetLanes& targets : seenFrom(mesh_, source, element_, points_)) {
      kernels.evaluate(targets);
      dispatch(largestInstructionSet(), Combination{kernels, shares, to});
      to += states_;
    }
  }

  FieldSums at(std::size_t point, std::size_t state) const {
    return sums_[point / lanes * states_ + state].at(point % lanes);
  }

 private:
  const Mesh& mesh_;
  int element_;
  const std::vector<EndPoint>& points_;
  std::size_t states_;
  std::vector<PointSources::Sums> sums_;  ///< of eight points all states, and so on
};

}  // namespace

/// Points from `first` to `last` of everything with `order` points an element.
struct BoundaryFields::Stretch {
  int order = 0;
  std::size_t first = 0;
  std::size_t last = 0;
};

struct BoundaryFields::Far {
  std::vector<Stretch> stretches{};
  std::vector<const SourceGroups::Group*> groups{};
  PointSources points;  ///< places relative to the middle of the target

  explicit Far(std::size_t states) : points(states) {}
};

struct BoundaryFields::Sources {
  std::size_t states;
  std::vector<int> near{};
  std::map<int, Far> all{};  ///< by Gauss points on the target element

  Far& far(int order) { return all.try_emplace(order, states).first->second; }
};

/// What is smooth on the target element, Legendre coefficients: fields of the far sources, and
/// half of the element's own density and slope.
struct BoundaryFields::SmoothSeries {
  std::vector<Complex> traction;
  std::vector<Complex> mismatch;
};

BoundaryFields::BoundaryFields(const Space& space, const Lame& lame,
                               const std::vector<BoundaryState>& states)
    : mesh_(space.mesh().withDegreesOfDensities()),
      runs_(mesh_),
      space_(space),
      lame_(lame),
      states_(states.size()) {
  for (const BoundaryState& state : states) {
    displacements_.push_back(space.withoutRotation(state.displacement));
    densities_.push_back(state.density);
  }
  if (mesh_.outline().isAxisymmetric()) {
    std::vector<LocalField> fields;
    for (int e = 0; e < mesh_.size(); ++e)
      for (const LocalField& field : fieldsOf(e))
        fields.push_back(field);
    rings_ = std::make_unique<const RingFields>(mesh_, lame_, fields, states_);
    return;
  }
  int largest = 0;
  for (const Element& element : mesh_.elements())
    largest = std::max(largest, element.degree);
  while (static_cast<int>(everything_.size()) <= pointsOn(smoothOrderOfCircles, largest))
    everything_.emplace_back(states_);
  constexpr double ofPoint = 100;  // ns
  const auto orders = static_cast<Index>(everything_.size()) - 1;
  parallelFor(
      {orders, 0.5 * ofPoint * static_cast<double>(orders * orders) * mesh_.size()},
      [&](Index k) {
        const int order = asInt(orders - k);  // the longest first
        PointSources& points = everything_[bem::at(order)];
        for (int f = 0; f < mesh_.size(); ++f)
          addCarriers(f, order, mesh_[f].curve.frame().middle, points);
      });
  const auto densities = [this](int f, const Rule& rule, std::vector<Complex>& g) {
    const Element& source = mesh_[f];
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

std::vector<LocalField> BoundaryFields::fieldsOf(int f) const {
  std::vector<LocalField> fields;
  fields.reserve(states_);
  for (std::size_t k = 0; k < states_; ++k)
    fields.push_back(localField(space_, displacements_[k], densities_[k], f));
  return fields;
}

/// Element f through Gauss points, `middle` its place.
void BoundaryFields::addPlaces(int f, int order, Vec2 middle,
                               PointSources& points) const {
  for (const double t : gaussLegendre(order).points)
    points.add(asComplex(middle + mesh_[f].curve.fromMiddle(t)));
}

/// The same with what they carry.
void BoundaryFields::addCarriers(int f, int order, Vec2 middle,
                                 PointSources& points) const {
  const Element& source = mesh_[f];
  const Rule& rule = gaussLegendre(order);
  const std::vector<LocalField> fields = fieldsOf(f);
  for (std::size_t q = 0; q < rule.points.size(); ++q) {
    const double t = rule.points[q];
    const double weight = source.half * rule.weights[q];
    points.add(asComplex(middle + source.curve.fromMiddle(t)));
    for (std::size_t k = 0; k < states_; ++k) {
      const LocalField& values = fields[k];
      points.carry(k, weight * evaluate(values.density, source.densities - 1, t),
                   weight * evaluate(values.slope, source.degree - 1, t));
    }
  }
}

void BoundaryFields::addFar(int f, int order, Vec2 middle, PointSources& points) const {
  if (static_cast<std::size_t>(order) >= everything_.size())
    return addCarriers(f, order, middle, points);
  addPlaces(f, order, middle, points);
  const std::size_t first = static_cast<std::size_t>(f) * order;
  points.carry(everything_[order], first, first + order);
}

void BoundaryFields::splitRun(int element, int r, Sources& sources) const {
  const ElementLanes& run = runs_[r];
  const ElementLanes chosen = runs_.choose(element, r, {run.first, run.last});
  if (chosen.arePlain) {
    const int order = pointsOn(chosen.smooth.inner, run.degree);
    const std::size_t first = run.first * order;
    const std::size_t last = run.last * order;
    // interpolation needs twice as many points as a product of two such fields
    auto& stretches = sources.far(2 * chosen.smooth.outer).stretches;
    if (!stretches.empty() && stretches.back().order == order &&
        stretches.back().last == first)
      stretches.back().last = last;
    else
      stretches.push_back({order, first, last});
    return;
  }
  for (int f = run.first; f < run.last; ++f) {
    const int lane = f - run.first;
    if (!chosen.far[lane]) {
      sources.near.push_back(f);
      continue;
    }
    const Nearness& smooth = chosen.own[lane];
    addFar(f, pointsOn(smooth.inner, mesh_[f].degree), -mesh_.offset(element, f),
           sources.far(2 * smooth.outer).points);
  }
}

BoundaryFields::Sources BoundaryFields::split(int element) const {
  Sources sources{states_};
  const double half = mesh_[element].half;
  const Complex middle = asComplex(mesh_[element].curve.frame().middle);
  groups_->visit(
      middle, half,
      [&](const SourceGroups::Group& group) {
        const double z = (std::abs(middle - group.centre) - group.radius) / half;
        sources.far(2 * farOrder(mesh_[element].curve.angle(), z))
            .groups.push_back(&group);
      },
      [&](int r) { splitRun(element, r, sources); });
  return sources;
}

// NOLINTNEXTLINE(readability-function-cognitive-complexity): loops that add
std::vector<BoundaryFields::SmoothSeries> BoundaryFields::smoothSeries(
    int element, const Sources& sources) const {
  const Element& target = mesh_[element];
  const Complex middle = asComplex(target.curve.frame().middle);
  std::size_t size = std::max(target.degree, target.densities);
  if (!sources.all.empty())
    size = std::max(size, static_cast<std::size_t>(sources.all.rbegin()->first));
  std::vector<SmoothSeries> series(
      states_, {std::vector<Complex>(size), std::vector<Complex>(size)});
  const std::vector<LocalField> fields = fieldsOf(element);
  for (std::size_t i = 0; i < states_; ++i) {
    const LocalField& own = fields[i];
    for (int k = 0; k < std::max(target.degree, target.densities); ++k) {
      series[i].traction[k] = 0.5 * own.density[k];
      series[i].mismatch[k] = -0.5 * own.slope[k];
    }
  }
  std::vector<double> factors(size);
  std::vector<PointSources::Sums> ofPoints(states_);
  std::vector<FieldSums> sums(states_);
  for (const auto& [order, far] : sources.all) {
    const Rule& rule = gaussLegendre(order);
    for (int q = 0; q < order; ++q) {
      legendreValues(order - 1, rule.points[q], factors.data());
      for (int k = 0; k < order; ++k)
        factors[k] *= rule.weights[q] * (k + 0.5);
      const Complex normal = asComplex(target.curve.normal(rule.points[q]));
      const Complex offset = asComplex(target.curve.fromMiddle(rule.points[q]));
      std::fill(ofPoints.begin(), ofPoints.end(), PointSources::Sums());
      far.points.addAt(offset, 0, far.points.size(), ofPoints);
      for (const Stretch& stretch : far.stretches)
        everything_[stretch.order].addAt(middle + offset, stretch.first, stretch.last,
                                         ofPoints);
      for (std::size_t i = 0; i < states_; ++i)
        sums[i] = ofPoints[i].total();
      for (const SourceGroups::Group* group : far.groups)
        SourceGroups::addAt(*group, middle + offset, sums);
      for (std::size_t i = 0; i < states_; ++i) {
        const Complex t = traction(lame_, normal, sums[i]);
        const Complex m = mismatchSlope(lame_, normal, sums[i]);
        for (int k = 0; k < order; ++k) {
          series[i].traction[k] += factors[k] * t;
          series[i].mismatch[k] += factors[k] * m;
        }
      }
    }
  }
  return series;
}

BoundaryFields::Values BoundaryFields::at(int element, const Sources& sources,
                                          const std::vector<EndPoint>& points) const {
  const std::vector<SmoothSeries> series = smoothSeries(element, sources);
  NearElements near(mesh_, element, points, states_);
  for (const int f : sources.near)
    near.add(f, fieldsOf(f));
  const std::size_t terms = series.front().traction.size();
  std::vector<double> legendre(terms);
  Values values(states_);
  for (std::size_t q = 0; q < points.size(); ++q) {
    const double t = points[q].t;
    legendreValues(static_cast<int>(terms) - 1, t, legendre.data());
    const Complex normal = asComplex(mesh_[element].curve.normal(t));
    for (std::size_t k = 0; k < states_; ++k) {
      const FieldSums sums = near.at(q, k);
      Complex force = traction(lame_, normal, sums);
      Complex slope = mismatchSlope(lame_, normal, sums);
      for (std::size_t j = 0; j < terms; ++j) {
        force += legendre[j] * series[k].traction[j];
        slope += legendre[j] * series[k].mismatch[j];
      }
      values[k].push_back({points[q], 0, asVector(force), asVector(slope)});
    }
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
  if (mesh_.isAxis(element))
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
        slope += slopes[k] / mesh_[element].half * series.mismatch[k];
      }
      values[state].push_back({point, 0, asVector(force), asVector(slope)});
    }
  }
  return values;
}

BoundaryFields::Values BoundaryFields::on(int element, const Vector& cuts) const {
  const Sources sources = rings_ != nullptr ? Sources{states_} : split(element);
  std::vector<Feature> features;
  int degree = mesh_[element].degree;
  for (const int f : sources.near) {
    degree = std::max(degree, mesh_[f].degree);
    appendEnds(mesh_, element, f, features);
  }
  const GradedRule rule = softenedRule(features, degree + smoothPoints, cuts);
  Values values = rings_ != nullptr ? ofRings(element, rule.points)
                                    : at(element, sources, rule.points);
  for (std::vector<BoundaryValue>& of : values)
    for (std::size_t q = 0; q < of.size(); ++q)
      of[q].weight = mesh_.measure(element, rule.points[q].t) * rule.weights[q];
  return values;
}

}  // namespace epafi::bem
