#include "contact/system/ContactSystem.hpp"

#include "bem/algebra/DenseAlgebra.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/body/IterativeRefinement.hpp"
#include "contact/compressed/CompressedFlexibility.hpp"
#include "contact/compressed/CompressedStiffness.hpp"
#include "contact/system/BodyLoadTerms.hpp"
#include "contact/system/Couplings.hpp"
#include "contact/system/RigidDrives.hpp"

#include <algorithm>
#include <cassert>

namespace epafi::contact {

using bem::axpy;

struct ContactSystem::Parts {
  Parts(std::vector<ContactProblem> all, const Numbering& numbers_,
        std::shared_ptr<const Couplings> coupled, RigidDrives drives,
        const std::vector<Wear>& wearBefore)
      : bodies(std::move(all)),
        numbering(numbers_),
        couplings(std::move(coupled)),
        rigid(std::move(drives)),
        wear(bodies, numbering, wearBefore) {}

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
  bool isFormed() const { return bodies.front().stiffness().isFormed(); }
  /// C_b u
  Vector apply(std::size_t b, const Vector& u) const {
    return couplings->gathered(b, bodies[b].form().apply(u), u);
  }

  ///   D = Σ_b C_b A_b⁺ C_bᵀ + M,   C A⁺ Cᵀ = (L⁻¹ Cᵀ)ᵀ L⁻¹ Cᵀ - C R (C R)ᵀ,   G = (C_b R_b)_b
  void condenseAll(const std::vector<BodyInput>& inputs) {
    Matrix d = isFormed() ? couplings->multiplierMass(bodies) : Matrix();
    std::vector<Vector> columns;  // of G
    for (std::size_t b = 0; b < size(); ++b) {
      const Holding& rigidOf = bodies[b].holding();
      for (Index k = 0; k < rigidOf.allowed.columns(); ++k) {
        Vector moved = apply(b, columnOf(rigidOf.allowed, k));
        for (Index j = 0; j < d.columns(); ++j)
          for (Index i = 0; i < d.rows(); ++i)
            d(i, j) -= moved[at(i)] * moved[at(j)];
        if (k >= rigidOf.fixed())
          columns.push_back(std::move(moved));
      }
      if (isFormed())
        d = addGram(std::move(d), bodies[b].stiffness().forward(
                                      couplings->transposed(b, bodies[b].form())));
    }
    for (Index j = 0; j < d.columns(); ++j)
      for (Index i = j + 1; i < d.rows(); ++i)
        d(j, i) = d(i, j);
    rigid.addFreeMotions(columns);
    numbers.rigid = Matrix(numbering.size(), static_cast<Index>(columns.size()));
    for (std::size_t k = 0; k < columns.size(); ++k)
      std::copy(columns[k].begin(), columns[k].end(),
                numbers.rigid.column(static_cast<Index>(k)));
    numbers.flexibility = isFormed() ? Flexibility(std::move(d)) : compressed(inputs);
    numbers.normals = numbering.normals();
    respond();
  }

  Flexibility compressed(const std::vector<BodyInput>& inputs) const {
    std::vector<CompressedInput> parts;
    std::vector<std::shared_ptr<const CompressedHolding>> held;
    for (std::size_t b = 0; b < size(); ++b) {
      parts.push_back({bodies[b].space(), bodies[b].multiplier(), inputs[b].lame,
                       &bodies[b].opposite()});
      held.push_back(
          std::dynamic_pointer_cast<const CompressedHolding>(bodies[b].stiffness_));
    }
    const auto flexibility = std::make_shared<const CompressedFlexibility>(
        makeCompressedCoupling(parts, inputs.front().stabilization, inputs.front().units),
        std::move(held));
    return flexibility->size() <= inputs.front().formedUpTo
               ? Flexibility(flexibility->formed())
               : Flexibility(flexibility);
  }

  /// What loads make of d₀ = Σ_b C_b u_b and q = (R_bᵀ f_b)_b, and all else that is given.
  void respond() {
    numbers.offset.assign(at(numbering.size()), 0.0);
    toLoads.resize(size());
    for (std::size_t b = 0; b < size(); ++b) {
      const auto displacementOfLoads = [&] {
        return apply(b, bodies[b].displacementOfLoads());
      };
      // with a factored matrix a solution costs as little
      axpy(1,
           isFormed() ? displacementOfLoads()
                      : toLoads[b].of(bodies[b].pushing(), displacementOfLoads),
           numbers.offset);
      const Vector load = bodies[b].rigidLoad();
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
      const Obstacle& obstacle = bodies[b].obstacle();
      const MultiplierSpace& multiplier = bodies[b].multiplier();
      if (const auto amplification = multiplier.basis().amplification)
        for (const auto& element : multiplier.elements())
          numbers.amplification =
              std::max(numbers.amplification, amplification(element.degree));
      for (const Tangential& tangential : obstacle.tangentials)
        numbers.tangentials.push_back(tangential.shifted(numbering(b, 0)));
      for (Index i = 0; i < numbering.sizeOf(b); ++i) {
        const Index k = numbering(b, i);
        jump[k] = obstacle.jump[i];
        if (i < numbering.normalsOf(b))
          gap[k] = obstacle.gap[i];
      }
      for (const auto& [row, column, value] : obstacle.surface.linear)
        numbers.surface.linear.push_back(
            {numbering(b, row), numbering(b, column), value});
      for (const auto& [i, length, law] : obstacle.surface.places)
        numbers.surface.places.push_back({numbering(b, i), length, law});
    }
    ofInside = bodyLoadTerms(bodies, numbering);
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
    for (ContactProblem& body : bodies)
      body.numbers_.stress = numbers.stress;
  }

  double loadSize() const {
    double load = rigid.loadSize();
    for (const ContactProblem& body : bodies)
      load += body.loadSize();
    // shear has the size of what presses, however far that slides
    for (std::size_t b = 0; b < size() && load == 0; ++b)
      load = bodies[b].obstacle().largestSliding;
    return load;
  }
};

ContactSystem::ContactSystem(const std::vector<BodyInput>& inputs,
                             const std::vector<Drive>& rigid) {
  assert(!inputs.empty());
  std::vector<ContactProblem> bodies;
  std::vector<Numbering::Count> counts;
  for (const BodyInput& input : inputs) {
    bodies.push_back(ContactProblem(input, ContactProblem::OfSystem()));
    const MultiplierSpace& multiplier = bodies.back().multiplier();
    counts.push_back({multiplier.normals(), multiplier.size()});
  }
  const Numbering numbering(counts);
  auto couplings = std::make_shared<const Couplings>(bodies, numbering);
  RigidDrives drives(rigid, bodies, numbering);
  parts_ = std::make_unique<Parts>(std::move(bodies), numbering, std::move(couplings),
                                   std::move(drives), std::vector<Wear>());
  parts_->condenseAll(inputs);
  parts_->wear.setSlips({}, parts_->numbers.surface);
}

ContactSystem::ContactSystem(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

ContactProblem ContactSystem::onlyBody() && {
  ContactProblem body = std::move(parts_->bodies.front());
  body.numbers_ = std::move(parts_->numbers);
  return body;
}

ContactProblem::ContactProblem(const Input& input)
    : ContactProblem(ContactSystem({input}).onlyBody()) {}

ContactSystem ContactSystem::under(const Step& step) const {
  assert(step.conditions.size() == size() && step.rigid.size() == drives().size());
  std::vector<ContactProblem> bodies;
  for (std::size_t b = 0; b < size(); ++b)
    bodies.push_back(ContactProblem(body(b), step.conditions[b]));
  auto parts = std::make_unique<Parts>(std::move(bodies), numbering(), parts_->couplings,
                                       parts_->rigid.under(step.rigid), step.wearBefore);
  parts->numbers = numbers().copy();
  parts->numbers.tangentials.clear();
  parts->numbers.rigidLoad.clear();
  parts->toLoads = step.responses;
  parts->respond();
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
  for (std::size_t b = 0; b < size(); ++b) {
    Vector own = body(b).form().apply(at.displacements[b]);
    axpy(-1, body(b).form().massTimes(at.bodies[b].multiplier), own);
    axpy(1, parts_->couplings->gathered(b, own, at.displacements[b]), r);
  }
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
    const bem::Mesh& mesh = body(b).space().mesh();
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
    result.oppositeForces.push_back(parts_->couplings->pressOn(b, result.bodies));
    result.displacements.push_back(
        body(b).displacement(result.bodies[b], result.oppositeForces[b]));
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
