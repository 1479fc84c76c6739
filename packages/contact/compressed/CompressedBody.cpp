#include "contact/compressed/CompressedBody.hpp"

#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/compressed/CompressedFlexibility.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace epafi::contact {

using bem::dot;

CompressedBody::CompressedBody(const BodyInput& input, const MultiplierSpace& multiplier,
                               std::size_t body, std::shared_ptr<const Holding> holding,
                               Coupling plain)
    : ElasticBody(input.space, std::move(holding),
                  stabilised(std::move(plain), input.space, multiplier, body,
                             input.stabilization, input.lame, input.units)),
      operators_(input.stiffness.compressed()),
      range_(operators_->range(input.stiffness.compressedBody())) {
  restriction_.held.assign(at(operators_->size()), 1);
  const auto held = restriction_.held.begin();
  std::fill(held + range_.densities, held + range_.last, 0);
  std::copy(holding_->clamped.begin(), holding_->clamped.end(), held + range_.first);
  addSprings();
  factor_ = std::make_unique<const bem::CompressedFactor>(*operators_, restriction_);
}

// One spring per rigid motion that clamps allow, where pivoting finds the motions least dependent,
// rows weighted with the lengths of functionals: a force on a short element causes densities,
// and rounding errors, proportional to 1/h.
void CompressedBody::addSprings() {
  const Matrix& motions = holding_->allowed;
  const Matrix& functionals = holding_->functionals;
  if (motions.columns() == 0)
    return;
  Vector lengths(at(motions.rows()));
  for (Index k = 0; k < functionals.columns(); ++k)
    for (Index i = 0; i < functionals.rows(); ++i)
      lengths[at(i)] += std::abs(functionals(i, k));
  // lengths above a quarter of the longest count as equal
  const double longest = *std::max_element(lengths.begin(), lengths.end());
  Matrix moved(motions.columns(), motions.rows());
  for (Index k = 0; k < motions.columns(); ++k)
    for (Index i = 0; i < motions.rows(); ++i)
      moved(k, i) = std::min(lengths[at(i)], 0.25 * longest) * motions(i, k);
  const std::vector<Index> rows = bem::pivotedTriangle(moved);
  for (Index k = 0; k < motions.columns(); ++k) {
    const Index spring = range_.first + rows[at(k)];
    restriction_.entries.push_back({spring, spring, range_.stiffness});
  }
}

// A⁺ f = (I - R cᵀ) M⁻¹ (I - c Rᵀ) f: under balanced loads, as many springs as motions
// carry no force
Vector CompressedBody::solve(const Vector& force) const {
  const auto without = [](const Matrix& seen, const Matrix& taken, Vector x) {
    for (Index k = 0; k < taken.columns(); ++k)
      bem::axpy(-dot(columnOf(seen, k), x), columnOf(taken, k), x);
    return x;
  };
  const Matrix x = factor_->solve(placed(
      bem::ConstMatrixView(without(holding_->allowed, holding_->functionals, force))
          .copy()));
  solved_.assign(x.data() + range_.densities, x.data() + range_.last);
  return without(holding_->functionals, holding_->allowed, forcesIn(x));
}

Matrix CompressedBody::addCompliance(Matrix d, const std::vector<Vector>& /*motions*/,
                                     const std::vector<Vector>& reactions) const {
  const CompressedFlexibility own({shared_from_this()}, 0, {reactions},
                                  coupling_.columns());
  bem::addTo(d, own.formed());
  return d;
}

// W u + K' ψ, ψ that of u, and uᵀ W u + ψᵀ (V + G) ψ from Z's products
ElasticBody::Image CompressedBody::imageOf(const Vector& u) const {
  const auto& [unused, psi, images] = fieldOf(u);
  const double* ofMotions = images.column(0) + range_.first;
  const double* ofDensities = images.column(1);
  Image image{std::vector<long double>(u.size()),
              std::inner_product(u.begin(), u.end(), ofMotions, 0.0) -
                  std::inner_product(psi.begin(), psi.end(),
                                     ofDensities + range_.densities, 0.0)};
  std::transform(ofMotions, ofMotions + u.size(), ofDensities + range_.first,
                 image.forces.begin(), std::plus<double>());
  return image;
}

Vector CompressedBody::density(const Vector& u, const Vector& w) const {
  Vector psi = fieldOf(u).psi;
  if (!w.empty())
    bem::axpy(-1, onDensities(w).psi, psi);
  return psi;
}

Vector CompressedBody::tractionsOf(const Vector& u) const {
  return coupling_.ofDensities(fieldOf(u).psi);
}

Vector CompressedBody::responsesTo(const Vector& w) const {
  return coupling_.ofDensities(onDensities(w).psi);
}

std::pair<Vector, Vector> CompressedBody::answerTo(const Vector& g) const {
  Vector psi = bem::times(-1, densityFor(placed(g), 1));
  Vector force = forcesIn(operators_->times(placed(psi)));
  return {std::move(psi), std::move(force)};
}

const CompressedBody::OnDensities& CompressedBody::onDensities(const Vector& w) const {
  if (w != onDensities_.w) {
    auto [psi, force] = answerTo(coupling_.onDensities(w, space_.densities()));
    onDensities_ = {w, std::move(psi), std::move(force)};
  }
  return onDensities_;
}

Vector CompressedBody::forcesIn(const Matrix& image) const {
  return {image.data() + range_.first, image.data() + range_.densities};
}

Matrix CompressedBody::placed(const Matrix& displacements) const {
  Matrix result(operators_->size(), displacements.columns());
  for (Index k = 0; k < displacements.columns(); ++k)
    std::copy_n(displacements.column(k), displacements.rows(),
                result.column(k) + range_.first);
  return result;
}

Matrix CompressedBody::placed(const Vector& density) const {
  Matrix x(operators_->size(), 1);
  std::copy(density.begin(), density.end(), x.data() + range_.densities);
  return x;
}

const bem::CompressedFactor& CompressedBody::densityFactor() const {
  if (densityFactor_ == nullptr) {
    bem::Restriction restriction;
    restriction.held.assign(at(operators_->size()), 1);
    std::fill(restriction.held.begin() + range_.densities,
              restriction.held.begin() + range_.last, 0);
    densityFactor_ =
        std::make_unique<const bem::CompressedFactor>(*operators_, restriction);
  }
  return *densityFactor_;
}

Vector CompressedBody::densityFor(const Matrix& right, int refinements) const {
  const Matrix psi = densityFactor().solve(right, refinements);
  return {psi.data() + range_.densities, psi.data() + range_.last};
}

const CompressedBody::LeftOfMotions& CompressedBody::leftOfMotions() const {
  if (leftOfMotions_ == nullptr) {
    const Matrix& modes = holding_->modes.motions;
    Matrix left =
        bem::rowsBetween(operators_->times(placed(modes)), range_.densities, range_.last)
            .copy();
    Matrix right(operators_->size(), modes.columns());
    for (Index k = 0; k < left.columns(); ++k)
      for (Index i = 0; i < left.rows(); ++i)
        right(range_.densities + i, k) = -left(i, k);
    Matrix factor = bem::transposedProduct(left, left);
    if (bem::cholesky(factor) != 0)
      left = Matrix();
    Matrix psi = left.columns() > 0 ? densityFactor().solve(right, 1) : Matrix();
    Matrix images = left.columns() > 0 ? operators_->times(psi) : Matrix();
    leftOfMotions_ = std::make_unique<const LeftOfMotions>(LeftOfMotions{
        std::move(left), std::move(factor), std::move(psi), std::move(images)});
  }
  return *leftOfMotions_;
}

CompressedBody::Rest CompressedBody::restOf(const Matrix& images) const {
  Rest rest;
  double size = 0;
  for (Index i = range_.densities; i < range_.last; ++i) {
    rest.entries.push_back(images(i, 0) + images(i, 1));
    rest.size = std::max(rest.size, std::abs(rest.entries.back()));
    size = std::max(size, std::abs(images(i, 0)));
  }
  rest.size /= size > 0 ? size : 1;
  return rest;
}

void CompressedBody::takeMotions(const Rest& rest, Vector& psi, Matrix& images) const {
  const LeftOfMotions& all = leftOfMotions();
  Vector sizes;
  for (Index k = 0; k < all.left.columns(); ++k)
    sizes.push_back(dot(bem::columnOf(all.left, k), rest.entries));
  if (sizes.empty())
    return;
  bem::choleskySolve(all.factor, bem::MatrixView(sizes));
  for (Index k = 0; k < all.left.columns(); ++k) {
    for (Index i = 0; i < images.rows(); ++i)
      images(i, 1) += sizes[at(k)] * all.images(i, k);
    for (std::size_t i = 0; i < psi.size(); ++i)
      psi[i] += sizes[at(k)] * all.psi(range_.densities + static_cast<Index>(i), k);
  }
}

// A solution has its ψ with it: the last one's is tried first, taken where K u - (V + G) ψ vanishes,
// perhaps but for what rigid motions added to u leave of it, and corrected where only rounding is
// left.
const CompressedBody::Field& CompressedBody::fieldOf(const Vector& u) const {
  if (u == field_.u)
    return field_;
  Vector psi = solved_;
  psi.resize(at(range_.last - range_.densities));
  Matrix x(operators_->size(), 2);
  std::copy(u.begin(), u.end(), x.column(0) + range_.first);
  std::copy(psi.begin(), psi.end(), x.column(1) + range_.densities);
  Matrix images = operators_->times(x);
  double left = restOf(images).size;
  if (left > 1e-12 && left <= 1e-9) {
    takeMotions(restOf(images), psi, images);
    left = restOf(images).size;
  }
  if (left > 1e-12) {
    const bool isNear = left <= 1e-9;
    if (!isNear)
      std::fill(psi.begin(), psi.end(), 0.0);
    Matrix right(images.rows(), 1);
    for (Index i = 0; i < images.rows(); ++i)
      right(i, 0) = -images(i, 0) - (isNear ? images(i, 1) : 0);
    bem::axpy(1, densityFor(right, isNear ? 0 : 1), psi);
    const Matrix image = operators_->times(placed(psi));
    std::copy_n(image.data(), image.rows(), images.column(1));
  }
  field_ = {u, std::move(psi), std::move(images)};
  return field_;
}

}  // namespace epafi::contact
