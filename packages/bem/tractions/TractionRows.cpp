#include "bem/tractions/TractionRows.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Parallel.hpp"
#include "bem/kernel/ElementSums.hpp"
#include "bem/moments/RelativeTarget.hpp"
#include "bem/quadrature/Graded.hpp"
#include "bem/tractions/FarTractionRows.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::bem {

namespace {

constexpr int largestMoments = 48;

/// Gauss points, beside those of polynomials, beyond which a source's field on an element
/// would need too many Legendre moments.
constexpr int smoothOrderOfMoments = 7;

/// Values at one outer point of all sources on one element: K' of P_j e_c and W of the
/// derivative P_j e_c, j below the source's degree.
struct SourceValues {
  Complex adjoint[largestDegree][2];
  Complex hyper[largestDegree][2];
};

/// Which numbers a source function has: density or displacement, global index, weight.
enum class Kind { Density, Displacement };

/// Calls visit(kind, unknown, value) for every basis function on element f, given the
/// values of its Legendre components.
template <class Visit>
void forEachSource(const Space& space, int f, const SourceValues& values,
                   const Visit& visit) {
  const Element& source = space.mesh()[f];
  for (int j = 0; j < source.degree; ++j)
    for (int c = 0; c < 2; ++c) {
      visit(Kind::Density, space.density(f, j, c), values.adjoint[j][c]);
      const Complex hyper = values.hyper[j][c] / source.half;
      const auto [first, last] = DisplacementBasis::withDerivative(j);
      for (int k = first; k <= last; ++k)
        visit(Kind::Displacement, space.displacement(f, k, c),
              DisplacementBasis::slope(k) * hyper);
    }
}

class ElementRows {
 public:
  ElementRows(const FarTractionRows& far, const Space& space, const Lame& lame,
              int element, TractionForm form)
      : far_(far), space_(space), mesh_(space.mesh()), lame_(lame), element_(element) {
    moments_ = mesh_[element].degree + 1;
    if (form == TractionForm::Exact) {  // what far sources have beyond these is 1e-12
      largestOuter_ = smoothOrderOfMoments;
      moments_ = std::max(moments_, 2 * largestOuter_);
    }
    near_ = far.near(element_, largestOuter_);
    makeRule();
    if (form == TractionForm::Exact)
      compress();
  }

  Index columns() const { return 2 * moments_ + extra_.rows(); }

  /// Adds the kernels' columns, from `first` on, to the transposed rows of W and K' + 1/2.
  void write(Index first, Matrix& hyper, Matrix& adjoint) const {
    const auto put = [&](Kind kind, Index unknown, Index column, double value) {
      (kind == Kind::Density ? adjoint : hyper)(unknown, column) += value;
    };
    const auto putMoments = [&](double weight, const double* legendre) {
      return [&, weight, legendre](Kind kind, Index unknown, Complex value) {
        for (int i = 0; i < moments_; ++i) {
          const double factor = weight * legendre[i] * normalisation(i);
          put(kind, unknown, first + 2 * i, factor * value.real());
          put(kind, unknown, first + 2 * i + 1, factor * value.imag());
        }
      };
    };
    SourceValues values;
    double legendre[largestMoments];
    far_.write(element_, moments_, largestOuter_, first, hyper, adjoint);
    for (int q = 0; q < rule_.size(); ++q) {
      legendreValues(moments_ - 1, rule_.points[q].t, legendre);
      for (const int f : near_) {
        evaluate(f, place(rule_.points[q]), rule_.points[q].t, values);
        forEachSource(space_, f, values, putMoments(rule_.weights[q], legendre));
      }
    }
    for (std::size_t s = 0; s < nearSources_.size(); ++s)
      for (Index r = 0; r < extra_.rows(); ++r)
        put(nearSources_[s].kind, nearSources_[s].unknown, first + 2 * moments_ + r,
            extra_(r, static_cast<Index>(s)));
  }

 private:
  struct Source {
    Kind kind;
    Index unknown;
  };

  // √(h/2) √((2i+1)/2) turns ∫ f P_i dt into ∫ f P̂_i ds
  double normalisation(int i) const {
    return std::sqrt(mesh_[element_].half * (2 * i + 1) / 2);
  }

  /// Near sources get graded points.  In the exact form these are also the ones whose
  /// field on the element would need many Legendre moments.
  void makeRule() {
    std::vector<Feature> features;
    int degree = mesh_[element_].degree;
    double smallest = 1e-16;
    for (const int f : near_) {
      const Piece& piece = mesh_[f].piece;
      degree = std::max(degree, mesh_[f].degree);
      smallest = std::min(smallest, 1e-16 * mesh_[f].half / mesh_[element_].half);
      for (const Position& end : {piece.start, piece.end}) {
        const RelativeTarget seen = seenFrom(mesh_, element_, {piece.edge, end, 0});
        features.push_back({seen.z().real(), std::abs(seen.b())});
      }
    }
    rule_ = gradedRule(features, 17 + (degree + moments_) / 2, smallest);
  }

  BoundaryPoint place(const EndPoint& point) const {
    return mesh_.at(element_, point.fromStart, point.toEnd);
  }

  void evaluate(int f, const BoundaryPoint& x, double t, SourceValues& values) const {
    const Element& source = mesh_[f];
    ElementSums sums;
    sums.evaluate(source.curve, seenFrom(mesh_, f, x), source.degree);
    const Complex normal = asComplex(mesh_[element_].curve.normal(t));
    for (int j = 0; j < source.degree; ++j) {
      const SourceSums in = sums[j];
      const Complex units[2] = {1, Complex(0, 1)};
      for (int c = 0; c < 2; ++c) {
        values.adjoint[j][c] = adjointDoubleLayer(lame_, normal, units[c] * in);
        values.hyper[j][c] = hypersingular(lame_, normal, units[c] * in);
      }
    }
    if (f != element_)
      return;
    double legendre[largestDegree];
    legendreValues(source.degree - 1, t, legendre);
    for (int j = 0; j < source.degree; ++j) {  // the 1/2 of K' + 1/2
      values.adjoint[j][0] += 0.5 * legendre[j];
      values.adjoint[j][1] += Complex(0, 0.5 * legendre[j]);
    }
  }

  /// What the near sources have beyond the Legendre moments: their values at the graded
  /// points minus the projection, compressed by a pivoted QR factorisation.
  void compress() {
    const Index points = rule_.size();
    Matrix samples = nearSamples(points);
    removeMoments(samples, points);
    extra_ = triangularFactor(std::move(samples));
  }

  Matrix nearSamples(Index points) {
    std::vector<std::vector<double>> columns;
    SourceValues values;
    for (const int f : near_) {
      const std::size_t first = columns.size();
      for (Index q = 0; q < points; ++q) {
        const double weight = std::sqrt(rule_.weights[q] * mesh_[element_].half);
        evaluate(f, place(rule_.points[q]), rule_.points[q].t, values);
        std::size_t column = first;
        forEachSource(space_, f, values, [&](Kind kind, Index unknown, Complex value) {
          if (q == 0) {
            nearSources_.push_back({kind, unknown});
            columns.emplace_back(static_cast<std::size_t>(2 * points));
          }
          columns[column][q] = weight * value.real();
          columns[column][q + points] = weight * value.imag();
          ++column;
        });
      }
    }
    Matrix samples(2 * points, static_cast<Index>(columns.size()));
    for (Index c = 0; c < samples.columns(); ++c)
      std::copy(columns[c].begin(), columns[c].end(), samples.column(c));
    return samples;
  }

  void removeMoments(Matrix& samples, Index points) const {
    Matrix basis(points, moments_);
    std::array<double, largestMoments> legendre{};
    for (Index q = 0; q < points; ++q) {
      legendreValues(moments_ - 1, rule_.points[q].t, legendre.data());
      for (int i = 0; i < moments_; ++i)
        basis(q, i) = std::sqrt(rule_.weights[q] * (2 * i + 1) / 2) * legendre[i];
    }
    for (Index c = 0; c < samples.columns(); ++c)
      for (int part = 0; part < 2; ++part)
        for (int i = 0; i < moments_; ++i) {
          double* value = samples.column(c) + part * points;
          double projection = 0;
          for (Index q = 0; q < points; ++q)
            projection += basis(q, i) * value[q];
          for (Index q = 0; q < points; ++q)
            value[q] -= projection * basis(q, i);
        }
  }

  // R of samples P = Q R, in the order of the sources, without rows that do not matter
  static Matrix triangularFactor(Matrix samples) {
    const std::vector<Index> places = pivotedTriangle(samples);
    const Index n = samples.columns();
    Index rank = 0;
    const double largest = std::abs(samples(0, 0));
    while (rank < std::min(samples.rows(), n) &&
           std::abs(samples(rank, rank)) > 1e-13 * largest)
      ++rank;
    Matrix factor(rank, n);
    for (Index c = 0; c < n; ++c)
      for (Index r = 0; r < std::min(rank, c + 1); ++r)
        factor(r, places[c]) = samples(r, c);
    return factor;
  }

  const FarTractionRows& far_;
  const Space& space_;
  const Mesh& mesh_;
  Lame lame_;
  int element_;
  int moments_ = 0;
  int largestOuter_ = largestSmoothOrder;
  std::vector<int> near_;
  GradedRule rule_;
  std::vector<Source> nearSources_;
  Matrix extra_;
};

}  // namespace

std::shared_ptr<const TractionRows> tractionRows(const Space& space, const Lame& lame,
                                                 const SteklovPoincare& stiffness,
                                                 const std::vector<int>& elements,
                                                 TractionForm form) {
  if (form == TractionForm::Projected && stiffness.tractionElements() == elements)
    return stiffness.tractions();

  const FarTractionRows far(space, lame);
  const auto count = static_cast<Index>(elements.size());
  constexpr double ofNearSources = 2e5;  // ns
  constexpr double ofFarSource = 1e3;
  std::vector<std::unique_ptr<ElementRows>> parts(elements.size());
  parallelFor({count, ofNearSources * count}, [&](Index k) {
    parts[at(k)] = std::make_unique<ElementRows>(far, space, lame, elements[at(k)], form);
  });

  TractionRows result;
  result.start.assign(1, 0);
  for (const auto& part : parts)
    result.start.push_back(result.start.back() + part->columns());

  Matrix hypersingular(space.displacements(), result.start.back());
  Matrix adjoint(space.densities(), result.start.back());
  const double work = (ofNearSources + ofFarSource * space.mesh().size()) * count;
  parallelFor({count, work}, [&](Index k) {
    parts[at(k)]->write(result.start[at(k)], hypersingular, adjoint);
  });
  result.rows = stiffness.addAdjointDensity(std::move(hypersingular), std::move(adjoint));
  return std::make_shared<const TractionRows>(std::move(result));
}

}  // namespace epafi::bem
