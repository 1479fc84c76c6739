#include "contact/system/ContactSystem.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"
#include "contact/body/Beddings.hpp"
#include "contact/body/DenseBody.hpp"
#include "contact/compressed/CompressedFlexibility.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace epafi::contact {

using bem::axpy;
using bem::dot;

namespace {

std::shared_ptr<const Obstacle> obstacleOf(const std::vector<BodyInput>& inputs,
                                           std::shared_ptr<const Opposite> opposite) {
  assert(!inputs.empty());
  const BodyInput& any = inputs.front();
  if (opposite == nullptr)
    opposite = std::make_shared<const Opposite>(any.units.length);
  std::vector<MultiplierSpace::Body> bodies;
  for (const BodyInput& input : inputs)
    bodies.push_back({input.space.mesh(), input.conditions});
  return std::make_shared<const Obstacle>(
      makeObstacle(MultiplierSpace(bodies, any.basis), opposite, any.units));
}

}  // namespace

ContactSystem::ContactSystem(const std::vector<BodyInput>& inputs,
                             const std::vector<Drive>& rigid,
                             std::shared_ptr<const Opposite> opposite)
    : obstacle_(obstacleOf(inputs, std::move(opposite))),
      bodies_(std::make_shared<std::vector<ContactBody>>()),
      rigid_(rigid, multiplier(), *obstacle_->opposite),
      wear_(obstacle_, {}) {
  condense(addBodies(inputs));
  wear_.setSlips({}, numbers_.surface);
  setScale(loadSize());
}

ContactSystem::MakeFlexibility ContactSystem::addBodies(
    const std::vector<BodyInput>& inputs) {
  std::vector<const bem::Space*> spaces;
  std::vector<bem::Lame> lames;
  for (const BodyInput& input : inputs) {
    if (input.basis.sharesNodes && input.stabilization.isOn())
      throw bem::InputError("the multiplier '", input.basis.name,
                            "' needs the stabilisation's form None");
    spaces.push_back(&input.space);
    lames.push_back(input.lame);
  }
  const std::vector<Coupling> plain =
      makeCouplings(spaces, multiplier(), *obstacle_->opposite);
  Index motions = 0;
  const Beddings beddings = makeBeddings(spaces, lames, multiplier(), plain);
  order_ = beddings.order;
  depth_ = beddings.depth;
  const auto tree = inputs.front().stiffness.compressed();
  bool isShared = tree != nullptr;
  for (const BodyInput& input : inputs)
    isShared = isShared && input.stiffness.compressed() == tree;
  std::vector<std::shared_ptr<const ElasticBody>> all;
  std::vector<std::shared_ptr<const CompressedBody>> ofTree;
  for (std::size_t b = 0; b < inputs.size(); ++b) {
    const auto holding = std::make_shared<const Holding>(
        makeHolding(inputs[b].space, inputs[b].conditions));
    if (inputs[b].stiffness.compressed() == nullptr)
      all.push_back(
          makeDenseBody(inputs[b], multiplier(), b, holding, plain[b], beddings.of[b]));
    else
      all.push_back(ofTree.emplace_back(std::make_shared<const CompressedBody>(
          inputs[b], multiplier(), b, holding, plain[b])));
    bodies_->emplace_back(inputs[b], obstacle_, all.back(), b, motions);
    motions += holding->free();
  }
  if (!isShared)
    return [all](const Columns& r, const Columns& s) { return flexibilityOf(all, r, s); };
  return
      [ofTree, normals = multiplier().normals(), formedUpTo = inputs.front().formedUpTo](
          const Columns& /*r*/, const Columns& s) {
        const auto d = std::make_shared<const CompressedFlexibility>(ofTree, normals, s);
        return d->size() <= formedUpTo ? Flexibility(d->formed()) : Flexibility(d);
      };
}

ContactSystem::ContactSystem(const ContactSystem& atZero,
                             const std::vector<Conditions>& conditions,
                             const std::vector<Drive>& drives, const StepMemory& memory)
    : obstacle_(std::make_shared<const Obstacle>(
          makeObstacle(atZero.multiplier().under(conditions), atZero.obstacle_->opposite,
                       atZero.body(0).units()))),
      bodies_(std::make_shared<std::vector<ContactBody>>()),
      order_(atZero.order_),
      depth_(atZero.depth_),
      rigid_(atZero.rigid_.under(drives)),
      wear_(obstacle_, memory.wear),
      numbers_(atZero.numbers_.copy()),
      responses_(memory.responses) {
  assert(drives.size() == atZero.drives().size());
  for (const ContactBody& body : *atZero.bodies_)
    bodies_->push_back(body.under(obstacle_));
  numbers_.rigidLoad.clear();
  respond();
  wear_.setSlips({}, numbers_.surface);
  setScale(std::max(loadSize(), memory.largestLoad));
  if (!memory.defect.empty()) {
    axpy(1, memory.defect, numbers_.offset);
    defectBefore_ = memory.defect;
  }
  if (!memory.slip.empty()) {
    numbers_ = withSlipBefore(numbers_, memory.slip);
    slipBefore_ = memory.slip;
  }
}

///   D = Σ_b B_b A_b⁺ B_bᵀ + M,   G = (B_b R_b)_b,
///
/// less  Σ_k s_k (B r_k)ᵀ + B r_k s_kᵀ  of what Fix holds, see reactionColumns.
void ContactSystem::condense(const MakeFlexibility& makeFlexibility) {
  std::vector<Vector> columns;  // of G
  Columns motions;
  Columns reactions;
  for (std::size_t b = 0; b < size(); ++b) {
    const Holding& holding = body(b).holding();
    motions.push_back(motionsOnContacts(holding, 0, body(b).coupling().trace));
    reactions.push_back(reactionColumns(b, motions.back()));
    columns.insert(columns.end(), motions.back().begin() + holding.fixed(),
                   motions.back().end());
  }
  numbers_.flexibility = makeFlexibility(motions, reactions);
  numbers_.normals = multiplier().normals();
  respond();
  rigid_.setMotions(std::move(columns), numbers_);
}

// With N = B R and the reactions' terms m, forces φ, displacements h = A⁺ φ, means -κ:
//   ρ = Nᵀ λ,   u = -A⁺ Bᵀ λ + h ρ + R β,   β = mᵀ λ - κ ρ - φᵀ u,
//   B u - M λ + m ρ = -(D - s Nᵀ - N sᵀ) λ,   s = m + B h - ½ N (κ + φᵀ h)
std::vector<Vector> ContactSystem::reactionColumns(
    std::size_t b, const std::vector<Vector>& motions) const {
  std::vector<Vector> columns;
  for (const ContactBody::Reaction& reaction : body(b).reactions()) {
    Vector all = body(b).apply(reaction.displacement);
    axpy(1, reaction.residual.terms, all);
    for (std::size_t l = 0; l < body(b).reactions().size(); ++l)
      axpy(0.5 * (reaction.residual.means[l] -
                  dot(body(b).reactions()[l].residual.force, reaction.displacement)),
           motions[l], all);
    columns.push_back(std::move(all));
  }
  return columns;
}

void ContactSystem::respond() {
  numbers_.offset.assign(at(multiplier().size()), 0.0);
  responses_.resize(size());
  for (std::size_t b = 0; b < size(); ++b) {
    const auto ofLoads = [&] {
      return body(b).penetration(body(b).displacementOfLoads(), {}, {});
    };
    // with a factored matrix a solution costs as little
    axpy(1,
         body(b).elastic()->isFormed() ? ofLoads()
                                       : responses_[b].of(body(b).pushing(), ofLoads),
         numbers_.offset);
    const Vector load = body(b).rigidLoad();
    numbers_.rigidLoad.insert(numbers_.rigidLoad.end(), load.begin(), load.end());
  }
  finish();
}

void ContactSystem::finish() {
  numbers_.tangentials = obstacle_->tangentials;
  numbers_.surface = obstacle_->surface;
  if (const auto amplification = multiplier().basis().amplification)
    multiplier().forEachElement([&](const auto& element) {
      numbers_.amplification =
          std::max(numbers_.amplification, amplification(element.degree));
    });
  given_ = obstacle_->given();
  for (const ContactBody& body : *bodies_)
    if (!body.loads().residual.terms.empty())
      axpy(1, body.loads().residual.terms, given_);
  addGiven(numbers_.offset);
  rigid_.addForces(numbers_);
}

void ContactSystem::addGiven(Vector& r) const {
  axpy(1, given_, r);
  if (!wear_.testedBefore().empty())
    axpy(-1, wear_.testedBefore(), r);
  rigid_.addGiven(r);
}

void ContactSystem::setScale(double load) {
  numbers_.stress = load > 0 ? load : 1;
  for (ContactBody& body : *bodies_)
    body.setStress(numbers_.stress);
}

Vector ContactSystem::givenToRigid() const {
  Vector given(at(multiplier().size()));
  addGiven(given);
  for (std::size_t b = 0; b < size(); ++b) {
    const Loads& loads = body(b).loads();
    if (!loads.rigidPart.empty())
      axpy(1, body(b).coupling().trace.apply(loads.rigidPart), given);
    if (!loads.residual.terms.empty())  // no penetration
      axpy(-1, loads.residual.terms, given);
  }
  return given;
}

double ContactSystem::loadSize() const {
  double own = 0;
  Vector given(at(multiplier().size()));
  addGiven(given);
  double moved = bem::largestEntry(given);
  for (std::size_t b = 0; b < size(); ++b) {
    own += body(b).loads().size();
    moved = std::max(moved, bem::largestEntry(body(b).loads().rigidPart));
  }
  return contact::loadSize(numbers_, givenToRigid(), multiplier().lengths(), moved, own,
                           rigid_);
}

State ContactSystem::start() const {
  return {{}, placement(numbers_, givenToRigid(), multiplier().lengths())};
}

Vector ContactSystem::penetration(const Configuration& at,
                                  const std::vector<std::size_t>& bodies) const {
  Vector r(bem::at(multiplier().size()));
  for (const std::size_t b : bodies)
    axpy(1,
         body(b).penetration(at.displacements[b], at.state.multiplier,
                             at.contactForces[b]),
         r);
  addGiven(r);
  for (Index k = elasticMotions(); k < numbers().rigidMotions(); ++k)
    axpy(at.state.rigid[bem::at(k)], columnOf(numbers().rigid, k), r);
  for (std::size_t t = 0; t < slipBefore().size(); ++t)
    r[bem::at(multiplier().normals()) + t] -= slipBefore()[t];
  if (!numbers().surface.empty())
    axpy(-1, numbers().surface.closing(at.state.multiplier), r);
  return r;
}

Vector ContactSystem::slipSoFar(const Configuration& at) const {
  Vector total(at.penetration.begin() + multiplier().normals(), at.penetration.end());
  if (!slipBefore().empty())
    axpy(1, slipBefore(), total);
  return total;
}

Vector ContactSystem::defect(const Configuration& at) const {
  Vector defect = at.penetration;
  axpy(-1, contact::penetration(numbers(), at.state), defect);
  if (!defectBefore_.empty())
    axpy(1, defectBefore_, defect);
  return defect;
}

void ContactSystem::takeDefect(const Configuration& at) {
  Vector defect = this->defect(at);
  axpy(1, defect, numbers_.offset);
  if (!defectBefore_.empty())
    axpy(-1, defectBefore_, numbers_.offset);
  defectBefore_ = std::move(defect);
}

bool ContactSystem::wearsBySlip() const {
  return wear_.wears() && multiplier().size() > multiplier().normals();
}

double ContactSystem::wearBy(const Configuration& at, bem::Matrix response) {
  Surface& surface = numbers_.surface;
  const auto wornBy = [&] {
    Vector worn(at.state.multiplier.size());
    addTimes(1,
             {surface.linear.end() - static_cast<std::ptrdiff_t>(surface.wearing),
              surface.linear.end()},
             at.state.multiplier, worn);
    return worn;
  };
  Vector change = wornBy();
  const double share = wear_.setSlips(at.penetration, surface, std::move(response));
  const Vector worn = wornBy();
  axpy(-1, worn, change);
  const double all = bem::largestEntry(worn);
  return all > 0 ? bem::largestEntry(change) / (std::min(share, 1.0) * all) : 0;
}

State ContactSystem::with(const std::vector<RigidMotion>& motions, State state) const {
  if (!state.rigid.empty() || !motions.empty()) {
    state.rigid.resize(at(elasticMotions()), 0.0);
    rigid_.append(motions, state.rigid);
  }
  return state;
}

Configuration ContactSystem::placed(State state) const {
  Configuration result;
  if (state.multiplier.empty())
    state.multiplier.assign(at(multiplier().size()), 0.0);
  if (state.rigid.empty())
    state.rigid.assign(at(numbers().rigidMotions()), 0.0);
  result.rigid = rigid_.motions(state.rigid.data() + elasticMotions());
  result.state = std::move(state);
  result.displacements.resize(size());
  result.contactForces.resize(size());
  for (const std::size_t b : order_) {
    result.contactForces[b] = body(b).contactForce(result.state.multiplier);
    Vector feet;  // what B u would be by what the bedding stands on
    if (const Bedding& bedding = body(b).elastic()->bedding(); !bedding.rows.empty()) {
      result.displacements[b].assign(result.contactForces[b].size(), 0.0);
      std::vector<std::size_t> both{b};
      if (bedding.holder != b)
        both.push_back(bedding.holder);
      feet = bem::times(-1, penetration(result, both));
    }
    result.displacements[b] =
        body(b).displacement(result.state, result.contactForces[b], feet);
  }
  result.penetration = penetration(result, order_);
  return result;
}

Configuration ContactSystem::withResults(Configuration placed) const {
  placed.results.clear();
  for (std::size_t b = 0; b < size(); ++b)
    placed.results.push_back(
        body(b).results(placed.state, placed.displacements[b], placed.contactForces[b]));
  return placed;
}

double Configuration::strainEnergy() const {
  double sum = 0;
  for (const ContactBody::Results& body : results)
    sum += body.strainEnergy;
  return sum;
}

double Configuration::storedEnergy() const {
  double sum = 0;
  for (const ContactBody::Results& body : results)
    sum += body.storedEnergy;
  return sum;
}

}  // namespace epafi::contact
