#include "bem/algebra/LuFactor.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/newton/Factoring.hpp"

#include <algorithm>

namespace epafi::contact {

using bem::dot;

namespace {

class ByOperator final : public Factoring {
 public:
  explicit ByOperator(const Reduction& reduction)
      : r_(reduction), responses_(reduction.n, reduction.held.columns()) {
    Flexibility::Operator::System system;
    system.rows = r_.inactive;
    r_.forEachFollower([&](Index i, Index leader, double factor) {
      system.followers.push_back({i, leader, factor});
    });
    factor_ = r_.problem.flexibility.factor(system);

    const Index held = responses_.columns();
    Matrix schur(held, held);
    for (Index j = 0; j < held; ++j) {
      Vector right;
      for (const Index i : r_.inactive)
        right.push_back(r_.heldEntry(i, j));
      const Vector solved = factor_->solve(right, Vector(at(r_.n), 0.0));
      std::copy(solved.begin(), solved.end(), responses_.column(j));
      for (Index l = 0; l < held; ++l)
        schur(l, j) = forceOn(l, solved);
    }
    schur_ = bem::LuFactor(std::move(schur));
    if (!schur_.isRegular())
      throw SingularJacobian(
          "singular Newton matrix: nothing balances the rigid motions");
  }

  Vector solve(const Vector& b) const override {
    const Vector known = r_.knownChanges(b);
    Vector d = factor_->solve(r_.rightSides(b), known);
    Vector added = d;
    for (Index i = 0; i < r_.n; ++i)
      added[at(i)] -= known[at(i)];
    const Vector rest = r_.balance(b, known);
    Vector sizes;
    for (Index j = 0; j < responses_.columns(); ++j)
      sizes.push_back(dot(columnOf(r_.held, j), rest) - forceOn(j, added));
    schur_.solve(sizes);
    for (Index j = 0; j < responses_.columns(); ++j)
      for (Index i = 0; i < r_.n; ++i)
        d[at(i)] += sizes[at(j)] * responses_(i, j);
    r_.appendMotions(sizes.data(), d);
    return d;
  }

 private:
  /// The work of a multiplier on a held motion.
  double forceOn(Index motion, const Vector& multiplier) const {
    double sum = 0;
    for (Index i = 0; i < r_.n; ++i)
      if (multiplier[at(i)] != 0)
        sum += r_.heldEntry(i, motion) * multiplier[at(i)];
    return sum;
  }

  const Reduction& r_;
  std::unique_ptr<Flexibility::Operator::Factor> factor_;
  Matrix responses_;  // to the held motions, all coefficients
  bem::LuFactor schur_;
};

}  // namespace

std::unique_ptr<const Factoring> operatorFactoring(const Reduction& reduction) {
  return std::make_unique<const ByOperator>(reduction);
}

}  // namespace epafi::contact
