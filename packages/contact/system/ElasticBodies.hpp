#pragma once

#include "contact/body/ElasticBody.hpp"
#include "contact/opposite/Obstacle.hpp"

#include <functional>

namespace epafi::contact {

/// The elastic bodies of a system, all dense or all compressed, and D of them.
struct ElasticBodies {
  std::vector<std::shared_ptr<const Holding>> holdings;
  std::vector<std::shared_ptr<const ElasticBody>> bodies{};
  /// \param motions  by body: B r of the motions that clamps allow, fixed ones first
  /// \param reactions  by body: s_k of what Fix holds, of which D has r_k s_kᵀ + s_k r_kᵀ less
  std::function<Flexibility(const std::vector<std::vector<Vector>>& motions,
                            const std::vector<std::vector<Vector>>& reactions)>
      flexibility{};
};

/// \throws see ContactSystem
ElasticBodies makeElasticBodies(const std::vector<BodyInput>& inputs,
                                const Obstacle& obstacle);

}  // namespace epafi::contact
