// A body by compressed operators is the one by dense matrices: flexibility, displacement,
// reactions, and the linear systems of Newton's method.
#include "SerialAlgebra.hpp"
#include "Solve.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/operators/Assembly.hpp"
#include "contact/problem/CompressedBody.hpp"
#include "contact/problem/ContactProblem.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>

namespace epafi {

namespace {

using bem::at;
using bem::Index;
using bem::Vector;
using Form = contact::Stabilization::Form;

struct Case {
  std::string name;
  Form form;
  std::string basis;
  int degree;
  bool isClamped;
  contact::FrictionLaw::Kind friction;
};

}  // namespace

}  // namespace epafi
