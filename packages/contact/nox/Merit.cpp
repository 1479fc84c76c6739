#include "contact/nox/Merit.hpp"

#include "contact/nox/Group.hpp"
#include "contact/solve/Descent.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace epafi::contact {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

const Group& ours(const NOX::Abstract::Group& group) {
  return dynamic_cast<const Group&>(group);
}

void assign(NOX::Abstract::Vector& to, const Vector& from) {
  auto& dense = dynamic_cast<NOX::LAPACK::Vector&>(to);
  for (std::size_t i = 0; i < from.size(); ++i)
    dense(static_cast<int>(i)) = from[i];
}

/// E(λ) = ½ λᵀDλ - d₀ᵀλ at the projection of λ onto the box.
class Energy final : public Merit {
 public:
  double computef(const NOX::Abstract::Group& group) const override {
    const Equation& equation = ours(group).equation();
    return equation.energy(inBox(ours(group)));
  }

  void computeGradient(const NOX::Abstract::Group& group,
                       NOX::Abstract::Vector& result) const override {
    const Equation& equation = ours(group).equation();
    Vector gradient = inBox(ours(group)).penetration;  // -r = D λ - d₀
    for (std::size_t i = 0; i < gradient.size(); ++i)
      gradient[i] /= -equation.weights()[i];
    assign(result, gradient);
  }

  // E is quadratic: its change is the step times the mean of the two gradients.
  double change(const Group& from, const Group& to) const override {
    const Evaluation a = inBox(from);
    const Evaluation b = inBox(to);
    const Vector& weights = from.equation().weights();
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i)
      sum -= 0.5 * (b.unknowns[i] - a.unknowns[i]) *
             (a.penetration[i] + b.penetration[i]) / weights[i];
    return sum;
  }

  double rounding(const Group& from, const Group& to) const override {
    const Vector& offset = from.equation().problem().offset;
    const Vector a = numbers(from.getX());
    const Vector b = numbers(to.getX());
    double sum = 0;
    for (std::size_t i = 0; i < offset.size(); ++i)
      sum += std::abs((b[i] - a[i]) * offset[i]);
    return 16 * eps * sum;
  }

  const std::string& name() const override { return name_; }

 private:
  static Evaluation inBox(const Group& group) {
    const Vector x = numbers(group.getX());
    Vector projection = projectOntoBox(group.equation().problem(), x);
    return group.isF() && projection == x ? group.evaluation()
                                          : group.equation().at(std::move(projection));
  }

  std::string name_ = "energy of the quadratic programme";
};

/// ½ |F|² with Fischer-Burmeister's function.
class SquaredResidual final : public Merit {
 public:
  double computef(const NOX::Abstract::Group& group) const override {
    return ours(group).equation().merit(evaluate(ours(group)));
  }

  void computeGradient(const NOX::Abstract::Group& group,
                       NOX::Abstract::Vector& result) const override {
    assign(result, ours(group).equation().meritGradient(evaluate(ours(group))));
  }

  double change(const Group& from, const Group& to) const override {
    return computef(to) - computef(from);
  }

  double rounding(const Group& from, const Group&) const override {
    return 16 * eps * computef(from);
  }

  const std::string& name() const override { return name_; }

 private:
  static Evaluation evaluate(const Group& group) {
    return group.isF() ? group.evaluation() : group.equation().at(numbers(group.getX()));
  }

  std::string name_ = "half the squared Fischer-Burmeister residual";
};

}  // namespace

double Merit::computeSlope(const NOX::Abstract::Vector& direction,
                           const NOX::Abstract::Group& group) const {
  const auto gradient = direction.clone(NOX::ShapeCopy);
  computeGradient(group, *gradient);
  return gradient->innerProduct(direction);
}

double Merit::computeQuadraticModel(const NOX::Abstract::Vector&,
                                    const NOX::Abstract::Group&) const {
  throw std::logic_error("only trust regions use a quadratic model");
}

void Merit::computeQuadraticMinimizer(const NOX::Abstract::Group&,
                                      NOX::Abstract::Vector&) const {
  throw std::logic_error("only trust regions use a quadratic model");
}

Teuchos::RCP<const Merit> makeMerit(const Equation& equation, NewtonMethod method) {
  const Problem& problem = equation.problem();
  const bool quadratic = problem.rigidMotions() == 0 && !problem.boundDependsOnPressure();
  if (quadratic && method != NewtonMethod::MeritDescent)
    return Teuchos::rcp(new Energy);
  return Teuchos::rcp(new SquaredResidual);
}

}  // namespace epafi::contact
