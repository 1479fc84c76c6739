#include "adaptivity/refine/Strategy.hpp"

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

}  // namespace

const std::vector<Strategy>& strategies() {
  static const std::vector<Strategy> table = {
      {"None", "one level", Start::Zero, nothing},
      {"Uniform h", "halve all elements", Start::Zero, bisectAll},
      {"Uniform p", "raise all degrees", Start::Zero, raiseAll},
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
