#pragma once

#include "contact/results/Summary.hpp"
#include "drivers/scene/Part.hpp"
#include "drivers/scene/Scene.hpp"

namespace epafi::drivers {

/// The keys of a list Body Loads, and of a boundary's under Thermal Conditions.
bem::SchemaRows bodyLoadsRows();
bem::SchemaRows thermalRows();

/// What acts inside a body at a time, from its validated lists Material, Body Loads and Thermal
/// Conditions; the root's Body Loads serve bodies that have none of their own.
class BodyLoadsReader {
 public:
  /// `root`: the scene's whole list, at this time.
  BodyLoadsReader(const Part& root, const std::string& body);

  /// Of an elastic body; none where no list says anything.
  /// `material`, `stress`: the body's, and what stresses count in.
  /// \throws bem::InputError for a load by mass on a body without Density, a force beside a weight,
  ///   a temperature that is no polynomial of degree 4, or of a body without Thermal Expansion, or
  ///   beside Thermal Conditions, and what is not one finite number at this time.
  contact::BodyLoadSolution inside(const bem::Outline& outline,
                                   const bem::Material& material, double stress) const;

  /// What is said of heat on its boundaries; none: no list says anything.
  /// \throws bem::InputError for a boundary that no edge has, a temperature and a flux or neither on
  ///   one, and if no boundary has a temperature.
  std::shared_ptr<const contact::ThermalConditions> heat(
      const bem::Outline& outline) const;

  /// Of a rigid one, about its reference point, in the user's units; without a Density of its own
  /// nothing of the root's.  \throws bem::InputError as above.
  contact::Resultant resultant(const bem::Outline& outline, bem::Vec2 pole) const;
  /// Does anything act on a rigid body?
  bool actsOnRigid() const;

 private:
  /// b(x) = uniform + linear (x - origin), per volume, complex, in the user's units.
  struct Force {
    bem::Complex uniform;
    bem::Complex linear;
  };
  Force forceAt(bem::Vec2 origin) const;
  void checkSymmetry(const Force& force, bem::Vec2 origin) const;
  double value(const char* key) const;
  double ofMaterial(const char* property, const std::string& why) const;
  contact::BodyLoads::Terms temperature(const bem::Outline& outline) const;

  Part body_;
  Part thermal_;
  Part loads_;  ///< the body's own or those at the root
  bool own_ = false;
  Symmetry symmetry_;
};

}  // namespace epafi::drivers
