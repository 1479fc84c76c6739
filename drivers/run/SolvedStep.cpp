#include "drivers/run/SolvedStep.hpp"

#include "adaptivity/refine/Refine.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/equation/Classify.hpp"
#include "contact/path/PathMemory.hpp"

#include <algorithm>
#include <utility>

namespace epafi::drivers {

namespace {

/// Does a contact end at a line of symmetry, where its mirror image goes on?
bool touchesLine(const contact::Solved& solved, const std::string& name) {
  const bem::Mesh& mesh = solved.space.mesh();
  const contact::ContactFields fields(solved);
  const auto& elements = fields.elements();
  return std::any_of(elements.begin(), elements.end(), [&](const auto& element) {
    const bem::Element& side = mesh[element.element];
    return contact::nameOf(element) == name &&
           (mesh.boundary(side.previous) == Symmetry::boundary ||
            mesh.boundary(side.next) == Symmetry::boundary);
  });
}

contact::Configuration atRest(const BodySpaces& spaces) {
  contact::Configuration at;
  for (std::size_t b = 0; b < spaces.size(); ++b)
    at.displacements.emplace_back(bem::at(spaces.space(b).displacements()));
  at.rigid.resize(spaces.scene().rigid.size());
  return at;
}

}  // namespace

SolvedPart::SolvedPart(const BodySpaces& spaces)
    : at(atRest(spaces)), motions(spaces.motions(at.displacements, at.rigid)) {}

SolvedPart::SolvedPart(const BodySpaces& spaces,
                       std::shared_ptr<const Conditions> conditions_,
                       contact::Configuration at_)
    : conditions(std::move(conditions_)),
      at(std::move(at_)),
      motions(spaces.motions(at.displacements, at.rigid)) {
  for (const contact::Conditions& ofBody : *conditions)
    motions.inside.push_back(ofBody.inside);
}

SolvedStep::SolvedStep(const BodySpaces& spaces_,
                       std::shared_ptr<const Conditions> conditions_,
                       std::shared_ptr<const contact::ContactSystem> system_,
                       contact::Configuration at_,
                       std::shared_ptr<const SolvedPart> before_, contact::Wear wear_)
    : SolvedPart(spaces_, std::move(conditions_), std::move(at_)),
      spaces(spaces_),
      before(std::move(before_)),
      system(std::move(system_)),
      wear(std::move(wear_)) {
  const std::size_t count = system->size();
  bodies.reserve(count);
  for (std::size_t b = 0; b < count; ++b) {
    densities.push_back(at.results[b].density);
    contact::Solved& solved = bodies.emplace_back(contact::Solved{
        spaces.space(b), system->body(b), (*conditions)[b], spaces.scene().units(),
        at.state, at.displacements[b], at.contactForces[b], at.results[b]});
    solved.motions = &motions;
    if (!wear.depth.empty())
      solved.wear = &wear;
    solved.displacementBefore = &before->motions.displacements[b];
    solved.motionsBefore = &before->motions;
    if (before->conditions) {
      solved.stateBefore = &before->at.state;
      solved.conditionsBefore = &(*before->conditions)[b];
    }
  }
}

SolvedState SolvedStep::fields() const {
  SolvedState fields;
  fields.t = row.t;
  fields.state = at.state;
  fields.displacement = at.displacements;
  fields.density = densities;
  fields.rigid = at.rigid;
  fields.states = contact::classify(system->numbers(), at.state, at.penetration);
  return fields;
}

const std::vector<contact::Summary>& SolvedStep::summaries() const {
  if (summaries_.empty())
    summaries_ = contact::summarizeAll(bodies);
  return summaries_;
}

double SolvedStep::largestDisplacement() const {
  double largest = 0;
  for (const bem::Vector& displacement : at.displacements)
    largest = std::max(largest, bem::largestEntry(displacement));
  return largest;
}

SolvedStep::Storable SolvedStep::storable() const {
  Storable energy;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const double mu = motions.shearModuli[b] * spaces.scene().energy();
    const contact::Loads& loads = system->body(b).loads();
    const double inside = loads.inside.largestDeformation;
    const double largest = std::max({bem::largestEntry(at.displacements[b]), inside,
                                     loads.largestTraction / motions.shearModuli[b]});
    const double digits =
        1e-12 + 16 * adaptivity::spacing(spaces.space(b).mesh().outline());
    energy.inside = std::max(energy.inside, mu * inside * inside);
    energy.rounding = std::max(energy.rounding, mu * largest * largest * digits * digits);
  }
  return energy;
}

void SolvedStep::addRigid(StepRow& filled) const {
  const Scene& scene = spaces.scene();
  const bem::Units units = scene.units();
  const double force = units.force();
  const auto forces = system->rigidForces(at.state);
  for (std::size_t k = 0; k < forces.size(); ++k) {
    contact::Summary& summary = filled.rigid[k].second;
    summary.motion = at.rigid[k];
    summary.motion.slide = units.length * summary.motion.slide;
    const double scales[] = {force, force, force * units.length};
    constexpr double contact::Resultant::*members[] = {
        &contact::Resultant::x, &contact::Resultant::y, &contact::Resultant::moment};
    for (std::size_t c = 0; c < 3; ++c) {
      const contact::Drive::Component& drive = system->drives()[k].components[c];
      summary.contact.*members[c] = scales[c] * forces[k][c];
      summary.inside.*members[c] = scales[c] * drive.inside;
      const double load = drive.free ? drive.value : 0;
      summary.load.*members[c] = scales[c] * load;
      if (!drive.free || drive.stiffness > 0)
        summary.reaction.*members[c] = -scales[c] * (forces[k][c] + drive.inside + load);
    }
    const RigidBody& body = scene.rigid[k];
    summary = wholeOf(scene.symmetry, *body.outline, summary, body.pole);
  }
}

void SolvedStep::addContacts(StepRow& filled) const {
  const Scene& scene = spaces.scene();
  auto contact = filled.contacts.begin();
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const bem::Outline& outline = *scene.bodies[b].outline;
    const bool isCut = scene.symmetry.cuts(outline);
    auto work = contact::frictionWorkOfContacts(system->body(b), frictionWork);
    for (const auto& [name, summary] : contact::summarizeContacts(bodies[b])) {
      contact->second = wholeOf(scene.symmetry, outline, summary);
      if (!touchesLine(bodies[b], name))
        contact->second.forceTangential = (isCut ? 2 : 1) * summary.forceTangential;
      const double share = isCut ? 1 : 1 / scene.symmetry.copies();
      contact->second.dissipated = share * scene.energy() * work[name];
      ++contact;
    }
  }
}

}  // namespace epafi::drivers
