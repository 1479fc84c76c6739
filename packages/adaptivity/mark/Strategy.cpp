#include "adaptivity/mark/Strategy.hpp"

#include "bem/basis/Legendre.hpp"

#include <algorithm>

namespace epafi::adaptivity {

namespace {

Marks all(const LevelData& level, const Mark& mark) {
  return Marks(level.mesh.size(), mark);
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
  for (const int e : level.worst)
    marks[e] = Mark::Bisect;
  return marks;
}

// [P Alg. 25]
Marks refineWorst(const LevelData& level) {
  Marks marks = nothing(level);
  for (const int e : level.worst) {
    const bool raise = level.analytic[e] && level.mesh[e].degree < bem::largestDegree;
    marks[e] = raise ? Mark::RaiseDegree : Mark::Bisect;
  }
  return marks;
}

/// Degrees that run away from a neighbour's gain nothing: the neighbour's coarse density
/// jumps at the common node, and its field there is what the larger element is marked
/// for.
Marks withNeighbours(const bem::Mesh& mesh, Marks marks) {
  constexpr int mostApart = 2;
  const auto follow = [&](int from, int e) {
    Mark& mark = marks[e];
    if (mark == Mark::None && mesh[from].degree + 1 - mesh[e].degree > mostApart)
      mark = Mark::RaiseDegree;
  };
  const Marks chosen = marks;
  for (int e = 0; e < mesh.size(); ++e)
    if (chosen[e] == Mark::RaiseDegree) {
      follow(e, mesh[e].previous);
      follow(e, mesh[e].next);
    }
  return marks;
}

Marks gradeWorst(const LevelData& level) {
  Marks marks = nothing(level);
  for (const int e : level.worst)
    marks[e] =
        gradedMark(level.mesh, e, level.singular, level.analytic[e], level.grading);
  return withNeighbours(level.mesh, std::move(marks));
}

/// A mark as numbers, and back.
void write(const Mark& mark, bem::Vector& numbers) {
  numbers.push_back(mark.kind());
  numbers.push_back(static_cast<double>(mark.places().size()));
  numbers.insert(numbers.end(), mark.places().begin(), mark.places().end());
  numbers.insert(numbers.end(), mark.degrees().begin(), mark.degrees().end());
}

Mark read(const double*& numbers) {
  const auto kind = static_cast<Mark::Kind>(static_cast<int>(*numbers++));
  const auto count = static_cast<int>(*numbers++);
  if (kind != Mark::Cut)
    return kind;
  std::vector<double> places(numbers, numbers + count);
  numbers += count;
  std::vector<int> degrees(numbers, numbers + count + 1);
  numbers += count + 1;
  return Mark::cut(std::move(places), std::move(degrees));
}

}  // namespace

SingularPoints singularPoints(const Strategy& strategy, const GradingOptions& options,
                              const bem::Mesh& mesh,
                              const contact::Conditions& conditions,
                              const contact::MultiplierSpace& multiplier,
                              std::size_t body,
                              const std::vector<contact::ContactStates>& states) {
  if (strategy.grading == Grading::Ignored ||
      !transitions().at(options.transitions).areSingular)
    return findSingularPoints(mesh, conditions);
  std::vector<SingularPoints> all;
  all.reserve(states.size());
  for (const contact::ContactStates& state : states)
    all.push_back(findSingularPoints(mesh, conditions, multiplier, body, state));
  return united(all);
}

Marks decide(const Strategy& strategy, const LevelData& level,
             const bem::Processes& processes) {
  bem::Vector numbers;
  for (const Mark& mark : withoutShort(level.mesh, strategy.marks(level)))
    write(mark, numbers);
  const bem::Vector agreed = processes.broadcast(std::move(numbers));
  Marks marks;
  for (const double* next = agreed.data(); next != agreed.data() + agreed.size();)
    marks.push_back(read(next));
  return marks;
}

bem::Family<Strategy>& strategies() {
  static bem::Family<Strategy> family(
      "strategy",
      {
          {"None", "one level", Levels::One, Start::Zero, Grading::Ignored, nothing},
          {"Uniform h", "halve all elements", Levels::Many, Start::Zero, Grading::Ignored,
           bisectAll},
          {"Uniform p", "raise all degrees", Levels::Many, Start::Zero, Grading::Ignored,
           raiseAll},
          {"Adaptive h", "halve the elements that carry most of the estimated error",
           Levels::Many, Start::Carried, Grading::Ignored, bisectWorst},
          {"Adaptive hp",
           "of these, raise the degree where the solution looks analytic, halve the "
           "others",
           Levels::Many, Start::Carried, Grading::Ignored, refineWorst},
          {"Graded hp",
           "of these, cut next to singular points toward them and raise the degree "
           "elsewhere, see Grading",
           Levels::Many, Start::Carried, Grading::Obeyed, gradeWorst},
      });
  return family;
}

void StrategyOptions::keys(bem::Keys& keys) {
  keys.add(&name, "Strategy", strategies(), "");
  keys.add(&markingFraction, "Marking Fraction", "1", {0, 1, true, false},
           "adaptive strategies refine the fewest elements that carry this part of the "
           "squared estimate");
  keys.add(&analyticityThreshold, "Analyticity Threshold", "1", {0, 1, true, true},
           "Adaptive hp raises the degree where Legendre coefficients decay at least "
           "this fast from one degree to the next");
  keys.add(&grading, bem::Row("Grading", bem::Kind::List, "what Graded hp does"));
}

std::vector<int> doerfler(const bem::Vector& squares, double fraction) {
  constexpr double tie = 1e-5;
  bem::Vector sorted = squares;
  std::sort(sorted.begin(), sorted.end(), std::greater<>());
  // summed from the small ones: the total is then reached exactly when fraction is 1
  bem::Vector tails(sorted.size() + 1, 0.0);
  for (std::size_t k = sorted.size(); k-- > 0;)
    tails[k] = tails[k + 1] + sorted[k];
  const double total = tails[0];
  if (!(total > 0))
    return {};
  const double rest = (1 - fraction) * total;
  std::size_t count = 1;
  while (count < sorted.size() && tails[count] > rest)
    ++count;
  const double smallest = (1 - tie) * sorted[count - 1];
  std::vector<int> marked;
  for (std::size_t e = 0; e < squares.size(); ++e)
    if (squares[e] > 0 && squares[e] >= smallest)
      marked.push_back(static_cast<int>(e));
  return marked;
}

std::vector<std::vector<int>> doerfler(const std::vector<bem::Vector>& squares,
                                       double fraction) {
  bem::Vector all;
  for (const bem::Vector& body : squares)
    all.insert(all.end(), body.begin(), body.end());
  std::vector<std::vector<int>> marked(squares.size());
  std::size_t b = 0;
  int first = 0;
  for (const int e : doerfler(all, fraction)) {
    while (e - first >= static_cast<int>(squares[b].size()))
      first += static_cast<int>(squares[b++].size());
    marked[b].push_back(e - first);
  }
  return marked;
}

}  // namespace epafi::adaptivity
