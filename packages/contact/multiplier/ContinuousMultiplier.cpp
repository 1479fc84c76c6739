#include "contact/multiplier/ContinuousMultiplier.hpp"

#include "bem/basis/EndValues.hpp"
#include "bem/quadrature/Gauss.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi::contact {

namespace {

using Element = MultiplierSpace::ContactElement;

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// λₙ or λₜ.
struct Component {
  double MultiplierSpace::Value::*value;
  Coefficients Element::*own;
};

class Jumps {
 public:
  Jumps(const MultiplierSpace& space, std::size_t body, const Vector& multiplier,
        const Vector& bounds, const Component& component)
      : space_(space),
        elements_(space.elements(body)),
        multiplier_(multiplier),
        bounds_(bounds),
        component_(component),
        before_(elements_.size(), none),
        behind_(before_),
        factors_(before_.size(), 0.0) {
    for (const Index i : space.columns(body))
      small_ = std::max(small_, 1e-9 * std::abs(multiplier[at(i)]));
    // at the ends of sides stresses may be singular, and no polynomial is close: what jumps there
    // would spoil the next element
    const std::vector<char> isInner = insideSides(space, body);
    for (std::size_t k = 0; k < before_.size(); ++k)
      if (const auto next = element(k).follower; next && *next != k && isInner[k] != 0 &&
                                                 isInner[*next] != 0 &&
                                                 isJoint(element(k), element(*next))) {
        behind_[k] = *next;
        before_[*next] = k;
      }
    close();
  }

  /// Adds Σ c_i w_i.
  void addTo(Vector& result) const {
    for (std::size_t k = 0; k < before_.size(); ++k) {
      if (before_[k] == none && behind_[k] == none)
        continue;
      const Element& here = element(k);
      const Vector& places = bem::gaussLegendre(here.degree + 1).points;
      Vector more;
      for (const double t : places)
        more.push_back(correction(k, t));
      interpolation(space_.basis(), places).solve(more);
      for (int i = 0; i <= here.degree; ++i)
        result[(here.*component_.own).number(i)] += more[at(i)];
    }
  }

 private:
  const Element& element(std::size_t k) const { return elements_[k]; }
  double half(std::size_t k) const { return element(k).geometry().half; }

  double coefficient(const Element& e, int i) const {
    return multiplier_[(e.*component_.own).number(i)];
  }

  bool isNormal() const { return component_.value == &MultiplierSpace::Value::normal; }

  bool isStressed(const Element& e) const {
    for (int i = 0; i <= e.degree && (e.*component_.own).first >= 0; ++i)
      if (std::abs(coefficient(e, i)) > small_)
        return true;
    return false;
  }

  /// Is the coefficient at its bound?
  bool slips(const Element& e, int i) const {
    constexpr double almost = 1 - 1e-9;
    return std::abs(coefficient(e, i)) >= almost * bounds_[(e.*component_.own).number(i)];
  }

  bool isJoint(const Element& a, const Element& b) const {
    if (a.condition != b.condition || !isStressed(a) || !isStressed(b))
      return false;
    const bool turns = coefficient(a, a.degree) * coefficient(b, 0) < 0;
    return isNormal() || !turns || !slips(a, a.degree) || !slips(b, 0);
  }

  /// Σ c_i w_i on an element.
  double correction(std::size_t k, double t) const {
    const bem::EndValues e = bem::endValues(element(k).degree, t);
    double value = 0;
    if (behind_[k] != none)
      value += factors_[k] * e.end / half(k);
    if (before_[k] != none)
      value -= factors_[before_[k]] * e.start / half(k);
    return value;
  }

  double valueAt(std::size_t k, double t) const {
    return space_.at(multiplier_, element(k), t).*component_.value;
  }

  /// Solves for c, one equation per joint, by the Gauss-Seidel method: entries of
  /// neighbours are smaller than the diagonal by a factor p + 1.
  void close() {
    constexpr int sweeps = 60;
    Vector jumps(before_.size(), 0.0);
    std::vector<bem::EndValues> ends;  // e(±1)/half
    for (std::size_t k = 0; k < jumps.size(); ++k) {
      const bem::EndValues e = bem::endValues(element(k).degree, 1);
      ends.push_back({e.start / half(k), e.end / half(k)});
      if (behind_[k] != none)
        jumps[k] = valueAt(k, 1) - valueAt(behind_[k], -1);
    }
    for (int sweep = 0; sweep < sweeps; ++sweep)
      for (std::size_t k = 0; k < jumps.size(); ++k) {
        const std::size_t next = behind_[k];
        if (next == none)
          continue;
        double jump = jumps[k] - factors_[next] * ends[next].start;
        if (before_[k] != none)
          jump -= factors_[before_[k]] * ends[k].start;
        factors_[k] = -jump / (ends[k].end + ends[next].end);
      }
  }

  const MultiplierSpace& space_;
  const std::vector<Element>& elements_;
  const Vector& multiplier_;
  const Vector& bounds_;
  const Component& component_;
  std::vector<std::size_t> before_;  ///< neighbour across the joint, by contact element
  std::vector<std::size_t> behind_;
  Vector factors_;  ///< c_i, by the element before node i
  double small_ = 0;
};

/// Does the side go on behind an end of the element, which its mirror image may do?
bool goesOn(const Conditions& conditions, const Element& here, bool end) {
  const bem::Mesh& mesh = *here.mesh;
  const bem::Element& element = here.geometry();
  const int next = end ? element.next : element.previous;
  const bem::Curve& curve = element.curve;
  const bem::Curve& other = mesh[next].curve;
  if (beginsAtImage(mesh, end ? next : here.element, conditions))
    return true;
  if (!conditions.isBoundary(mesh.boundary(next)))
    return std::abs(dot(curve.tangent(end ? 1 : -1), other.tangent(end ? -1 : 1))) <
           bem::smoothAngle / 2;
  return contactOn(mesh, next, conditions) == here.condition &&
         (end ? joinSmoothly(curve, other) : joinSmoothly(other, curve));
}

}  // namespace

std::vector<char> insideSides(const MultiplierSpace& space, std::size_t body) {
  std::vector<char> result;
  for (const Element& element : space.elements(body))
    result.push_back(goesOn(space.conditions(body), element, false) &&
                             goesOn(space.conditions(body), element, true)
                         ? 1
                         : 0);
  return result;
}

Vector withoutJumps(const MultiplierSpace& space, std::size_t body,
                    const Vector& multiplier, const Vector& bounds) {
  static const Component components[] = {
      {&MultiplierSpace::Value::normal, &Element::normal},
      {&MultiplierSpace::Value::tangential, &Element::tangential}};
  Vector result = multiplier;
  if (space.basis().sharesNodes)
    return result;
  for (const Component& component : components)
    Jumps(space, body, multiplier, bounds, component).addTo(result);
  return result;
}

}  // namespace epafi::contact
