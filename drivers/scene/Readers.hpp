#pragma once

#include "drivers/scene/Scene.hpp"

#include <string>
#include <vector>

// The parts of a scene whose file, constants and validated list are set, read in this order.
namespace epafi::drivers {

/// Reads the bodies.
///
/// All elastic bodies are scaled by the length of the largest and the Young's modulus of
/// the softest.  Rigid bodies do not count: they must not change the results of others.
/// \throws bem::InputError for a rigid body with keys of elastic ones or vice versa, if
///   no body is elastic, and as readLoops, readConditions and readMesh.
void readBodies(Scene& scene);

/// Reads the contacts of a scene whose bodies are read: the two sides, the parts of the
/// first side that have an opposite side, and required nodes at the ends of these parts.
/// \throws bem::InputError for unknown bodies or boundaries, contact of a boundary with
///   itself or of two rigid bodies, a boundary that already has a condition, sides that
///   never face each other, and as checkOverlaps.
void readContacts(Scene& scene);

/// Largest plausible interference of two bodies in contact [length]: 5 % of the thickness
/// of the thinner elastic one (twice its area over the length of its outline).  Press
/// fits have about 0.1 %.
double largestInterference(const Scene& scene, const ContactPair& pair);

/// Checks that bodies overlap only at their contacts, and that boundaries beside a
/// contact overlap by at most largestInterference.  Arcs are replaced by 32 chords.
/// \throws bem::InputError with the two bodies, their boundaries and a point inside both.
void checkOverlaps(const Scene& scene);

// Of a body

/// Reads a validated list Geometry, in which the content of File replaces the key File.
///
/// \param file  the scene file; relative names of geometry files start from its folder
/// \param path  path of the list, for messages
/// \throws bem::InputError if the numbers of edges, bulges and vertices differ, or if
///   holes are not numbered 1, 2, ...
bem::Loops readLoops(Teuchos::ParameterList& geometry, const std::string& file,
                     const std::string& path);

/// \param length  diameter of the largest body, by which all bodies are scaled
/// \param scene  of which Geometry is read
/// \throws bem::InputError for closed lines that cross or have the wrong orientation.
std::shared_ptr<const bem::Outline> makeOutline(const bem::Loops& loops, double length,
                                                const Scene& scene,
                                                const std::string& path);

/// The key of a hole 1, 2, ...: "Hole 1 Vertices".
std::string holeKey(int hole, const std::string& what);

/// Schema rows of a mesh.  `degree`: default of Degree; null: none, Discretization
/// applies.
bem::SchemaRows meshRows(const char* degree = nullptr);

/// Does a list Mesh, or Discretization, say how long or how many elements are?
bool isSized(const Teuchos::ParameterList& mesh);

/// Sets elements and degree of a body from its validated list Mesh; what is missing there
/// is taken from Discretization.
/// \throws bem::InputError unless there is one number per edge, for Mesh Size beside
///   them, elements that turn by more than 180 degrees, and more than a million elements.
void readMesh(const Part& own, const Part& discretization, Body& body);

/// Reads Boundary Conditions and Rigid Motions of a body.  Edges on the line of symmetry
/// become rollers; motions that are zero by symmetry are removed from Fix.
/// \throws bem::InputError for an unknown boundary (with the nearest name), a Dirichlet
///   condition without a component or along the normal and an axis, an invalid expression, and a
///   force beside a traction.
contact::Conditions readConditions(const Part& body, const bem::Outline& outline,
                                   const Symmetry& symmetry);

/// \throws bem::InputError if no edge has this name, with the nearest name.
void checkNamed(const std::string& boundary, const std::string& path,
                const bem::Outline& outline);

/// Reads interference and surface of a list under Contacts, whose names include the
/// normal.
contact::Conditions::Contact readContactOfBodies(const Part& part);

}  // namespace epafi::drivers
