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

bool beginsAtImage(const bem::Mesh& mesh, int e, const Conditions& conditions) {
  const int edge = mesh[e].piece.edge;
  return mesh[mesh[e].previous].piece.edge != edge && conditions.images.count(edge) > 0;
}

bem::Normals sightOf(const bem::Mesh& mesh, int e, const Conditions& conditions) {
  const Conditions::Contact* contact = contactOn(mesh, e, conditions);
  const bem::Piece& piece = mesh[e].piece;
  return contact == nullptr
             ? bem::Normals::Own
             : contact->along(piece.edge,
                              0.5 * (piece.start.fromStart + piece.end.fromStart));
}

MultiplierSpace::MultiplierSpace(const std::vector<Body>& bodies,
                                 const MultiplierBasis& basis)
    : basis_(&basis) {
  for (const Body& body : bodies)
    addBody(body);
  number();
  for (std::size_t b = 0; b < bodies.size() && basis.sharesNodes; ++b)
    completeEnds(bodies[b].mesh, bodies[b].conditions, elements_[b]);
}

void MultiplierSpace::addBody(const Body& body) {
  const auto& [mesh, conditions] = body;
  std::vector<ContactElement> elements;
  std::vector<std::optional<std::size_t>> place(bem::at(mesh.size()));
  for (int e = 0; e < mesh.size(); ++e) {
    const Conditions::Contact* condition = contactOn(mesh, e, conditions);
    if (condition == nullptr)
      continue;
    ContactElement element;
    element.body = static_cast<int>(elements_.size());
    element.mesh = &mesh;
    element.element = e;
    element.degree = mesh[e].degree;
    element.boundary = &conditions.contact.find(mesh.boundary(e))->first;
    element.condition = condition;
    element.normal.degree = element.tangential.degree = element.degree;
    if (condition->friction)
      element.tangential.first = 0;
    element.point = points_;
    points_ += element.degree + 1;
    place[bem::at(e)] = elements.size();
    elements.push_back(element);
  }
  for (ContactElement& element : elements)
    element.follower = place[bem::at(element.geometry().next)];
  if (basis_->sharesNodes)
    shareNodes(body, elements);
  meshes_.push_back(&mesh);
  conditions_.push_back(&conditions);
  elements_.push_back(std::move(elements));
}

void MultiplierSpace::shareNodes(const Body& body,
                                 std::vector<ContactElement>& elements) const {
  for (ContactElement& element : elements)
    element.joinsFollower =
        element.follower && continues(body.mesh, element, elements[*element.follower]);
  chooseEnds(body.mesh, body.conditions, elements);
  for (const ContactElement& element : elements)
    for (const Coefficients* own : {&element.normal, &element.tangential})
      if (element.degree == 1 && !own->isOwn(0) && !own->isOwn(1))
        throw bem::InputError(
            placeOf(element),
            ": an element of degree 1 without a free node cannot carry the multiplier '",
            basis_->name, "'; use more elements, a higher degree or another multiplier");
}

void MultiplierSpace::number() {
  columns_.resize(bodies());
  const auto assign = [&](std::size_t b, Coefficients ContactElement::*own,
                          const auto& belongs) {
    const Index start = size_;
    std::vector<ContactElement>& elements = elements_[b];
    bool isOpen =
        false;  // the next element shares its first coefficient with the last one
    for (std::size_t k = 0; k < elements.size(); ++k) {
      if (!belongs(elements[k]))
        continue;
      Coefficients& now = elements[k].*own;
      now.first = isOpen ? size_ - 1 : size_;
      const bool joins = elements[k].joinsFollower;
      const bool closes = joins && *elements[k].follower <= k;
      isOpen = joins && !closes;
      size_ = now.number(now.degree) + (closes ? 0 : 1);
      if (closes)
        now.closing = (elements[*elements[k].follower].*own).first;
    }
    for (Index i = start; i < size_; ++i)
      columns_[b].push_back(i);
  };
  const auto ties = [](const ContactElement& element) { return element.ties(); };
  for (std::size_t b = 0; b < bodies(); ++b)
    assign(b, &ContactElement::normal,
           [&](const ContactElement& element) { return !ties(element); });
  normals_ = size_;
  for (std::size_t b = 0; b < bodies(); ++b) {
    assign(b, &ContactElement::normal, ties);
    assign(b, &ContactElement::tangential,
           [](const ContactElement& element) { return element.shears(); });
  }
}

Vector MultiplierSpace::lengths() const {
  Vector all(bem::at(size()));
  forEachElement([&](const ContactElement& element) {
    const double share =
        2 * element.mesh->measure(element.element, 0) / (element.degree + 1);
    for (int i = 0; i < element.coefficients(); ++i)
      all[bem::at(element.numberOf(i))] += share;
  });
  return all;
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

MultiplierSpace MultiplierSpace::under(const std::vector<Conditions>& conditions) const {
  MultiplierSpace result = *this;
  for (std::size_t b = 0; b < bodies(); ++b) {
    result.conditions_[b] = &conditions[b];
    for (ContactElement& element : result.elements_[b]) {
      const auto& [name, condition] = *conditions[b].contact.find(*element.boundary);
      element.boundary = &name;
      element.condition = &condition;
    }
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
