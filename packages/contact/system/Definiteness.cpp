#include "contact/system/Definiteness.hpp"

#include "bem/algebra/DenseAlgebra.hpp"
#include "contact/system/ContactProblem.hpp"

#include <Teuchos_LAPACK.hpp>

#include <algorithm>
#include <limits>

namespace epafi::contact {

namespace {

double largestEigenvalue(Matrix symmetric) {
  const int n = bem::asInt(symmetric.rows());
  Vector values(n);
  Vector work(std::max(1, 34 * n));
  int info = 0;
  Teuchos::LAPACK<int, double>().SYEV('N', 'L', n, symmetric.data(),
                                      bem::asInt(symmetric.stride()), values.data(),
                                      work.data(), static_cast<int>(work.size()), &info);
  return info == 0 && n > 0 ? values.back() : 0;
}

}  // namespace

IndefiniteStiffness::IndefiniteStiffness(double used, double limit)
    : bem::NumericalError(
          "the stabilised stiffness S - S^ is not positive "
          "definite: Discretization->Stabilization->",
          "Gamma0 = ", used, " is too large for this mesh; below ", limit,
          " it is definite, and a quarter of that is safe"),
      gamma0(used),
      limitGamma0(limit) {}

double limitGamma0(const BodyInput& input, const StabilisedBody& form,
                   const Holding& holding) {
  Matrix half = form.subtracted();
  const Index columns = half.columns();
  if (columns == 0)
    return std::numeric_limits<double>::infinity();
  const auto stiffness = form.weakened(0)->held(holding);  // S
  const Matrix reduced = stiffness->forward(std::move(half));
  return input.stabilization.firstGamma0() /
         largestEigenvalue(addGram(Matrix(columns, columns), reduced));
}

double limitGamma0(const BodyInput& input) {
  const MultiplierSpace multiplier(input.space.mesh(), input.basis, input.conditions);
  return limitGamma0(input, *makeStabilisedBody(input, multiplier),
                     makeHolding(input.space, input.conditions, input.units));
}

}  // namespace epafi::contact
