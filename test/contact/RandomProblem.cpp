#include "contact/RandomProblem.hpp"

#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <cmath>

namespace epafi::test {

using contact::Index;
using contact::Matrix;
using contact::Problem;
using contact::Vector;

namespace {

double draw(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

// A kernel of the boundary element method's kind, plus a Gram matrix of random vectors
// that couples everything with everything.
Matrix randomFlexibility(const Problem& problem, const Recipe& recipe,
                         std::mt19937& random) {
  const Index n = problem.size();
  std::normal_distribution<double> normal;
  Vector places;
  Vector sizes;
  for (Index i = 0; i < n; ++i) {
    places.push_back(draw(random, -1, 1));
    sizes.push_back(std::pow(recipe.grading, -draw(random, 0, 1)));
  }
  const Index rank = std::max<Index>(1, n);
  Matrix factors(rank, n);
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < rank; ++i)
      factors(i, j) = normal(random) / std::sqrt(static_cast<double>(rank));
  Matrix d(n, n);
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const double apart = places[i] - places[j];
      const bool alike = (i < problem.normals) == (j < problem.normals);
      double value = alike ? std::exp(-4 * std::abs(apart)) : 0.0;
      for (Index k = 0; k < rank; ++k)
        value += 0.5 * factors(k, i) * factors(k, j);
      if (i == j)
        value += recipe.softness;
      d(i, j) = value * sizes[i] * sizes[j];
    }
  return d;
}

void addRigidMotions(Problem& problem, Index count, std::mt19937& random) {
  const Index n = problem.size();
  problem.rigid = Matrix(n, count);
  for (Index i = 0; i < n; ++i) {
    const double weight = std::sqrt(problem.flexibility(i, i));
    for (Index j = 0; j < count; ++j) {
      const bool normal = i < problem.normals;
      const double component[3] = {normal ? 1.0 : 0.0, normal ? draw(random, -1, 1) : 0.3,
                                   normal ? 0.2 : 1.0};
      problem.rigid(i, j) = weight * component[j];
    }
  }
  // The resultant of some admissible multiplier.
  Vector admissible;
  for (Index i = 0; i < problem.normals; ++i)
    admissible.push_back(draw(random, 0, 1));
  const Vector bounds = problem.slipBounds(admissible);
  for (const double bound : bounds) {
    const double s = std::isfinite(bound) ? bound : 1;
    admissible.push_back(0.5 * draw(random, -s, s));
  }
  for (Index j = 0; j < count; ++j) {
    double sum = 0;
    for (Index i = 0; i < n; ++i)
      sum += problem.rigid(i, j) * admissible[i];
    problem.rigidLoad.push_back(sum);
  }
}

// Of all but every tenth place; shear by pairs of places that act on each other.
void addSurface(Problem& problem, const Recipe& recipe, std::mt19937& random) {
  for (Index i = 0; i < problem.normals; ++i)
    if (i % 10 != 9)
      problem.surface.places.push_back(
          {i, 1,
           pointClosing(recipe.normal, recipe.yield * problem.flexibility(i, i) *
                                           std::pow(10, -draw(random, 0, 2)))});
  for (Index i = problem.normals; i + 1 < problem.size(); i += 4) {
    const double c = recipe.yield * std::sqrt(problem.flexibility(i, i) *
                                              problem.flexibility(i + 1, i + 1));
    for (const bem::Entry& entry :
         {bem::Entry{i, i, c}, bem::Entry{i, i + 1, -0.4 * c},
          bem::Entry{i + 1, i, -0.4 * c}, bem::Entry{i + 1, i + 1, c}})
      problem.surface.linear.push_back(entry);
  }
}

}  // namespace

Problem randomProblem(const Recipe& recipe, std::mt19937& random) {
  Problem problem;
  problem.normals = recipe.normals;
  if (recipe.law != std::string("None"))
    for (Index i = 0; i < recipe.normals; ++i)
      problem.tangentials.emplace_back(
          i, test::pointLaw(
                 recipe.law,
                 {draw(random, 0, 1) < 0.2 ? 0.0 : draw(random, 0, recipe.strength)}));
  for (std::size_t t = 0; t < problem.tangentials.size() && recipe.bonded; t += 3)
    problem.tangentials[t] = contact::Tangential::tied();
  problem.flexibility = randomFlexibility(problem, recipe, random);
  for (Index i = 0; i < problem.size(); ++i) {
    const double value =
        recipe.ties ? std::floor(draw(random, -1, 2)) : draw(random, -1, 1.5);
    problem.offset.push_back(value * std::sqrt(problem.flexibility(i, i)));
  }
  problem.rigid = Matrix(problem.size(), 0);
  if (recipe.rigidMotions > 0)
    addRigidMotions(problem, recipe.rigidMotions, random);
  if (recipe.normal != std::string("Rigid"))
    addSurface(problem, recipe, random);
  for (Index j = 0; j < recipe.rigidMotions && recipe.springs > 0; ++j)
    problem.rigidStiffness.push_back(
        std::pow(10, draw(random, -recipe.springs, recipe.springs)));
  return problem;
}

Problem block(double coefficient, const Vector& load) {
  Problem problem;
  problem.normals = 2;
  for (const Index i : {0, 1})
    problem.tangentials.emplace_back(i, pointLaw("Coulomb", {coefficient}));
  problem.flexibility = identity(4);
  problem.offset = {0, 0, 0, 0};
  problem.rigid = Matrix(4, 2);
  problem.rigid(0, 0) = problem.rigid(1, 0) = 1;
  problem.rigid(2, 1) = problem.rigid(3, 1) = 1;
  problem.rigidLoad = load;
  return problem;
}

contact::PointClosing pointClosing(const std::string& law, double slope) {
  Teuchos::ParameterList list;
  list.set("Law", law == "Root" || law == "Square" ? "Power" : law);
  list.set("Exponent", law == "Root" ? 0.5 : 2.0);
  const double exponent = list.get<double>("Exponent");
  const contact::Normal normal =
      contact::parseNormal(list, [&](const std::string& key) -> bem::Function {
        const double value = law == "Linear"        ? slope
                             : key == "Pressure"    ? (law == "Exponential" ? 0.01 : 1)
                             : law == "Exponential" ? 1.01 * slope
                                                    : slope / exponent;
        return [value](bem::Vec2) { return value; };
      });
  return normal.at({}, {});
}

contact::PointLaw pointLaw(const std::string& law, const contact::Vector& fields) {
  std::vector<bem::Function> functions;
  for (const double value : fields)
    functions.push_back([value](bem::Vec2) { return value; });
  return contact::makeFriction(law, std::move(functions)).at({}, 1);
}

Matrix identity(Index size, double value) {
  Matrix d(size, size);
  for (Index i = 0; i < size; ++i)
    d(i, i) = value;
  return d;
}

}  // namespace epafi::test
