#include "contact/system/ElasticBodies.hpp"

#include "bem/base/Error.hpp"
#include "contact/body/DenseBody.hpp"
#include "contact/compressed/CompressedFlexibility.hpp"

namespace epafi::contact {

ElasticBodies makeElasticBodies(const std::vector<BodyInput>& inputs,
                                const Obstacle& obstacle) {
  const MultiplierSpace& multiplier = obstacle.multiplier;
  std::vector<const bem::Space*> spaces;
  ElasticBodies all;
  for (const BodyInput& input : inputs) {
    if (input.basis.sharesNodes && input.stabilization.isOn())
      throw bem::InputError("the multiplier '", input.basis.name,
                            "' needs the stabilisation's form None");
    spaces.push_back(&input.space);
    all.holdings.push_back(
        std::make_shared<const Holding>(makeHolding(input.space, input.conditions)));
  }
  const std::vector<Coupling> plain =
      makeCouplings(spaces, multiplier, *obstacle.opposite);
  if (inputs.front().stiffness.compressed() == nullptr) {
    std::vector<std::shared_ptr<const DenseBody>> bodies;
    for (std::size_t b = 0; b < inputs.size(); ++b)
      bodies.push_back(
          makeDenseBody(inputs[b], multiplier, b, all.holdings[b], plain[b]));
    all.bodies.assign(bodies.begin(), bodies.end());
    all.flexibility = [bodies, size = multiplier.size()](const auto& motions,
                                                         const auto& reactions) {
      return denseFlexibility(bodies, size, motions, reactions);
    };
    return all;
  }
  std::vector<std::shared_ptr<const CompressedBody>> bodies;
  for (std::size_t b = 0; b < inputs.size(); ++b)
    bodies.push_back(std::make_shared<const CompressedBody>(inputs[b], multiplier, b,
                                                            all.holdings[b], plain[b]));
  all.bodies.assign(bodies.begin(), bodies.end());
  all.flexibility = [bodies, normals = multiplier.normals(),
                     formedUpTo = inputs.front().formedUpTo](const auto& /*motions*/,
                                                             const auto& reactions) {
    const auto operators =
        std::make_shared<const CompressedFlexibility>(bodies, normals, reactions);
    return operators->size() <= formedUpTo ? Flexibility(operators->formed())
                                           : Flexibility(operators);
  };
  return all;
}

}  // namespace epafi::contact
