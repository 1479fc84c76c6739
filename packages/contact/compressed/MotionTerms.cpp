#include "contact/compressed/MotionTerms.hpp"

#include <algorithm>
#include <numeric>

namespace epafi::contact {

MotionTerms::MotionTerms(
    const CompressedCoupling& coupling,
    const std::vector<std::shared_ptr<const CompressedHolding>>& bodies) {
  Index r = 0;
  for (const auto& body : bodies)
    r += body->motions();
  if (r == 0)
    return;
  u = Matrix(coupling.multipliers, 2 * r);
  inverse = Matrix(2 * r, 2 * r);
  Index first = 0;  // of the body's
  for (const auto& body : bodies) {
    const Index count = body->motions();
    Matrix forces(body->operators().size(), count);
    for (Index k = 0; k < count; ++k) {
      const Vector c = body->functional(k);
      std::copy(c.begin(), c.end(), forces.column(k));
    }
    const Matrix answers = body->factor().solve(forces);
    for (Index k = 0; k < count; ++k) {
      const Vector g = coupling.pull(body->motion(k).data());
      const Vector w = coupling.pull(answers.column(k));
      std::copy(g.begin(), g.end(), u.column(first + k));
      std::copy(w.begin(), w.end(), u.column(r + first + k));
      inverse(first + k, r + first + k) = -1;
      inverse(r + first + k, first + k) = -1;
      for (Index l = 0; l < count; ++l)
        for (Index i = 0; i < forces.rows(); ++i)
          inverse(r + first + l, r + first + k) -= forces(i, l) * answers(i, k);
    }
    first += count;
  }
}

Vector MotionTerms::seen(const double* x) const {
  Vector sums;
  for (Index j = 0; j < u.columns(); ++j)
    sums.push_back(std::inner_product(u.column(j), u.column(j) + u.rows(), x, 0.0));
  return sums;
}

Vector MotionTerms::scaled(const Vector& sums) const {
  const Index r = u.columns() / 2;
  Vector result(sums.size());
  for (Index j = 0; j < r; ++j) {
    result[at(j)] = -sums[at(r + j)];
    result[at(r + j)] = -sums[at(j)];
    for (Index l = 0; l < r; ++l)
      result[at(j)] -= inverse(r + j, r + l) * sums[at(l)];
  }
  return result;
}

}  // namespace epafi::contact
