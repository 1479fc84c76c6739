#pragma once

#include "contact/results/Summary.hpp"
#include "drivers/scene/Part.hpp"
#include "drivers/scene/Scene.hpp"

namespace epafi::drivers {

/// Schema rows of Body Loads, and of a boundary under Thermal Conditions.
bem::SchemaRows bodyLoadsRows();
bem::SchemaRows thermalRows();

/// Reads the loads and heat of a body at one time from its validated lists Material, Body
/// Loads (by default that at the root) and Thermal Conditions.
class BodyLoadsReader {
 public:
  /// `root`: the complete list of the scene, at this time.
  BodyLoadsReader(const Part& root, const std::string& body);

  /// The loads of an elastic body; null if there are none.  `stress`: the unit of
  /// stresses.
  /// \throws bem::InputError if Density is missing, for Force beside Gravity, for a
  ///   temperature that is not a polynomial of degree 4, even in x around an axis of revolution,
  ///   or is given without Thermal Expansion or beside Thermal Conditions, and if a value is not one
  ///   finite number.
  contact::BodyLoadSolution inside(const bem::Outline& outline,
                                   const bem::Material& material, double stress) const;

  /// The thermal conditions of the body; null if there are none.
  /// \throws bem::InputError for an unknown boundary, for both or none of temperature and
  ///   flux on a boundary, and if no boundary has a temperature.
  std::shared_ptr<const contact::ThermalConditions> heat(
      const bem::Outline& outline) const;

  /// Resultant of the loads of a rigid body about its reference point, in the user's
  /// units.
  contact::Resultant resultant(const bem::Outline& outline, bem::Vec2 pole) const;
  /// Does a load act on the rigid body?  Loads at the root need its Density.
  bool actsOnRigid() const;

 private:
  /// b(x) = uniform + linear (x - origin) per volume, complex, in the user's units; around an axis of
  /// revolution linear acts on the radius.
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
  Part loads_;  ///< of the body, or at the root
  bool own_ = false;
  Symmetry symmetry_;
  bool isAxisymmetric_ = false;
};

}  // namespace epafi::drivers
