#include "adaptivity/mark/Grading.hpp"

#include "bem/basis/Legendre.hpp"

#include <algorithm>

namespace epafi::adaptivity {

namespace {

int raised(int degree, const GradingOptions& options) {
  return std::max(degree, std::min(degree + options.degreeStep, options.largestDegree));
}

/// Cuts around the states' changes inside an element, so that they lie in a small piece.
Mark cutAround(const std::vector<double>& changes, int degree,
               const GradingOptions& options) {
  const double reach = 2 * options.ratio;
  std::vector<double> places;
  if (changes.front() - reach > -1 + 0.5 * reach)
    places.push_back(changes.front() - reach);
  if (changes.back() + reach < 1 - 0.5 * reach)
    places.push_back(changes.back() + reach);
  if (places.empty())
    return Mark::Bisect;
  const int outer = raised(degree, options);
  std::vector<int> degrees = {changes.front() < places.front() ? degree : outer};
  for (const double place : places)
    degrees.push_back(changes.front() < place ? outer : degree);
  return Mark::cut(std::move(places), std::move(degrees));
}

/// Cuts where the states change, so that kinks come to lie on nodes.
Mark cutAt(const std::vector<double>& changes, int degree) {
  return Mark::cut(changes, std::vector<int>(changes.size() + 1, degree));
}

Mark smoothMark(int degree, bool analytic, const GradingOptions& options) {
  const bool raise = options.smooth == "Raise Degree" || analytic;
  return raise && degree < options.largestDegree ? Mark::RaiseDegree : Mark::Bisect;
}

}  // namespace

const std::vector<Transitions>& transitions() {
  static const std::vector<Transitions> table = {
      {"Node", "cut at it"},
      {"Follow", "cut at it, and move that node when it moves"},
      {"Surround", "cut on both sides of it, so that it lies in a small piece"},
      {"Bisect", "halve the element"},
      {"Ignore", "treat the element and its nodes as if nothing changed there"},
  };
  return table;
}

const std::vector<SmoothElements>& smoothElements() {
  static const std::vector<SmoothElements> table = {
      {"Raise Degree", "always"},
      {"Legendre Decay", "raise the degree where coefficients decay, halve the others"},
  };
  return table;
}

Mark gradedMark(const bem::Mesh& mesh, int element, const SingularPoints& singular,
                bool analytic, const GradingOptions& options) {
  const int degree = mesh[element].degree;
  const std::vector<double>& changes = singular.inside[static_cast<std::size_t>(element)];
  if (!changes.empty()) {
    if (options.transitions == "Surround")
      return cutAround(changes, degree, options);
    return options.transitions == "Bisect" ? Mark(Mark::Bisect) : cutAt(changes, degree);
  }
  const bool patient = analytic && degree < options.weakDegree;
  const auto isSingular = [&](bool end) {
    const Singularity s = singular.at(mesh, element, end);
    return s == Singularity::Strong || (s == Singularity::Weak && !patient);
  };
  const bool start = isSingular(false);
  const bool end = isSingular(true);
  if (start && end)
    return Mark::Bisect;
  const int outer = raised(degree, options);
  if (start)
    return Mark::cut({-1 + 2 * options.ratio}, {degree, outer});
  if (end)
    return Mark::cut({1 - 2 * options.ratio}, {outer, degree});
  return smoothMark(degree, analytic, options);
}

}  // namespace epafi::adaptivity
