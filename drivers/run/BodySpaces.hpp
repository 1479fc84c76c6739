#pragma once

#include "contact/opposite/Opposite.hpp"
#include "drivers/run/Level.hpp"
#include "drivers/scene/Scene.hpp"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace epafi::contact {
class Conduction;
}

namespace epafi::drivers {

/// The spaces on the meshes of a scene's bodies, and the opposite sides of their contacts.
class BodySpaces {
 public:
  /// On the meshes of a level.  Refers to the scene.
  /// \throws bem::InputError if they do not fit the scene's outlines, and see
  ///   contact::MultiplierSpace.
  BodySpaces(const Scene& scene, const Level& level);
  BodySpaces(const BodySpaces&) = delete;
  BodySpaces& operator=(const BodySpaces&) = delete;

  const Scene& scene() const { return scene_; }
  std::size_t size() const { return spaces_.size(); }
  const bem::Space& space(std::size_t b) const { return spaces_[b]; }
  std::vector<const bem::Space*> all() const;
  const contact::MultiplierSpace& multiplier() const { return *multiplier_; }
  const std::shared_ptr<const contact::Opposite>& opposite() const { return opposite_; }

  /// Conditions of the bodies at time t, body loads with conducted heat on these meshes.
  std::vector<contact::Conditions> conditionsAt(double t) const;

  /// A row with the sizes of all meshes and spaces.
  LevelRow levelRow() const;
  /// A row with names only: of contacts, preceded by that of the body if not unique, and of
  /// rigid bodies, in the order of the scene.
  StepRow stepRow() const;

  /// Motions for given displacements of the elastic bodies, which must outlive the
  /// result, and given motions of rigid bodies.
  contact::Motions motions(const std::vector<bem::Vector>& displacements,
                           const std::vector<contact::RigidMotion>& rigid) const;

 private:
  contact::OppositeSide oppositeSide(const ContactPair& pair) const;

  const Scene& scene_;
  std::vector<bem::Space> spaces_;
  std::optional<contact::MultiplierSpace> multiplier_;
  std::shared_ptr<const contact::Opposite> opposite_;
  /// By body, if it conducts heat; computed on first use.
  mutable std::map<std::size_t, std::shared_ptr<const contact::Conduction>> conductions_;
};

/// First mesh of a body.  An edge on which contact with another body ends is divided
/// there, its elements are distributed by length; lines of symmetry are graded.
bem::Mesh firstMesh(const Body& body);

/// A level with those of all bodies.
Level firstMeshes(const Scene& scene);

std::vector<bem::Piece> piecesOf(const bem::Mesh& mesh);

}  // namespace epafi::drivers
