#include "contact/problem/ContactSystem.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/problem/BodyParts.hpp"

#include <algorithm>
#include <cassert>

namespace epafi::contact {

using bem::at;
using bem::axpy;

namespace {

/// A coupling to the multiplier of one body, my rows, and whose that is.
struct Met {
  std::size_t carrier;
  Matrix coupling;
};

bool completesEnds(const MultiplierSpace& multiplier) {
  const auto completed = [](const std::array<EndCompletion, 2>& ends) {
    return std::any_of(ends.begin(), ends.end(), [](const EndCompletion& end) {
      return end.clamped || !end.added.empty();
    });
  };
  return std::any_of(multiplier.elements().begin(), multiplier.elements().end(),
                     [&](const auto& element) {
                       return !element.condition->name.empty() &&
                              (completed(element.normalCompletions) ||
                               completed(element.tangentialCompletions));
                     });
}

void checkEnds(const MultiplierSpace& multiplier) {
  if (completesEnds(multiplier))
    throw bem::InputError(bem::message(
        "the multiplier '", multiplier.basis().name,
        "' cannot end at a clamp or at another contact side where it stands between two "
        "bodies; use Gauss-Legendre-Lagrange or Bernstein"));
}

}  // namespace

Numbering::Numbering(const std::vector<Count>& bodies) {
  for (const Count& count : bodies)
    normals_ += count.normals;
  Index normal = 0;
  Index tangential = normals_;
  for (const Count& count : bodies) {
    starts_.push_back({count, normal, tangential});
    normal += count.normals;
    tangential += count.size - count.normals;
  }
  size_ = tangential;
}

struct ContactSystem::Parts {
  std::vector<ContactProblem> bodies;
  std::vector<std::vector<Met>> met;  ///< of each body
  Numbering numbering;
  Problem numbers{};
  Vector gap{};

  std::size_t size() const { return bodies.size(); }
  ContactProblem::Parts& part(std::size_t b) { return *bodies[b].parts_; }

  void meet(const std::vector<ContactProblem::Input>& inputs) {
    met.resize(size());
    for (std::size_t a = 0; a < size(); ++a) {
      const MultiplierSpace& multiplier = bodies[a].multiplier();
      const Opposite& opposite = *part(a).opposite;
      for (const int b : opposite.bodies()) {
        checkEnds(multiplier);
        const auto k = static_cast<std::size_t>(b);
        met[k].push_back(
            {a, oppositeCoupling(inputs[a].space.mesh(), multiplier, opposite,
                                 inputs[k].space, part(a).algebra, b)});
      }
    }
  }

  /// Columns of one body's multiplier at their places among all.
  void place(std::size_t carrier, const Matrix& own, Matrix& all) const {
    for (Index j = 0; j < own.columns(); ++j) {
      const double* from = own.column(j);
      double* to = all.column(numbering(carrier, j));
      for (Index i = 0; i < own.rows(); ++i)
        to[i] += from[i];
    }
  }

  Matrix coupling(std::size_t b) {
    Matrix own = part(b).form->coupling();
    if (size() == 1)
      return own;
    Matrix all(own.rows(), numbering.size());
    place(b, own, all);
    for (const Met& other : met[b])
      place(other.carrier, other.coupling, all);
    return all;
  }

  Matrix multiplierMass() {
    Matrix mass = part(0).form->multiplierMass();
    if (size() == 1)
      return mass;
    Matrix all(numbering.size(), numbering.size());
    for (std::size_t b = 0; b < size(); ++b) {
      const Matrix own = b == 0 ? std::move(mass) : part(b).form->multiplierMass();
      for (Index j = 0; j < own.columns(); ++j)
        for (Index i = 0; i < own.rows(); ++i)
          all(numbering(b, i), numbering(b, j)) = own(i, j);
    }
    return all;
  }

  void condenseAll() {
    std::vector<ElasticBody::Response> responses;
    for (std::size_t b = 0; b < size(); ++b)
      responses.push_back(size() == 1 ? part(b).body->ownResponse()
                                      : part(b).body->response(coupling(b)));
    numbers =
        condense(part(0).algebra,
                 responses.front().flexibility == nullptr ? multiplierMass() : Matrix(),
                 responses);
    numbers.normals = numbering.normals();
    gap.assign(at(numbering.normals()), 0.0);
    double load = 0;
    for (std::size_t b = 0; b < size(); ++b) {
      const ContactProblem::Parts& own = part(b);
      load += own.size();
      for (const Tangential& tangential : own.numbers.tangentials)
        numbers.tangentials.push_back(tangential.shifted(numbering(b, 0)));
      for (Index i = 0; i < numbering.sizeOf(b); ++i) {
        const Index k = numbering(b, i);
        numbers.offset[at(k)] -= own.obstacle.motion[at(i)];
        if (i >= numbering.normalsOf(b))
          continue;
        gap[at(k)] = own.obstacle.gap[at(i)];
        numbers.offset[at(k)] -= gap[at(k)];
      }
    }
    numbers.stress = load > 0 ? load : 1;
    for (std::size_t b = 0; b < size(); ++b)
      part(b).numbers.stress = numbers.stress;
  }
};

ContactSystem::ContactSystem(const std::vector<ContactProblem::Input>& inputs) {
  assert(!inputs.empty());
  std::vector<ContactProblem> bodies;
  std::vector<Numbering::Count> counts;
  for (const ContactProblem::Input& input : inputs) {
    bodies.push_back(ContactProblem(std::make_unique<ContactProblem::Parts>(input)));
    const MultiplierSpace& multiplier = bodies.back().multiplier();
    counts.push_back({multiplier.normals(), multiplier.size()});
  }
  parts_ = std::make_unique<Parts>(Parts{std::move(bodies), {}, Numbering(counts)});
  parts_->meet(inputs);
  parts_->condenseAll();
}

ContactSystem::~ContactSystem() = default;
ContactSystem::ContactSystem(ContactSystem&&) noexcept = default;

std::size_t ContactSystem::size() const { return parts_->size(); }
const ContactProblem& ContactSystem::body(std::size_t b) const {
  return parts_->bodies[b];
}
const Problem& ContactSystem::numbers() const { return parts_->numbers; }
const Vector& ContactSystem::gap() const { return parts_->gap; }

const Numbering& ContactSystem::numbering() const { return parts_->numbering; }

std::vector<State> ContactSystem::split(const State& state) const {
  std::vector<State> states;
  auto motions = state.rigid.begin();
  for (std::size_t b = 0; b < size(); ++b) {
    State own;
    for (Index i = 0; i < numbering().sizeOf(b) && !state.multiplier.empty(); ++i)
      own.multiplier.push_back(state.multiplier[at(numbering()(b, i))]);
    if (!state.rigid.empty()) {
      own.rigid.assign(motions, motions + body(b).freeMotions());
      motions += body(b).freeMotions();
    }
    states.push_back(std::move(own));
  }
  return states;
}

State ContactSystem::joined(const std::vector<State>& states) const {
  State all;
  const bool empty = std::all_of(states.begin(), states.end(),
                                 [](const State& s) { return s.multiplier.empty(); });
  if (!empty)
    all.multiplier.assign(at(parts_->numbering.size()), 0.0);
  for (std::size_t b = 0; b < states.size(); ++b) {
    for (std::size_t i = 0; i < states[b].multiplier.size(); ++i)
      all.multiplier[at(parts_->numbering(b, static_cast<Index>(i)))] =
          states[b].multiplier[i];
    all.rigid.insert(all.rigid.end(), states[b].rigid.begin(), states[b].rigid.end());
  }
  return all;
}

Vector ContactSystem::met(std::size_t b, const std::vector<State>& states) const {
  Vector force;
  for (const Met& other : parts_->met[b]) {
    const Vector& multiplier = states[other.carrier].multiplier;
    const Index unknowns = static_cast<Index>(body(b).load().size());
    if (force.empty())
      force.assign(at(unknowns), 0.0);
    if (!multiplier.empty())
      axpy(1,
           parts_->bodies[b].parts_->algebra.multiply(other.coupling, unknowns,
                                                      multiplier),
           force);
  }
  return force;
}

}  // namespace epafi::contact
