#include "contact/compressed/CompressedBody.hpp"

#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/compressed/CompressedHolding.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace epafi::contact {

using bem::dot;

namespace {

class CompressedBody final : public StabilisedBody {
 public:
  CompressedBody(const bem::Space& space,
                 std::shared_ptr<const bem::CompressedOperators> operators,
                 std::size_t number, Coupling coupling)
      : StabilisedBody(space, std::move(coupling)),
        operators_(std::move(operators)),
        number_(number),
        range_(operators_->range(number)) {}

  std::shared_ptr<const HeldStiffness> held(const Holding& holding) const override {
    return std::make_shared<const CompressedHolding>(*operators_, number_, holding,
                                                     solved_);
  }

  // f - (W u + K' ψ), ψ that of u
  Vector residual(const Vector& force, const Vector& u) const override {
    Vector rest = force;
    const Matrix& images = fieldOf(u).images;
    for (std::size_t i = 0; i < rest.size(); ++i)
      rest[i] -= images(range_.first + static_cast<Index>(i), 0) +
                 images(range_.first + static_cast<Index>(i), 1);
    return rest;
  }

  // (V + G)⁻¹ (K u - N λ)
  Vector density(const Vector& u, const Vector& multiplier) const override {
    Vector psi = fieldOf(u).psi;
    if (coupling_.byDensity() && !multiplier.empty())
      bem::axpy(-1, under(coupling_.weighted(multiplier)).psi, psi);
    return psi;
  }

  // 1/2 uᵀ W u + 1/2 ψᵀ V ψ from Z's products with u and ψ, -(V + G) there
  double strainEnergy(const Vector& u, const Vector& multiplier,
                      const ResidualTerms& terms) const override {
    Vector psi = density(u, multiplier);
    if (!terms.density.empty())
      bem::axpy(1, terms.density, psi);
    const Matrix& images = fieldOf(u).images;
    const auto work = [](const Vector& x, const Matrix& image, Index column,
                         Index first) {
      return std::inner_product(x.begin(), x.end(), image.column(column) + first, 0.0);
    };
    double twice =
        work(u, images, 0, range_.first) - work(psi, images, 1, range_.densities);
    if (coupling_.byDensity() && !multiplier.empty())
      twice +=
          work(psi, under(coupling_.weighted(multiplier)).image, 0, range_.densities);
    if (!terms.density.empty())
      twice -= dot(psi, terms.compliance);
    return 0.5 * (twice - coupling_.complianceWork(psi));
  }

 private:
  Vector tractionsOf(const Vector& u) const override {
    return coupling_.ofDensities(fieldOf(u).psi);
  }
  Vector forcesOf(const Vector& w) const override { return forcesIn(under(w).image); }
  Vector responsesTo(const Vector& w) const override {
    return coupling_.ofDensities(under(w).psi);
  }
  std::pair<Vector, Vector> answerTo(const Vector& compliance) const override {
    Vector psi = answer(compliance);
    Vector force = forcesIn(operators_->times(placed(psi)));
    return {std::move(psi), std::move(force)};
  }

  /// The displacements' rows.
  Vector forcesIn(const Matrix& image) const {
    return {image.data() + range_.first, image.data() + range_.densities};
  }
  /// A density among all unknowns.
  Matrix placed(const Vector& psi) const {
    Matrix x(operators_->size(), 1);
    std::copy(psi.begin(), psi.end(), x.data() + range_.densities);
    return x;
  }
  /// Of V + G: all displacements and multipliers held.
  const bem::CompressedFactor& densityFactor() const {
    if (densityFactor_ == nullptr) {
      bem::Restriction restriction;
      restriction.held.assign(at(operators_->size()), 1);
      std::fill(restriction.held.begin() + range_.densities,
                restriction.held.begin() + range_.last, 0);
      densityFactor_ = std::make_unique<const bem::CompressedFactor>(
          *operators_, restriction, std::vector<int>{});
    }
    return *densityFactor_;
  }

  /// (V + G)⁻¹ g
  Vector answer(const Vector& g) const {
    Vector psi = densityFor(placed(g), 1);
    for (double& x : psi)
      x = -x;
    return psi;
  }

  /// ψ = (V + G)⁻¹ E w and Z (0, ψ).
  struct Under {
    Vector weights;
    Vector psi;
    Matrix image;
  };
  /// The last one is kept.
  const Under& under(const Vector& weights) const {
    if (weights != under_.weights) {
      Vector psi = answer(coupling_.onDensities(weights, space_.densities()));
      Matrix image = operators_->times(placed(psi));
      under_ = {weights, std::move(psi), std::move(image)};
    }
    return under_;
  }

  /// The densities' rows solved, all else held: -(V + G)⁻¹ of them.
  Vector densityFor(const Matrix& right, int refinements) const {
    const Matrix psi = densityFactor().solve(right, refinements);
    return {psi.data() + range_.densities, psi.data() + range_.last};
  }

  /// Z (u, 0) and Z (0, ψ)
  Matrix imagesOf(const Vector& u, const Vector& psi) const {
    Matrix x(operators_->size(), 2);
    std::copy(u.begin(), u.end(), x.column(0) + range_.first);
    std::copy(psi.begin(), psi.end(), x.column(1) + range_.densities);
    return operators_->times(x);
  }

  /// A displacement, its ψ without a multiplier, and imagesOf both.
  struct Field {
    Vector u;
    Vector psi;
    Matrix images;
  };

  /// What rigid motions r leave in compressed operators, Z (r, 0) in the densities' rows, its Gram
  /// matrix factored, the ψ that takes it away, and Z (0, ψ).  No columns: nothing.
  struct Motions {
    Matrix left;
    Matrix factor;
    Matrix psi;
    Matrix images;
  };
  const Motions& motions() const {
    if (motions_ == nullptr) {
      const Matrix modes = makeRigidModes(space_).motions;
      Matrix moved(operators_->size(), modes.columns());
      for (Index k = 0; k < modes.columns(); ++k)
        std::copy_n(modes.column(k), modes.rows(), moved.column(k) + range_.first);
      Matrix left =
          bem::rowsBetween(operators_->times(moved), range_.densities, range_.last);
      Matrix right(operators_->size(), modes.columns());
      for (Index k = 0; k < left.columns(); ++k)
        for (Index i = 0; i < left.rows(); ++i)
          right(range_.densities + i, k) = -left(i, k);
      Matrix factor = bem::transposedTimes(left, left);
      if (bem::cholesky(factor) != 0)
        left = Matrix();
      Matrix psi = left.columns() > 0 ? densityFactor().solve(right, 1) : Matrix();
      Matrix images = left.columns() > 0 ? operators_->times(psi) : Matrix();
      motions_ = std::make_unique<const Motions>(
          Motions{std::move(left), std::move(factor), std::move(psi), std::move(images)});
    }
    return *motions_;
  }

  /// K u - (V + G) ψ from the images of both, and its largest entry over that of K u.
  struct Rest {
    Vector entries;
    double size = 0;
  };
  Rest restOf(const Matrix& images) const {
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

  /// Takes off the rest what rigid motions have added to it.
  void takeMotions(const Rest& rest, Vector& psi, Matrix& images) const {
    const Motions& all = motions();
    Vector sizes;
    for (Index k = 0; k < all.left.columns(); ++k)
      sizes.push_back(dot(bem::columnOf(all.left, k), rest.entries));
    if (sizes.empty())
      return;
    bem::choleskySolve(all.factor, sizes.data());
    for (Index k = 0; k < all.left.columns(); ++k) {
      for (Index i = 0; i < images.rows(); ++i)
        images(i, 1) += sizes[at(k)] * all.images(i, k);
      for (std::size_t i = 0; i < psi.size(); ++i)
        psi[i] += sizes[at(k)] * all.psi(range_.densities + static_cast<Index>(i), k);
    }
  }

  /// That of u; the last one is kept, which several results ask for.  A solution has its ψ
  /// with it: the last one's is tried first, taken where K u - (V + G) ψ vanishes, perhaps but for
  /// what rigid motions added to u leave of it, and corrected where only rounding is left.
  const Field& fieldOf(const Vector& u) const {
    if (u == field_.u)
      return field_;
    Vector psi = solved_;
    psi.resize(at(range_.last - range_.densities));
    Matrix images = imagesOf(u, psi);
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

  std::shared_ptr<const bem::CompressedOperators> operators_;
  std::size_t number_;
  const bem::CompressedOperators::Range& range_;
  mutable std::unique_ptr<const bem::CompressedFactor> densityFactor_;
  mutable std::unique_ptr<const Motions> motions_;
  mutable Vector solved_;  ///< ψ of the last solution
  mutable Field field_;
  mutable Under under_;
};

}  // namespace

std::unique_ptr<const StabilisedBody> makeCompressedBody(
    const BodyInput& input, const MultiplierSpace& multiplier) {
  return std::make_unique<const CompressedBody>(
      input.space, input.stiffness.compressed(), input.stiffness.compressedBody(),
      makeCoupling(input.space, multiplier, input.stabilization, input.lame,
                   input.units));
}

}  // namespace epafi::contact
