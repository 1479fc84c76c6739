#include "adaptivity/refine/Strategy.hpp"

#include "adaptivity/mark/Doerfler.hpp"
#include "bem/base/Error.hpp"
#include "bem/basis/Legendre.hpp"

namespace epafi::adaptivity {

namespace {

Marks all(const LevelData& level, Mark mark) {
  Marks marks(static_cast<std::size_t>(level.mesh.size()), mark);
  return marks;
}

Marks nothing(const LevelData& level) { return all(level, Mark::None); }

Marks bisectAll(const LevelData& level) { return all(level, Mark::Bisect); }

Marks raiseAll(const LevelData& level) {
  Marks marks;
  for (const bem::Element& element : level.mesh.elements())
    marks.push_back(element.degree < bem::largestDegree ? Mark::RaiseDegree : Mark::None);
  return marks;
}

Marks bisectWorst(const LevelData& level) {
  Marks marks = nothing(level);
  for (const int e : doerfler(level.squares, level.markingFraction))
    marks[static_cast<std::size_t>(e)] = Mark::Bisect;
  return marks;
}

// [P Alg. 25]
Marks refineWorst(const LevelData& level) {
  Marks marks = nothing(level);
  for (const int e : doerfler(level.squares, level.markingFraction)) {
    const auto k = static_cast<std::size_t>(e);
    const bool raise = level.analytic[k] && level.mesh[e].degree < bem::largestDegree;
    marks[k] = raise ? Mark::RaiseDegree : Mark::Bisect;
  }
  return marks;
}

}  // namespace

Marks decide(const Strategy& strategy, const LevelData& level,
             const bem::DenseAlgebra& algebra) {
  bem::Vector numbers;
  for (const Mark mark : strategy.marks(level))
    numbers.push_back(static_cast<double>(mark));
  Marks marks;
  for (const double number : algebra.broadcast(std::move(numbers)))
    marks.push_back(static_cast<Mark>(static_cast<int>(number)));
  return marks;
}

const std::vector<Strategy>& strategies() {
  static const std::vector<Strategy> table = {
      {"None", "one level", Start::Zero, nothing},
      {"Uniform h", "halve all elements", Start::Zero, bisectAll},
      {"Uniform p", "raise all degrees", Start::Zero, raiseAll},
      {"Adaptive h", "halve the elements that carry most of the estimated error",
       Start::Carried, bisectWorst},
      {"Adaptive hp",
       "of these, raise the degree where the solution looks analytic, halve the others",
       Start::Carried, refineWorst},
  };
  return table;
}

const Strategy& strategy(const std::string& name) {
  std::string known;
  for (const Strategy& strategy : strategies()) {
    if (strategy.name == name)
      return strategy;
    known += (known.empty() ? "'" : ", '") + std::string(strategy.name) + "'";
  }
  throw bem::InputError(bem::message("strategy '", name, "'; known strategies: ", known));
}

}  // namespace epafi::adaptivity
