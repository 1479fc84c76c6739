#include "contact/multiplier/MultiplierSpace.hpp"

#include "bem/base/Error.hpp"
#include "contact/multiplier/SharedNodes.hpp"

#include <algorithm>
#include <numeric>

namespace epafi::contact {

namespace {

using ContactElement = MultiplierSpace::ContactElement;

/// Is `after` the next element on the same boundary, with a continuous tangent?
bool continues(const bem::Mesh& mesh, const ContactElement& before,
               const ContactElement& after) {
  const bem::Element& a = mesh[before.element];
  const bem::Element& b = mesh[after.element];
  return b.previous == before.element && before.boundary == after.boundary &&
         bem::joinSmoothly(a.curve, b.curve);
}

}  // namespace

const Conditions::Contact* contactOn(const bem::Mesh& mesh, int e,
                                     const Conditions& conditions) {
  const bem::Piece& piece = mesh[e].piece;
  return conditions.contactOn(mesh.boundary(e), piece.edge,
                              0.5 * (piece.start.fromStart + piece.end.fromStart));
}

MultiplierSpace::MultiplierSpace(const bem::Mesh& mesh, const MultiplierBasis& basis,
                                 const Conditions& conditions)
    : basis_(&basis), conditions_(&conditions) {
  for (int e = 0; e < mesh.size(); ++e) {
    const Conditions::Contact* condition = contactOn(mesh, e, conditions);
    if (condition == nullptr)
      continue;
    ContactElement element;
    element.element = e;
    element.degree = mesh[e].degree;
    element.boundary = &conditions.contact.find(mesh.boundary(e))->first;
    element.condition = condition;
    element.normal.degree = element.tangential.degree = element.degree;
    if (condition->friction)
      element.tangential.first = 0;
    element.point = points();
    elements_.push_back(element);
  }
  joined_.assign(elements_.size(), false);
  std::vector<std::optional<std::size_t>> place(mesh.size());
  for (std::size_t k = 0; k < elements_.size(); ++k)
    place[elements_[k].element] = k;
  for (const ContactElement& element : elements_)
    followers_.push_back(place[mesh[element.element].next]);
  if (basis.sharesNodes)
    shareNodes(mesh, conditions);
  number();
  if (basis.sharesNodes)
    completeEnds(mesh, conditions, elements_);
}

void MultiplierSpace::shareNodes(const bem::Mesh& mesh, const Conditions& conditions) {
  std::vector<bool> joinsNext(elements_.size());
  for (std::size_t k = 0; k < elements_.size(); ++k)
    if (const auto behind = follower(k))
      joined_[*behind] = joinsNext[k] = continues(mesh, elements_[k], elements_[*behind]);
  chooseEnds(mesh, conditions, joined_, joinsNext, elements_);
  for (const ContactElement& element : elements_)
    for (const Coefficients* own : {&element.normal, &element.tangential})
      if (element.degree == 1 && !own->isOwn(0) && !own->isOwn(1))
        throw bem::InputError(
            placeOf(element),
            ": an element of degree 1 without a free node cannot carry the multiplier '",
            basis_->name, "'; use more elements, a higher degree or another multiplier");
}

void MultiplierSpace::number() {
  const auto assign = [&](Coefficients ContactElement::*own, const auto& belongs) {
    bool isOpen =
        false;  // the next element shares its first coefficient with the last one
    for (std::size_t k = 0; k < elements_.size(); ++k) {
      if (!belongs(elements_[k]))
        continue;
      Coefficients& now = elements_[k].*own;
      now.first = isOpen ? size_ - 1 : size_;
      const auto behind = follower(k);
      const bool joins = behind && joined_[*behind];
      const bool closes = joins && *behind <= k;
      isOpen = joins && !closes;
      size_ = now.number(now.degree) + (closes ? 0 : 1);
      if (closes)
        now.closing = (elements_[*behind].*own).first;
    }
  };
  const auto ties = [](const ContactElement& element) { return element.ties(); };
  assign(&ContactElement::normal, [&](const auto& element) { return !ties(element); });
  normals_ = size_;
  assign(&ContactElement::normal, ties);
  assign(&ContactElement::tangential,
         [](const ContactElement& element) { return element.shears(); });
}

Index MultiplierSpace::points() const {
  return elements_.empty() ? 0 : elements_.back().point + elements_.back().degree + 1;
}

double MultiplierSpace::throughPoints(const Vector& values, const ContactElement& element,
                                      double t) {
  const Vector chi = multiplierBasis("Gauss-Legendre-Lagrange").values(element.degree, t);
  const auto first = values.begin() + element.point;
  return std::max(std::inner_product(chi.begin(), chi.end(), first, 0.0), 0.0);
}

Index Coefficients::number(int i) const {
  if (closing >= 0 && i == degree)
    return closing;
  const int skipped = ends[0].isUnknown ? 0 : 1;
  const int last = degree - skipped - (ends[1].isUnknown ? 0 : 1);
  return first + std::clamp(i - skipped, 0, last);
}

std::vector<int> MultiplierSpace::meshElements() const {
  std::vector<int> elements;
  for (const ContactElement& element : elements_)
    elements.push_back(element.element);
  return elements;
}

MultiplierSpace MultiplierSpace::under(const Conditions& conditions) const {
  MultiplierSpace result = *this;
  result.conditions_ = &conditions;
  for (ContactElement& element : result.elements_) {
    const auto& [name, condition] = *conditions.contact.find(*element.boundary);
    element.boundary = &name;
    element.condition = &condition;
  }
  return result;
}

MultiplierSpace::Value MultiplierSpace::at(const Vector& multiplier,
                                           const ContactElement& element,
                                           double t) const {
  const Vector chi = basis_->values(element.degree, t);
  const auto sum = [&](const Coefficients& own) {
    double value = 0;
    for (int i = 0; i <= own.degree; ++i)
      value += chi[i] * multiplier[own.number(i)];
    for (const std::size_t end : {0, 1})
      for (const auto& [k, factor] : own.ends[end].added)
        value += (end == 0 ? chi.front() : chi.back()) * factor * multiplier[k];
    return value;
  };
  return {sum(element.normal), element.shears() ? sum(element.tangential) : 0};
}

}  // namespace epafi::contact
