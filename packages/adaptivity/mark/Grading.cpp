#include "adaptivity/mark/Grading.hpp"

#include <algorithm>
#include <utility>

namespace epafi::adaptivity {

namespace {

/// The largest degree of what ends of contact or stick cross from step to step: pieces whose
/// kinks lie elsewhere in each of them converge by their size alone.
constexpr int crossed = 2;

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
Mark cutAt(const std::vector<double>& changes, int degree, const GradingOptions&) {
  return Mark::cut(changes, std::vector<int>(changes.size() + 1, degree));
}

/// Pieces that become smaller toward the singular ends, where the smallest keep the degree.
Mark cutToward(bool start, bool end, int degree, const GradingOptions& options) {
  std::vector<double> places;
  double size = 2;
  for (int k = 0; k < options.layers; ++k) {
    size *= options.ratio;
    if (start)
      places.push_back(size - 1);
    if (end)
      places.push_back(1 - size);
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::vector<int> degrees(places.size() + 1, raised(degree, options));
  if (start)
    degrees.front() = degree;
  if (end)
    degrees.back() = degree;
  return Mark::cut(std::move(places), std::move(degrees));
}

Mark bisect(const std::vector<double>&, int, const GradingOptions&) {
  return Mark::Bisect;
}

}  // namespace

bem::Family<Transitions>& transitions() {
  static bem::Family<Transitions> family(
      "transitions",
      {
          {"Node", "cut at it", true, cutAt},
          {"Surround", "cut on both sides of it, so that it lies in a small piece", true,
           cutAround},
          {"Bisect", "halve the element", true, bisect},
          {"Ignore", "treat the element and its nodes as if nothing changed there", false,
           cutAt},
      });
  return family;
}

bem::Family<SmoothElements>& smoothElements() {
  static bem::Family<SmoothElements> family(
      "smooth elements",
      {
          {"Raise Degree", "always", [](bool) { return true; }},
          {"Legendre Decay",
           "raise the degree where coefficients decay, halve the others",
           [](bool analytic) { return analytic; }},
      });
  return family;
}

void GradingOptions::keys(bem::Keys& keys) {
  keys.add(&ratio, "Ratio", "1", {0, 0.5, true, false},
           "length of the piece that is cut off next to a singular point, relative to "
           "the element's");
  keys.add(&degreeStep, "Degree Step", "1", {0, 4},
           "by how much the piece away from the singular point raises its degree");
  keys.add(&weakDegree, "Weak Point Degree", "1", bem::from(1),
           "next to corners and changes of boundary the degree is raised as long as it "
           "is lower and coefficients decay");
  keys.add(&transitions, "Transitions", adaptivity::transitions(),
           "where contact or friction changes its state inside an element; ");
  keys.add(&smooth, "Smooth Elements", smoothElements(),
           "raise the degree away from singular points; ");
}

Mark gradedMark(const bem::Mesh& mesh, int element, const SingularPoints& singular,
                bool analytic, const GradingOptions& options) {
  const int degree = mesh[element].degree;
  const std::vector<double>& changes = singular.inside[element];
  if (!changes.empty())
    return transitions()
        .at(options.transitions)
        .mark(changes, singular.states > 1 ? std::min(degree, crossed) : degree, options);
  const bool patient = analytic && degree < options.weakDegree;
  const auto isSingular = [&](bool end) {
    const Singularity s = singular.at(mesh, element, end);
    return s == Singularity::Strong || (s == Singularity::Weak && !patient);
  };
  const bool start = isSingular(false);
  const bool end = isSingular(true);
  if (start && end && options.layers == 1)
    return Mark::Bisect;
  if (start || end)
    return cutToward(start, end, degree, options);
  const bool raise = smoothElements().at(options.smooth).raisesDegree(analytic);
  return raise && degree < options.largestDegree ? Mark::RaiseDegree : Mark::Bisect;
}

}  // namespace epafi::adaptivity
