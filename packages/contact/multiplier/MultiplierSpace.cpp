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
    if (element.condition->friction)
      element.tangential = 0;
    element.point = points();
    elements_.push_back(element);
  }
  joined_.assign(elements_.size(), false);
  place_.assign(mesh.size(), -1);
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    place_[elements_[k].element] = static_cast<int>(k);
    next_.push_back(mesh[elements_[k].element].next);
  }
  if (basis.sharesNodes)
    shareNodes(mesh, conditions);
  number();
  if (basis.sharesNodes)
    completeEnds(mesh, conditions, elements_);
}

void MultiplierSpace::shareNodes(const bem::Mesh& mesh, const Conditions& conditions) {
  for (std::size_t k = 0; k < elements_.size(); ++k)
    if (const auto behind = follower(k))
      joined_[*behind] = continues(mesh, elements_[k], elements_[*behind]);
  NodeDirections nodes = clampedDirections(mesh, conditions);
  const auto decide = [&](std::size_t k, bool tangential) {
    const bem::Element& element = mesh[elements_[k].element];
    const auto direction = [&](double t) {
      return tangential ? element.curve.tangent(t) : element.curve.normal(t);
    };
    Ends ends;
    if (!joined_[k])
      ends[0].isUnknown = nodes.take(element.startNode, direction(-1));
    const auto behind = follower(k);
    if (!behind || !joined_[*behind])
      ends[1].isUnknown = nodes.take(element.endNode, direction(1));
    if (elements_[k].degree == 1 && !ends[0].isUnknown && !ends[1].isUnknown)
      throw bem::InputError(
          placeOf(elements_[k]),
          ": an element of degree 1 without a free node cannot carry the multiplier '",
          basis_->name, "'; use more elements, a higher degree or another multiplier");
    return ends;
  };
  for (std::size_t k = 0; k < elements_.size(); ++k)
    elements_[k].normalEnds = decide(k, false);
  for (std::size_t k = 0; k < elements_.size(); ++k)
    if (elements_[k].tangential >= 0)
      elements_[k].tangentialEnds = decide(k, true);
}

std::optional<std::size_t> MultiplierSpace::follower(std::size_t k) const {
  const int place = place_[next_[k]];
  return place < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(place));
}

void MultiplierSpace::number() {
  const auto assign = [&](Index ContactElement::*first, Index ContactElement::*last,
                          Ends ContactElement::*ends, const auto& belongs) {
    bool isOpen =
        false;  // the next element shares its first coefficient with the last one
    for (std::size_t k = 0; k < elements_.size(); ++k) {
      ContactElement& element = elements_[k];
      if (!belongs(element))
        continue;
      element.*first = isOpen ? size_ - 1 : size_;
      const auto behind = follower(k);
      const bool joins = behind && joined_[*behind];
      const bool closes = joins && *behind <= k;
      if (closes)
        element.*last = elements_[*behind].*first;
      isOpen = joins && !closes;
      size_ = element.*first + element.offset(element.*ends, element.degree) +
              (closes ? 0 : 1);
    }
  };
  const auto normals = [&](const auto& belongs) {
    assign(&ContactElement::normal, &ContactElement::normalLast,
           &ContactElement::normalEnds, belongs);
  };
  const auto ties = [](const ContactElement& element) { return element.ties(); };
  normals([&](const ContactElement& element) { return !ties(element); });
  normals_ = size_;
  normals(ties);
  assign(&ContactElement::tangential, &ContactElement::tangentialLast,
         &ContactElement::tangentialEnds,
         [](const ContactElement& element) { return element.tangential >= 0; });
}

Index MultiplierSpace::points() const {
  return elements_.empty() ? 0 : elements_.back().point + elements_.back().degree + 1;
}

double MultiplierSpace::throughPoints(const Vector& values, const ContactElement& element,
                                      double t) {
  const Vector chi = multiplierBasis("Gauss-Legendre-Lagrange").values(element.degree, t);
  return std::inner_product(chi.begin(), chi.end(), values.begin() + element.point, 0.0);
}

Index MultiplierSpace::ContactElement::offset(const Ends& ends, int i) const {
  const int skipped = ends[0].isUnknown ? 0 : 1;
  const int last = degree - skipped - (ends[1].isUnknown ? 0 : 1);
  return std::clamp(i - skipped, 0, last);
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
  const auto coefficient = [&](Index k) { return multiplier[k]; };
  Value value;
  for (int i = 0; i <= element.degree; ++i) {
    const double weight = chi[i];
    value.normal += weight * coefficient(element.normalOf(i));
    if (element.tangential >= 0)
      value.tangential += weight * coefficient(element.tangentialOf(i));
  }
  for (const std::size_t end : {0, 1}) {
    const double weight = end == 0 ? chi.front() : chi.back();
    for (const auto& [k, factor] : element.normalEnds[end].added)
      value.normal += weight * factor * coefficient(k);
    for (const auto& [k, factor] : element.tangentialEnds[end].added)
      value.tangential += weight * factor * coefficient(k);
  }
  return value;
}

}  // namespace epafi::contact
