#include "drivers/scene/Scene.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::drivers {

namespace {

/// An edge of an outline in another unit of length.
bem::Curve inUnits(double length, const bem::Outline& outline, const bem::Edge& edge) {
  const double ratio = outline.scaling().length / length;
  return {ratio * edge.curve.from(), ratio * edge.curve.to(),
          std::tan(edge.curve.angle() / 4)};
}

}  // namespace

Scene::OppositeEdges Scene::oppositeEdges(const ContactPair& pair) const {
  const bem::Outline& outline = outlineOf(pair.opposite);
  std::vector<int> edges;
  std::vector<bem::Curve> curves;
  for (std::size_t e = 0; e < outline.edges().size(); ++e) {
    const bem::Edge& edge = outline.edges()[e];
    if (edge.boundary != pair.opposite.boundary)
      continue;
    edges.push_back(static_cast<int>(e));
    curves.push_back(inUnits(units().length, outline, edge));
  }
  return {std::move(edges), bem::CurveTree(std::move(curves))};
}

bem::Visibility Scene::visibility(const ContactPair& pair) const {
  constexpr double touching = 1e-9;  // of the smaller body
  const bem::Outline& side = outlineOf(pair.side);
  const bem::Outline& opposite = outlineOf(pair.opposite);
  std::vector<bem::Curve> own;
  if (!pair.side.isOnBodyOf(pair.opposite))
    for (const bem::Edge& edge : side.edges())
      own.push_back(edge.curve.moved(shift(pair)));
  std::vector<bem::Curve> others;
  for (const bem::Edge& edge : opposite.edges())
    others.push_back(inUnits(units().length, opposite, edge));
  return {std::move(own), std::move(others),
          touching * std::min(side.diameter(), opposite.diameter()) / units().length};
}

std::vector<contact::Drive> Scene::drivesAt(double t) const {
  const double length = units().length;
  const double force = units().force();
  const double forces[] = {force, force, force * length};
  const double motions[] = {length, length, 1};
  std::vector<contact::Drive> drives;
  for (const RigidBody& body : rigid) {
    contact::Drive drive;
    const contact::Resultant inside = body.inside ? body.inside(t) : contact::Resultant{};
    const double ofInside[] = {inside.x, inside.y, inside.moment};
    for (std::size_t c = 0; c < 3; ++c) {
      const RigidBody::Component& component = body.components[c];
      const double one = component.free ? forces[c] : motions[c];
      drive.components[c] = {
          component.free, component.value ? component.value(t) / one : 0,
          ofInside[c] / forces[c], component.stiffness / (forces[c] / motions[c]),
          component.end ? component.end(t) / motions[c] : 0};
    }
    drives.push_back(drive);
  }
  return drives;
}

std::vector<SideOfBody> Scene::everyBody() const {
  std::vector<SideOfBody> all;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    all.push_back({false, b});
  for (std::size_t b = 0; b < rigid.size(); ++b)
    all.push_back({true, b});
  return all;
}

std::vector<Symmetry> Scene::mirrors() const {
  std::vector<Symmetry> lines;
  if (symmetry)
    lines.push_back(symmetry);
  if (isAxisymmetric)
    lines.push_back({0});
  return lines;
}

bem::Vec2 Scene::drawn(bem::Vec2 point) const {
  const double beside = 1e-9 * units().length;
  std::vector<bem::Vec2> images = {point};
  for (const Symmetry& line : mirrors()) {
    const std::vector<bem::Vec2> known = images;
    for (bem::Vec2 there : known) {
      images.push_back(line.mirrored(there));
      if (std::abs(line.across(there)) < beside)
        for (const double side : {beside, -beside}) {
          line.across(there) = side;
          images.push_back(there);
        }
    }
  }
  const auto found = std::find_if(images.begin(), images.end(),
                                  [&](bem::Vec2 x) { return bodyAt(x) < bodies.size(); });
  return found == images.end() ? point : *found;
}

std::vector<std::string> boundaryNames(const bem::Outline& outline) {
  std::vector<std::string> names;
  for (const bem::Edge& edge : outline.edges())
    if (std::find(names.begin(), names.end(), edge.boundary) == names.end())
      names.push_back(edge.boundary);
  return names;
}

}  // namespace epafi::drivers
