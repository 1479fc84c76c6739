#include "contact/system/ContactSystem.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/compressed/CompressedBody.hpp"
#include "contact/opposite/MortarCoupling.hpp"
#include "contact/system/BodyParts.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace epafi::contact {

using bem::at;
using bem::axpy;

namespace {

/// A coupling of displacements to the multiplier of one body, and whose that is.
struct Met {
  std::size_t carrier;
  MortarCoupling coupling;
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

struct ContactSystem::Parts {
  /// Of a mesh, whatever the time.
  struct Couplings {
    std::vector<std::vector<Met>> met;  ///< of each body
    std::vector<RigidTraces> rigid;     ///< of each body that does not deform
  };

  std::vector<ContactProblem> bodies;
  Numbering numbering;
  std::vector<Drive> drives;
  std::shared_ptr<const Couplings> couplings{};
  Problem numbers{};
  Vector gap{};
  Vector jump{};
  Vector slipBefore{};

  std::size_t size() const { return bodies.size(); }
  const ContactProblem::Parts& part(std::size_t b) const { return *bodies[b].parts_; }
  ContactProblem::Parts& part(std::size_t b) { return *bodies[b].parts_; }

  void meet(const std::vector<ContactProblem::Input>& inputs) {
    Couplings all;
    std::vector<std::vector<Met>>& met = all.met;
    met.resize(size());
    for (std::size_t a = 0; a < size(); ++a) {
      const MultiplierSpace& multiplier = bodies[a].multiplier();
      const Opposite& opposite = *part(a).opposite;
      for (const int b : opposite.bodies()) {
        checkEnds(multiplier);
        const auto k = static_cast<std::size_t>(b);
        met[k].push_back({a, mortarCoupling(inputs[a].space.mesh(), multiplier, opposite,
                                            inputs[k].space, b)});
      }
    }
    for (std::size_t k = 0; k < drives.size(); ++k)
      all.rigid.push_back(tracesOf(static_cast<int>(k), inputs));
    couplings = std::make_shared<const Couplings>(std::move(all));
  }

  /// On all multipliers.
  RigidTraces tracesOf(int body, const std::vector<ContactProblem::Input>& inputs) const {
    std::vector<RigidTraces> parts;
    RigidTraces all{Matrix(numbering.size(), 3)};
    for (std::size_t a = 0; a < size(); ++a) {
      parts.push_back(rigidTraces(inputs[a].space.mesh(), bodies[a].multiplier(),
                                  *part(a).opposite, body));
      all.lever = std::max(all.lever, parts[a].lever);
      all.length += parts[a].length;
    }
    for (std::size_t a = 0; a < size(); ++a)
      for (Index k = 0; k < 3; ++k)
        for (Index i = 0; i < numbering.sizeOf(a); ++i)
          all.traces(numbering(a, i), k) =
              parts[a].traces(i, k) *
              (k == 2 && all.lever > 0 ? parts[a].lever / all.lever : 1);
    return all;
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
    const bem::Rows mine =
        part(b).algebra.myRows(static_cast<Index>(bodies[b].load().size()));
    for (const auto& [carrier, coupling] : couplings->met[b]) {
      for (const Coupling::Entry& entry : coupling.entries)
        if (mine.contain(entry.row))
          all(entry.row - mine.begin, numbering(carrier, entry.column)) += entry.value;
      if (coupling.rotation == nullptr)
        continue;
      const Vector& q = coupling.rotation->functional();
      for (Index i = 0; i < numbering.sizeOf(carrier); ++i)
        for (Index j = 0; j < mine.size(); ++j)
          all(j, numbering(carrier, i)) += q[at(j + mine.begin)] * coupling.rests[at(i)];
    }
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

  /// C_b u on all multipliers, of a body's displacement.
  Vector pulled(std::size_t b, const Vector& u) const {
    Vector all(at(numbering.size()));
    const Vector own = part(b).form->pull(u);
    for (Index i = 0; i < numbering.sizeOf(b); ++i)
      all[at(numbering(b, i))] = own[at(i)];
    for (const auto& [carrier, coupling] : couplings->met[b]) {
      const Vector others = coupling.pull(u);
      for (Index i = 0; i < numbering.sizeOf(carrier); ++i)
        all[at(numbering(carrier, i))] += others[at(i)];
    }
    return all;
  }

  void condenseAll(const std::vector<ContactProblem::Input>& inputs) {
    std::vector<ElasticBody::Response> responses;
    if (part(0).body->compressed() != nullptr) {
      std::vector<CompressedInput> compressed;
      std::vector<std::shared_ptr<const CompressedHolding>> held;
      for (std::size_t b = 0; b < size(); ++b) {
        responses.push_back(
            part(b).body->response([&](const Vector& u) { return pulled(b, u); }));
        compressed.push_back(
            {part(b).space, part(b).multiplier, inputs[b].lame, part(b).opposite.get()});
        held.push_back(part(b).body->compressed());
      }
      numbers = condense(Flexibility(compressedFlexibility(
                             makeCompressedCoupling(
                                 compressed, inputs.front().stabilization, part(0).units),
                             std::move(held))),
                         responses);
    } else {
      for (std::size_t b = 0; b < size(); ++b)
        responses.push_back(part(b).body->response(coupling(b)));
      numbers = condense(part(0).algebra, multiplierMass(), responses);
    }
    numbers.normals = numbering.normals();
    if (freeMotions() > 0)
      numbers.rigid = withRigidBodies(numbers.rigid);
    finish();
  }

  /// The numbers of another time from those of this one.
  void respondAll(const Parts& same) {
    numbers = same.numbers.copy();
    numbers.tangentials.clear();
    numbers.rigidLoad.clear();
    numbers.offset.assign(at(numbering.size()), 0.0);
    for (std::size_t b = 0; b < size(); ++b) {
      const ElasticBody& body = *part(b).body;
      axpy(1, pulled(b, body.unpushed()), numbers.offset);
      const Vector load = body.rigidLoad();
      numbers.rigidLoad.insert(numbers.rigidLoad.end(), load.begin(), load.end());
    }
    finish();
  }

  /// Cᵀ λ of the multipliers of all other bodies against this one; empty: it meets none.
  Vector pressed(std::size_t b, const std::vector<State>& states) const {
    Vector force;
    for (const Met& other : couplings->met[b]) {
      const Vector& multiplier = states[other.carrier].multiplier;
      force.resize(bodies[b].load().size());
      if (!multiplier.empty())
        other.coupling.push(multiplier, force);
    }
    return force;
  }

  /// visit(body, component) of each free motion of bodies that do not deform.
  template <class Visit>
  void forEachFree(const Visit& visit) const {
    for (std::size_t k = 0; k < drives.size(); ++k)
      for (std::size_t c = 0; c < 3; ++c)
        if (drives[k].components[c].free)
          visit(k, c);
  }

  Index freeMotions() const {
    Index count = 0;
    forEachFree([&](std::size_t, std::size_t) { ++count; });
    return count;
  }

  Matrix withRigidBodies(const Matrix& elastic) const {
    Matrix all(numbering.size(), elastic.columns() + freeMotions());
    Index column = 0;
    for (; column < elastic.columns(); ++column)
      std::copy_n(elastic.column(column), elastic.rows(), all.column(column));
    forEachFree([&](std::size_t k, std::size_t c) {
      const double* trace = couplings->rigid[k].traces.column(static_cast<Index>(c));
      std::transform(trace, trace + numbering.size(), all.column(column++),
                     [](double value) { return -value; });
    });
    return all;
  }

  /// What a motion about the reference point has in the units of its trace, or a moment.
  double scaleOf(std::size_t k, std::size_t c) const {
    const double lever = couplings->rigid[k].lever;
    return c == 2 && lever > 0 ? lever : 1;
  }

  /// Gaps, given motions and forces of bodies that do not deform, bounds and scales.
  void finish() {
    gap.assign(at(numbering.normals()), 0.0);
    jump.assign(at(numbering.size()), 0.0);
    for (std::size_t b = 0; b < size(); ++b) {
      const ContactProblem::Parts& own = part(b);
      for (const Tangential& tangential : own.numbers.tangentials)
        numbers.tangentials.push_back(tangential.shifted(numbering(b, 0)));
      for (Index i = 0; i < numbering.sizeOf(b); ++i) {
        const Index k = numbering(b, i);
        jump[at(k)] = own.obstacle.jump[at(i)];
        numbers.offset[at(k)] -= jump[at(k)];
        if (i >= numbering.normalsOf(b))
          continue;
        gap[at(k)] = own.obstacle.gap[at(i)];
        numbers.offset[at(k)] -= gap[at(k)];
      }
    }
    for (std::size_t k = 0; k < drives.size(); ++k)
      for (std::size_t c = 0; c < 3; ++c) {
        const Drive::Component& component = drives[k].components[c];
        if (component.free)
          numbers.rigidLoad.push_back(component.value / scaleOf(k, c));
        else if (component.value != 0)
          for (Index i = 0; i < numbering.size(); ++i)
            numbers.offset[at(i)] -= scaleOf(k, c) * component.value *
                                     couplings->rigid[k].traces(i, static_cast<Index>(c));
      }
    setScale(loadSize());
  }

  void setScale(double load) {
    numbers.stress = load > 0 ? load : 1;
    for (std::size_t b = 0; b < size(); ++b)
      part(b).numbers.stress = numbers.stress;
  }

  double loadSize() const {
    double load = 0;
    for (std::size_t b = 0; b < size(); ++b)
      load += part(b).size();
    for (std::size_t k = 0; k < drives.size(); ++k) {
      const RigidTraces& met = couplings->rigid[k];
      bem::Vec2 slide;
      double others = 0;  // turning, and forces as pressures on what is met
      for (std::size_t c = 0; c < 3; ++c) {
        const auto& [free, value] = drives[k].components[c];
        if (free)
          others += met.length > 0 ? std::abs(value) / scaleOf(k, c) / met.length : 0;
        else if (c == 2)
          others += met.lever * std::abs(value);
        else
          (c == 0 ? slide.x : slide.y) = value;
      }
      load += norm(slide) + others;
    }
    return load;
  }
};

ContactSystem::ContactSystem(const std::vector<ContactProblem::Input>& inputs,
                             const std::vector<Drive>& rigid) {
  assert(!inputs.empty());
  std::vector<ContactProblem> bodies;
  std::vector<Numbering::Count> counts;
  for (const ContactProblem::Input& input : inputs) {
    bodies.push_back(ContactProblem(std::make_unique<ContactProblem::Parts>(input)));
    const MultiplierSpace& multiplier = bodies.back().multiplier();
    counts.push_back({multiplier.normals(), multiplier.size()});
  }
  parts_ = std::make_unique<Parts>(Parts{std::move(bodies), Numbering(counts), rigid});
  parts_->meet(inputs);
  parts_->condenseAll(inputs);
}

ContactSystem::ContactSystem(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

ContactSystem ContactSystem::under(const Step& step) const {
  assert(step.conditions.size() == size() && step.rigid.size() == drives().size());
  std::vector<ContactProblem> bodies;
  for (std::size_t b = 0; b < size(); ++b)
    bodies.push_back(ContactProblem(
        std::make_unique<ContactProblem::Parts>(*body(b).parts_, step.conditions[b])));
  auto parts = std::make_unique<Parts>(
      Parts{std::move(bodies), numbering(), step.rigid, parts_->couplings});
  parts->respondAll(*parts_);
  parts->setScale(std::max(parts->loadSize(), step.largestLoad));
  if (!step.slipBefore.empty()) {
    parts->numbers = withSlipBefore(parts->numbers, step.slipBefore);
    parts->slipBefore = step.slipBefore;
  }
  return ContactSystem(std::move(parts));
}

Vector ContactSystem::slipSoFar(const State& state) const {
  Vector total = slip(parts_->numbers, state);
  if (!parts_->slipBefore.empty())
    axpy(1, parts_->slipBefore, total);
  return total;
}

double ContactSystem::loadSize() const { return parts_->loadSize(); }

ContactSystem::~ContactSystem() = default;
ContactSystem::ContactSystem(ContactSystem&&) noexcept = default;

std::size_t ContactSystem::size() const { return parts_->size(); }
const ContactProblem& ContactSystem::body(std::size_t b) const {
  return parts_->bodies[b];
}
const Problem& ContactSystem::numbers() const { return parts_->numbers; }
const Vector& ContactSystem::gap() const { return parts_->gap; }
const Vector& ContactSystem::jump() const { return parts_->jump; }

const Numbering& ContactSystem::numbering() const { return parts_->numbering; }

const std::vector<Drive>& ContactSystem::drives() const { return parts_->drives; }

State ContactSystem::joined(const std::vector<State>& states,
                            const std::vector<RigidMotion>& rigid) const {
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
  if (!all.rigid.empty() || !rigid.empty()) {
    all.rigid.resize(at(numbers().rigidMotions() - parts_->freeMotions()), 0.0);
    parts_->forEachFree([&](std::size_t k, std::size_t c) {
      const RigidMotion motion = rigid.empty() ? RigidMotion{} : rigid[k];
      const double components[] = {motion.slide.x, motion.slide.y, motion.turn};
      all.rigid.push_back(parts_->scaleOf(k, c) * components[c]);
    });
  }
  return all;
}

Configuration ContactSystem::configuration(State state) const {
  Configuration result;
  if (state.multiplier.empty())
    state.multiplier.assign(at(numbering().size()), 0.0);
  if (state.rigid.empty())
    state.rigid.assign(at(numbers().rigidMotions()), 0.0);
  auto motions = state.rigid.begin();
  for (std::size_t b = 0; b < size(); ++b) {
    State own;
    for (Index i = 0; i < numbering().sizeOf(b); ++i)
      own.multiplier.push_back(state.multiplier[at(numbering()(b, i))]);
    own.rigid.assign(motions, motions + body(b).freeMotions());
    motions += body(b).freeMotions();
    result.bodies.push_back(std::move(own));
  }
  for (std::size_t b = 0; b < size(); ++b) {
    result.met.push_back(parts_->pressed(b, result.bodies));
    result.displacements.push_back(body(b).displacement(result.bodies[b], result.met[b]));
  }
  for (std::size_t k = 0; k < drives().size(); ++k) {
    double components[3];
    for (std::size_t c = 0; c < 3; ++c) {
      const Drive::Component& drive = drives()[k].components[c];
      components[c] = drive.free ? *motions++ / parts_->scaleOf(k, c) : drive.value;
    }
    result.rigid.push_back({{components[0], components[1]}, components[2]});
  }
  result.state = std::move(state);
  return result;
}

std::vector<std::array<double, 3>> ContactSystem::rigidForces(const State& state) const {
  std::vector<std::array<double, 3>> forces(drives().size());
  for (std::size_t k = 0; k < forces.size() && !state.multiplier.empty(); ++k)
    for (std::size_t c = 0; c < 3; ++c) {
      const double* trace =
          parts_->couplings->rigid[k].traces.column(static_cast<Index>(c));
      forces[k][c] =
          parts_->scaleOf(k, c) * std::inner_product(state.multiplier.begin(),
                                                     state.multiplier.end(), trace, 0.0);
    }
  return forces;
}

double ContactSystem::strainEnergy(const Configuration& at) const {
  double sum = 0;
  for (std::size_t b = 0; b < size(); ++b)
    sum += body(b).strainEnergy(at.bodies[b], at.displacements[b]);
  return sum;
}

double ContactSystem::storedEnergy(const Configuration& at) const {
  double sum = 0;
  for (std::size_t b = 0; b < size(); ++b)
    sum += body(b).storedEnergy(at.bodies[b], at.displacements[b]);
  return sum;
}

}  // namespace epafi::contact
