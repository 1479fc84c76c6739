#include "drivers/scene/Scene.hpp"

#include <cmath>

namespace epafi::drivers {

Scene::MetEdges Scene::metEdges(const ContactPair& pair) const {
  const bem::Outline& outline = outlineOf(pair.met);
  const double ratio = outline.scaling().length / units().length;
  MetEdges met;
  for (std::size_t e = 0; e < outline.edges().size(); ++e) {
    const bem::Edge& edge = outline.edges()[e];
    if (edge.boundary != pair.met.boundary)
      continue;
    met.edges.push_back(static_cast<int>(e));
    met.curves.emplace_back(ratio * edge.curve.from(), ratio * edge.curve.to(),
                            std::tan(edge.curve.angle() / 4));
  }
  return met;
}

}  // namespace epafi::drivers
