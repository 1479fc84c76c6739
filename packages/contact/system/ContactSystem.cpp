#include "contact/system/ContactSystem.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/body/IterativeRefinement.hpp"
#include "contact/compressed/CompressedFlexibility.hpp"
#include "contact/compressed/CompressedStiffness.hpp"
#include "contact/system/InsideTerms.hpp"
#include "contact/system/RigidDrives.hpp"

#include <algorithm>
#include <cassert>

namespace epafi::contact {

using bem::axpy;

struct ContactSystem::Parts {
  std::vector<ContactProblem> bodies;
  Numbering numbering;
  std::shared_ptr<const Couplings> couplings;
  RigidDrives rigid;
  StepWear wear;
  Problem numbers{};
  Vector gap{};
  Vector jump{};
  Vector ofInside{};
  Vector slipBefore{};
  Vector defectBefore{};
  std::vector<LoadResponses> toLoads{};

  std::size_t size() const { return bodies.size(); }
  const BodyParts& part(std::size_t b) const { return *bodies[b].parts_; }
  static AllBodyParts partsOf(const std::vector<ContactProblem>& bodies) {
    AllBodyParts parts;
    for (const ContactProblem& body : bodies)
      parts.push_back(body.parts_.get());
    return parts;
  }

  void condenseAll(const std::vector<BodyInput>& inputs) {
    std::vector<ElasticBody::Response> responses;
    if (part(0).body->compressed() != nullptr) {
      std::vector<CompressedInput> compressed;
      std::vector<std::shared_ptr<const CompressedHolding>> held;
      for (std::size_t b = 0; b < size(); ++b) {
        responses.push_back(part(b).body->response(
            [&](const Vector& u) { return couplings->pull(b, part(b), u); }));
        compressed.push_back(
            {part(b).space, part(b).multiplier, inputs[b].lame, part(b).opposite.get()});
        held.push_back(part(b).body->compressed());
      }
      const auto flexibility = std::make_shared<const CompressedFlexibility>(
          makeCompressedCoupling(compressed, inputs.front().stabilization, part(0).units),
          std::move(held));
      numbers = condense(flexibility->size() <= inputs.front().formedUpTo
                             ? Flexibility(flexibility->formed())
                             : Flexibility(flexibility),
                         responses);
    } else {
      for (std::size_t b = 0; b < size(); ++b)
        responses.push_back(part(b).body->response(couplings->transposed(b, part(b))));
      numbers = condense(couplings->multiplierMass(partsOf(bodies)), responses);
    }
    numbers.normals = numbering.normals();
    if (rigid.freeMotions() > 0)
      numbers.rigid = rigid.withFreeMotions(numbers.rigid);
    finish();
  }

  /// The numbers of another time from those of this one.
  void respondAll(const Parts& same) {
    numbers = same.numbers.copy();
    numbers.tangentials.clear();
    numbers.rigidLoad.clear();
    numbers.offset.assign(numbering.size(), 0.0);
    for (std::size_t b = 0; b < size(); ++b) {
      const ElasticBody& body = *part(b).body;
      const auto respond = [&] { return couplings->pull(b, part(b), body.unpushed()); };
      // with a factored matrix a solution costs as little
      axpy(1,
           body.compressed() != nullptr ? toLoads[b].of(body.pushing(), respond)
                                        : respond(),
           numbers.offset);
      const Vector load = body.rigidLoad();
      numbers.rigidLoad.insert(numbers.rigidLoad.end(), load.begin(), load.end());
    }
    finish();
  }

  /// Gaps, jumps, given motions and forces of bodies that do not deform, bounds and scales.
  void finish() {
    numbers.surface = {};
    gap.assign(numbering.normals(), 0.0);
    jump.assign(numbering.size(), 0.0);
    for (std::size_t b = 0; b < size(); ++b) {
      const BodyParts& own = part(b);
      if (const auto amplification = own.multiplier.basis().amplification)
        for (const auto& element : own.multiplier.elements())
          numbers.amplification =
              std::max(numbers.amplification, amplification(element.degree));
      for (const Tangential& tangential : own.numbers.tangentials)
        numbers.tangentials.push_back(tangential.shifted(numbering(b, 0)));
      for (Index i = 0; i < numbering.sizeOf(b); ++i) {
        const Index k = numbering(b, i);
        jump[k] = own.obstacle.jump[i];
        if (i < numbering.normalsOf(b))
          gap[k] = own.obstacle.gap[i];
      }
      for (const auto& [row, column, value] : own.obstacle.surface.linear)
        numbers.surface.linear.push_back(
            {numbering(b, row), numbering(b, column), value});
      for (const auto& [i, length, law] : own.obstacle.surface.places)
        numbers.surface.places.push_back({numbering(b, i), length, law});
    }
    ofInside = insideTerms(partsOf(bodies), numbering);
    addGiven(numbers.offset);
    rigid.addForces(numbers);
    setScale(loadSize());
  }

  /// What is given of r: all that does not come from elastic bodies or free motions.
  void addGiven(Vector& r) const {
    axpy(-1, jump, r);
    for (std::size_t i = 0; i < gap.size(); ++i)
      r[i] -= gap[i];
    if (!ofInside.empty())
      axpy(1, ofInside, r);
    if (!wear.testedBefore().empty())
      axpy(-1, wear.testedBefore(), r);
    rigid.addGiven(r);
  }

  void setScale(double load) {
    numbers.stress = load > 0 ? load : 1;
    for (const ContactProblem& body : bodies)
      body.parts_->numbers.stress = numbers.stress;
  }

  double loadSize() const {
    double load = rigid.loadSize();
    for (std::size_t b = 0; b < size(); ++b)
      load += part(b).size();
    // shear has the size of what presses, however far that slides
    for (std::size_t b = 0; b < size() && load == 0; ++b)
      load = part(b).obstacle.largestSliding;
    return load;
  }
};

ContactSystem::ContactSystem(const std::vector<BodyInput>& inputs,
                             const std::vector<Drive>& rigid) {
  assert(!inputs.empty());
  std::vector<ContactProblem> bodies;
  std::vector<Numbering::Count> counts;
  for (const BodyInput& input : inputs) {
    bodies.push_back(ContactProblem(std::make_unique<BodyParts>(input)));
    const MultiplierSpace& multiplier = bodies.back().multiplier();
    counts.push_back({multiplier.normals(), multiplier.size()});
  }
  const Numbering numbering(counts);
  const AllBodyParts all = Parts::partsOf(bodies);
  parts_ =
      std::make_unique<Parts>(Parts{std::move(bodies),
                                    numbering,
                                    std::make_shared<const Couplings>(all, numbering),
                                    {rigid, all, numbering},
                                    {all, numbering, {}}});
  parts_->condenseAll(inputs);
  parts_->wear.setSlips({}, parts_->numbers.surface);
}

ContactSystem::ContactSystem(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

ContactProblem::ContactProblem(const BodyInput& input) {
  ContactSystem alone({input});
  parts_ = std::move(alone.parts_->bodies.front().parts_);
  parts_->numbers = std::move(alone.parts_->numbers);
}

ContactSystem ContactSystem::under(const Step& step) const {
  assert(step.conditions.size() == size() && step.rigid.size() == drives().size());
  std::vector<ContactProblem> bodies;
  for (std::size_t b = 0; b < size(); ++b)
    bodies.push_back(
        ContactProblem(std::make_unique<BodyParts>(*body(b).parts_, step.conditions[b])));
  const AllBodyParts all = Parts::partsOf(bodies);
  auto parts = std::make_unique<Parts>(Parts{std::move(bodies),
                                             numbering(),
                                             parts_->couplings,
                                             parts_->rigid.under(step.rigid),
                                             {all, numbering(), step.wearBefore}});
  parts->toLoads = step.responses;
  parts->toLoads.resize(size());
  parts->respondAll(*parts_);
  parts->wear.setSlips({}, parts->numbers.surface);
  parts->setScale(std::max(parts->loadSize(), step.largestLoad));
  if (!step.defectBefore.empty()) {
    axpy(1, step.defectBefore, parts->numbers.offset);
    parts->defectBefore = step.defectBefore;
  }
  if (!step.slipBefore.empty()) {
    parts->numbers = withSlipBefore(parts->numbers, step.slipBefore);
    parts->slipBefore = step.slipBefore;
  }
  return ContactSystem(std::move(parts));
}

Vector ContactSystem::penetration(const Configuration& at) const {
  Vector r(numbering().size());
  for (std::size_t b = 0; b < size(); ++b)
    axpy(1,
         parts_->couplings->contactTerms(b, parts_->part(b), at.displacements[b],
                                         at.bodies[b].multiplier),
         r);
  parts_->addGiven(r);
  const Index ofRigid = parts_->rigid.freeMotions();
  for (Index k = numbers().rigidMotions() - ofRigid; k < numbers().rigidMotions(); ++k)
    axpy(at.state.rigid[k], columnOf(numbers().rigid, k), r);
  for (std::size_t t = 0; t < slipBefore().size(); ++t)
    r[numbering().normals() + t] -= slipBefore()[t];
  if (!numbers().surface.empty())
    axpy(-1, numbers().surface.closing(at.state.multiplier), r);
  return r;
}

Vector ContactSystem::lengths() const {
  Vector all(numbering().size());
  for (std::size_t b = 0; b < size(); ++b) {
    const bem::Mesh& mesh = parts_->part(b).space.mesh();
    for (const auto& element : body(b).multiplier().elements()) {
      const double share = 2 * mesh[element.element].half / (element.degree + 1);
      for (int i = 0; i <= element.degree; ++i) {
        all[numbering()(b, element.normalOf(i))] += share;
        if (element.tangential >= 0)
          all[numbering()(b, element.tangentialOf(i))] += share;
      }
    }
  }
  return all;
}

Vector ContactSystem::slipSoFar(const Configuration& at) const {
  Vector total(at.penetration.begin() + numbering().normals(), at.penetration.end());
  if (!slipBefore().empty())
    axpy(1, slipBefore(), total);
  return total;
}

Vector ContactSystem::defect(const Configuration& at) const {
  Vector defect = at.penetration;
  axpy(-1, contact::penetration(numbers(), at.state), defect);
  if (!parts_->defectBefore.empty())
    axpy(1, parts_->defectBefore, defect);
  return defect;
}

const Vector& ContactSystem::slipBefore() const { return parts_->slipBefore; }

const std::vector<LoadResponses>& ContactSystem::responses() const {
  return parts_->toLoads;
}

bool ContactSystem::wearsBySlip() const {
  return parts_->wear.wears() &&
         std::any_of(parts_->bodies.begin(), parts_->bodies.end(),
                     [](const ContactProblem& body) {
                       return body.multiplier().size() > body.multiplier().normals();
                     });
}

double ContactSystem::wearBy(const Configuration& at) {
  Surface& surface = parts_->numbers.surface;
  const auto wornBy = [&] {
    Vector worn(numbering().size());
    addTimes(1,
             {surface.linear.end() - static_cast<std::ptrdiff_t>(surface.wearing),
              surface.linear.end()},
             at.state.multiplier, worn);
    return worn;
  };
  Vector change = wornBy();
  parts_->wear.setSlips(at.penetration, surface);
  const Vector worn = wornBy();
  axpy(-1, worn, change);
  const double all = largestEntry(worn);
  return all > 0 ? largestEntry(change) / all : 0;
}

const StepWear& ContactSystem::wear() const { return parts_->wear; }

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
const Vector& ContactSystem::ofInside() const { return parts_->ofInside; }
const Numbering& ContactSystem::numbering() const { return parts_->numbering; }
const std::vector<Drive>& ContactSystem::drives() const { return parts_->rigid.drives(); }

State ContactSystem::joined(const std::vector<State>& states,
                            const std::vector<RigidMotion>& rigid) const {
  State all;
  const bool empty = std::all_of(states.begin(), states.end(),
                                 [](const State& s) { return s.multiplier.empty(); });
  if (!empty)
    all.multiplier.assign(numbering().size(), 0.0);
  for (std::size_t b = 0; b < states.size(); ++b) {
    for (std::size_t i = 0; i < states[b].multiplier.size(); ++i)
      all.multiplier[numbering()(b, static_cast<Index>(i))] = states[b].multiplier[i];
    all.rigid.insert(all.rigid.end(), states[b].rigid.begin(), states[b].rigid.end());
  }
  if (!all.rigid.empty() || !rigid.empty()) {
    all.rigid.resize(numbers().rigidMotions() - parts_->rigid.freeMotions(), 0.0);
    parts_->rigid.append(rigid, all.rigid);
  }
  return all;
}

Configuration ContactSystem::configuration(State state) const {
  Configuration result;
  if (state.multiplier.empty())
    state.multiplier.assign(numbering().size(), 0.0);
  if (state.rigid.empty())
    state.rigid.assign(numbers().rigidMotions(), 0.0);
  const double* motions = state.rigid.data();
  for (std::size_t b = 0; b < size(); ++b) {
    State own;
    for (Index i = 0; i < numbering().sizeOf(b); ++i)
      own.multiplier.push_back(state.multiplier[numbering()(b, i)]);
    own.rigid.assign(motions, motions + body(b).freeMotions());
    motions += body(b).freeMotions();
    result.bodies.push_back(std::move(own));
  }
  for (std::size_t b = 0; b < size(); ++b) {
    result.met.push_back(parts_->couplings->pressOn(b, parts_->part(b), result.bodies));
    result.displacements.push_back(body(b).displacement(result.bodies[b], result.met[b]));
  }
  result.rigid = parts_->rigid.motions(motions);
  result.state = std::move(state);
  result.penetration = penetration(result);
  return result;
}

std::vector<std::array<double, 3>> ContactSystem::rigidForces(const State& state) const {
  return parts_->rigid.forces(state.multiplier);
}

double ContactSystem::energyOfSprings(const State& state) const {
  return parts_->rigid.energyOfSprings(state.multiplier);
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
