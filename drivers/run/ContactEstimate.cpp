#include "drivers/run/ContactEstimate.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace epafi::drivers {

namespace {

using Element = contact::MultiplierSpace::ContactElement;

bool isClose(const ContactEstimate& contact, double tolerance) {
  return contact.relative <= tolerance && contact.doubt <= mostDoubt;
}

bool isClosed(const Element& element, bem::Index normals,
              const std::vector<SolvedState>& steps) {
  if (element.ties())
    return true;
  return std::any_of(steps.begin(), steps.end(), [&](const SolvedState& step) {
    for (int i = 0; i <= element.degree; ++i)
      if (const bem::Index k = element.normalOf(i);
          k >= 0 && k < normals && step.states[k] == contact::ContactState::Closed)
        return true;
    return false;
  });
}

/// Elements by body, each once.
class Elements {
 public:
  explicit Elements(std::size_t bodies) : all_(bodies) {}
  void add(std::size_t body, int element) { all_[body].insert(element); }
  std::vector<std::vector<int>> sorted() const {
    std::vector<std::vector<int>> lists;
    for (const std::set<int>& own : all_)
      lists.emplace_back(own.begin(), own.end());
    return lists;
  }

 private:
  std::vector<std::set<int>> all_;
};

/// What is opposite to an element of a side that carries a multiplier.
void addOpposite(const contact::Opposite& opposite, const Element& element,
                 Elements& elements) {
  for (const contact::Stretch& stretch : contact::stretches(opposite, element)) {
    const contact::Opposite::Point there = opposite.at(element, stretch.middle);
    if (there.element >= 0)
      elements.add(static_cast<std::size_t>(there.body), there.element);
  }
}

/// A contact of a body with what it needs; `closed` without neighbours.
ContactEstimate estimateOf(const BodySpaces& spaces, const Level& level, std::size_t b,
                           const std::string& name, const std::set<int>& closed) {
  const bem::Mesh& mesh = spaces.space(b).mesh();
  Elements elements(spaces.size());
  for (const Element& element : spaces.multiplier().elements(b)) {
    if (contact::nameOf(element) != name)
      continue;
    const int e = element.element;
    if (closed.count(e) + closed.count(mesh[e].previous) + closed.count(mesh[e].next) ==
        0)
      continue;
    elements.add(b, e);
    addOpposite(*spaces.opposite(), element, elements);
  }
  ContactEstimate contact;
  contact.name = name;
  contact.carrier = b;
  contact.body = b;
  contact.closed.assign(closed.begin(), closed.end());
  contact.elements = elements.sorted();
  double square = 0;
  const auto modulus = [&](std::size_t k) {
    return spaces.scene().bodies[k].material.youngsModulus;
  };
  // the energies that their tractions would store in bodies of modulus 1
  const auto energy = [&](std::size_t k) { return level.energies[k] * modulus(k); };
  double softest = modulus(b);
  for (std::size_t k = 0; k < spaces.size(); ++k) {
    const bem::Vector squares = level.indicators[k].elements();
    for (const int e : contact.elements[k])
      square += squares[e];
    if (contact.elements[k].empty())
      continue;
    softest = std::min(softest, modulus(k));
    if (energy(k) < energy(contact.body))
      contact.body = k;
  }
  const double stored = energy(contact.body) / softest;
  contact.relative = stored > 0 ? std::sqrt(square / (2 * stored)) : 0;
  return contact;
}

}  // namespace

std::vector<ContactEstimate> contactEstimates(const BodySpaces& spaces,
                                              const Level& level,
                                              const bem::Processes& processes) {
  std::vector<ContactEstimate> contacts;
  bem::Vector relative;
  std::size_t number = 0;  // as in a StepRow
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    std::map<std::string, std::set<int>> closed;
    std::set<std::string> bonds;
    for (const Element& element : spaces.multiplier().elements(b)) {
      std::set<int>& own = closed[contact::nameOf(element)];
      if (isClosed(element, spaces.multiplier().normals(), level.steps))
        own.insert(element.element);
      if (element.ties())
        bonds.insert(contact::nameOf(element));
    }
    for (const auto& [name, own] : closed) {
      const double doubt = bonds.count(name) > 0 ? 0 : level.doubts[number];
      ++number;
      if (own.empty())
        continue;
      contacts.push_back(estimateOf(spaces, level, b, name, own));
      contacts.back().doubt = doubt;
      relative.insert(relative.end(), {contacts.back().relative, doubt});
    }
  }
  relative = processes.broadcast(std::move(relative));
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    contacts[k].relative = relative[2 * k];
    contacts[k].doubt = relative[2 * k + 1];
  }
  return contacts;
}

bool keeps(const ContactEstimate& contact, double tolerance) {
  return isClose(contact, tolerance) && contact.closed.size() >= fewestClosed;
}

const ContactEstimate* worst(const std::vector<ContactEstimate>& contacts,
                             double tolerance) {
  const ContactEstimate* found = nullptr;
  for (const ContactEstimate& contact : contacts)
    if (!keeps(contact, tolerance) &&
        (found == nullptr || contact.relative > found->relative))
      found = &contact;
  return found;
}

std::vector<bem::Vector> onlyMissing(const std::vector<ContactEstimate>& contacts,
                                     double tolerance, std::vector<bem::Vector> squares) {
  std::vector<bem::Vector> kept;
  kept.reserve(squares.size());
  for (const bem::Vector& own : squares)
    kept.emplace_back(own.size());
  for (const ContactEstimate& contact : contacts)
    if (!isClose(contact, tolerance))
      for (std::size_t b = 0; b < kept.size(); ++b)
        for (const int e : contact.elements[b])
          kept[b][e] = squares[b][e];
  return kept;
}

std::vector<std::vector<int>> tooFew(const std::vector<ContactEstimate>& contacts,
                                     std::size_t bodies) {
  Elements elements(bodies);
  for (const ContactEstimate& contact : contacts)
    if (contact.closed.size() < fewestClosed)
      for (const int e : contact.closed)
        elements.add(contact.carrier, e);
  return elements.sorted();
}

}  // namespace epafi::drivers
