#include "contact/newton/Factoring.hpp"
#include "contact/newton/KeptFactor.hpp"

#include <algorithm>

namespace epafi::contact {

namespace {

std::vector<KeptFactor::Row> rowsOf(const Reduction& r) {
  std::vector<KeptFactor::Row> rows(at(r.n));
  for (const Index i : r.inactive)
    rows[at(i)].isSolved = true;
  r.forEachFollower([&](Index i, Index leader, double factor) {
    rows[at(i)].followed.push_back({leader, factor});
  });
  return rows;
}

/// G motionScale
Matrix scaledMotions(const Reduction& r) {
  Matrix motions = r.problem.rigid.copy();
  for (Index m = 0; m < r.k; ++m)
    std::transform(motions.column(m), motions.column(m) + r.n, motions.column(m),
                   [&](double g) { return g * r.motionScale[at(m)]; });
  return motions;
}

class ByKept final : public Factoring {
 public:
  ByKept(const Reduction& reduction, std::unique_ptr<const KeptFactor> factor)
      : r_(reduction), factor_(std::move(factor)) {}

  Vector solve(const Vector& b) const override {
    Vector right = r_.knownChanges(b);
    const Vector rows = r_.rightSides(b);
    for (Index p = 0; p < r_.count(); ++p)
      right[at(r_.inactive[at(p)])] = rows[at(p)];
    const Vector rest = r_.balance(b, Vector(at(r_.n), 0.0));
    right.insert(right.end(), rest.begin(), rest.end());
    Vector d = factor_->solve(right);
    for (Index m = 0; m < r_.k; ++m)
      d[at(r_.n + m)] *= r_.motionScale[at(m)];
    return d;
  }

 private:
  const Reduction& r_;
  std::unique_ptr<const KeptFactor> factor_;
};

}  // namespace

std::unique_ptr<const Factoring> keptFactoring(const Reduction& reduction,
                                               FactorMemory& memory) {
  if (reduction.loose.columns() > 0)
    return nullptr;
  auto factor = KeptFactor::make(reduction.problem.flexibility, scaledMotions(reduction),
                                 rowsOf(reduction), memory);
  return factor != nullptr ? std::make_unique<const ByKept>(reduction, std::move(factor))
                           : nullptr;
}

}  // namespace epafi::contact
