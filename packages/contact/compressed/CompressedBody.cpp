#include "contact/compressed/CompressedBody.hpp"

#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/body/ElementCoupling.hpp"
#include "contact/compressed/CompressedCoupling.hpp"
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
      : StabilisedBody(std::move(coupling)),
        space_(space),
        operators_(std::move(operators)),
        number_(number),
        range_(operators_->range(number)) {
    compressed_.multipliers = coupling_.multipliers;
    compressed_.addOwn(space, coupling_, number, range_.first, [](Index i) { return i; });
  }

  std::shared_ptr<const HeldStiffness> held(const Holding& holding) const override {
    return std::make_shared<const Held>(*this, holding);
  }

  // f - (W u + K' ψ), ψ = (V + G)⁻¹ K u
  Vector residual(const Vector& force, const Vector& u) const override {
    Vector rest = force;
    const Matrix& images = fieldOf(u).images;
    for (std::size_t i = 0; i < rest.size(); ++i)
      rest[i] -= images(range_.first + static_cast<Index>(i), 0) +
                 images(range_.first + static_cast<Index>(i), 1);
    return rest;
  }

  Vector push(const Vector& multiplier) const override {
    Matrix x(operators_->size(), 1);
    compressed_.push(1, multiplier.data(), x.data());
    if (byDensity()) {
      // K' ψ, ψ = -(V + G)⁻¹ N λ
      const Matrix& image = under(multiplier).image;
      for (Index i = range_.first; i < range_.densities; ++i)
        x(i, 0) += image(i, 0);
    }
    for (const bem::Entry& entry : coupling_.completion)
      x(range_.first + entry.row, 0) += entry.value * multiplier[at(entry.column)];
    Vector force(x.data() + range_.first, x.data() + range_.densities);
    if (coupling_.rotation != nullptr)
      coupling_.rotation->complete(dot(coupling_.completionOfRotation, multiplier),
                                   force);
    return force;
  }

  Vector pull(const Vector& u) const override {
    const Matrix x = placed(u, byDensity() ? fieldOf(u).psi : Vector());
    return compressed_.pull(x.data());
  }

  // Ĉ (u, ψ) - M₀ λ, M₀ the local part of M; ψ contains the rest of M λ
  Vector contactTerms(const Vector& u, const Vector& multiplier) const override {
    const Matrix x = placed(u, byDensity() ? density(u, multiplier) : Vector());
    Vector terms = compressed_.pull(x.data());
    for (const bem::Entry& entry : compressed_.mass)
      terms[at(entry.row)] -= entry.value * multiplier[at(entry.column)];
    return terms;
  }

  double multiplierWork(const Vector& multiplier) const override {
    const double work = coupling_.multiplierWork(multiplier);
    if (!byDensity())
      return work;
    // minus (N λ)ᵀ (V + G)⁻¹ N λ
    Matrix pushed(operators_->size(), 1);
    compressed_.push(1, multiplier.data(), pushed.data());
    const Vector& psi = under(multiplier).psi;
    return work - std::inner_product(psi.begin(), psi.end(),
                                     pushed.data() + range_.densities, 0.0);
  }

  // (V + G)⁻¹ (K u - N λ)
  Vector density(const Vector& u, const Vector& multiplier) const override {
    Vector psi = fieldOf(u).psi;
    if (byDensity() && !multiplier.empty())
      bem::axpy(1, under(multiplier).psi, psi);
    return psi;
  }

  // 1/2 uᵀ W u + 1/2 ψᵀ V ψ by products with Z, whose block of densities is -(V + G)
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
    if (byDensity() && !multiplier.empty())
      twice -= work(psi, under(multiplier).image, 0, range_.densities);
    if (!terms.density.empty())
      twice -= dot(psi, terms.compliance);
    return 0.5 * (twice - coupling_.complianceWork(psi));
  }

  ResidualTerms residualTerms(const MultiplierSpace& multiplier) const override {
    const Inside& inside = multiplier.conditions().inside;
    if (!inside)
      return {};
    const TractionMoments moments =
        tractionMoments(space_, multiplier, true, coupling_, *inside);
    ResidualTerms terms;
    terms.compliance = coupling_.complianceOf(space_, moments.weights, *inside);
    Matrix right(operators_->size(), 1);
    std::copy(terms.compliance.begin(), terms.compliance.end(),
              right.data() + range_.densities);
    terms.density = densityFor(right, 1);
    const Matrix image = operators_->times(placed({}, terms.density));
    for (Index i = range_.first; i < range_.densities; ++i)
      terms.force.push_back(-image(i, 0));
    terms.terms.assign(moments.multipliers.size(), 0.0);
    bem::axpy(-1, moments.multipliers, terms.terms);
    coupling_.subtractWeighted(terms.density, terms.terms);
    return terms;
  }

 private:
  class Held final : public HeldStiffness {
   public:
    Held(const CompressedBody& body, const Holding& holding)
        : body_(body),
          holding_(holding),
          held_(std::make_shared<const CompressedHolding>(*body.operators_, body.number_,
                                                          holding)),
          range_(body.range_) {}

    // A⁺ f + R Rᵀ f
    Vector solve(const Vector& force) const override {
      Matrix forces(held_->operators().size(), 1);
      std::copy(force.begin(), force.end(), forces.data() + range_.first);
      const Matrix x = held_->displaced(std::move(forces));
      body_.solved_.assign(x.data() + range_.densities, x.data() + range_.last);
      Vector u(x.data() + range_.first, x.data() + range_.densities);
      for (Index k = 0; k < holding_.rigid.allowed.columns(); ++k) {
        const Vector r = columnOf(holding_.rigid.allowed, k);
        bem::axpy(dot(r, force), r, u);
      }
      return u;
    }
    std::shared_ptr<const CompressedHolding> compressed() const override { return held_; }

   private:
    const CompressedBody& body_;
    const Holding& holding_;
    std::shared_ptr<const CompressedHolding> held_;
    const bem::CompressedOperators::Range& range_;
  };

  /// (u, ψ) as a vector of all unknowns; empty: zero.
  Matrix placed(const Vector& u, const Vector& psi) const {
    Matrix x(operators_->size(), 1);
    std::copy(u.begin(), u.end(), x.data() + range_.first);
    std::copy(psi.begin(), psi.end(), x.data() + range_.densities);
    return x;
  }
  /// Factor of V + G: all displacements and multipliers are held.
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

  /// ψ = -(V + G)⁻¹ N λ and Z (0, ψ).
  struct Under {
    Vector multiplier;
    Vector psi;
    Matrix image;
  };
  /// Caches the last one.
  const Under& under(const Vector& multiplier) const {
    if (multiplier != under_.multiplier) {
      Matrix right(operators_->size(), 1);
      compressed_.push(-1, multiplier.data(), right.data());
      Vector psi = densityFor(right, 1);
      Matrix image = operators_->times(placed({}, psi));
      under_ = {multiplier, std::move(psi), std::move(image)};
    }
    return under_;
  }

  /// -(V + G)⁻¹ b, b: the density rows of `right`.
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

  /// Error of compression in rigid motions r, which K maps to zero: `left`, the density
  /// rows of Z (r, 0), the factor of its Gram matrix, ψ = (V + G)⁻¹ left and Z (0, ψ).
  /// Without columns: no error.
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

  /// K u - (V + G) ψ by the images of both, and its largest entry over that of K u.
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

  /// Removes from the residual its least squares fit by the errors of rigid motions.
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

  /// Field of u, cached.  First tries the ψ of the last solution: it is accepted if
  /// K u - (V + G) ψ vanishes, possibly after takeMotions() (u may contain added rigid
  /// motions); corrected if the relative residual is at most 1e-9; else computed.
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
      const Matrix image = operators_->times(placed({}, psi));
      std::copy_n(image.data(), image.rows(), images.column(1));
    }
    field_ = {u, std::move(psi), std::move(images)};
    return field_;
  }

  const bem::Space& space_;
  std::shared_ptr<const bem::CompressedOperators> operators_;
  std::size_t number_;
  const bem::CompressedOperators::Range& range_;
  CompressedCoupling compressed_;  ///< of the multiplier of this body
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
      makeLocalCoupling(input.space, multiplier, input.stabilization, input.lame,
                        input.units));
}

}  // namespace epafi::contact
