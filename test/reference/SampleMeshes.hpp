#pragma once

#include "Rectangle.hpp"

#include <string>
#include <vector>

namespace epafi::reference {

using test::outlineOf;

/// A closed polygon whose edges are all called "side".
bem::Loop polygon(const std::vector<bem::Vec2>& vertices);

/// A regular polygon, vertices on a circle about the origin.
bem::Loop regularPolygon(int sides, double radius);

bem::Loop square();

/// A circle of equal arcs about the origin; two at least.
bem::Loop disc(int arcs, double radius);

/// Two edges of these bulges that close a loop, from (0.5, 0) above and back below.
bem::Loop lens(double first, double second);

/// Arcs to either side and segments: arc on arc and arc on segment at right, wide and acute
/// corners (5 degrees) and at a smooth joint, an arc facing another closely.
bem::Loop curvedSample();

/// Equal elements of one degree on all edges.
bem::Mesh meshOf(const bem::Loop& loop, int elementsPerEdge, int degree);

/// Unit square with a square hole of side 0.2 that keeps 0.1 off the left side.
std::shared_ptr<const bem::Outline> squareWithHole();

/// Pieces of one edge that end at the given fractions of it.
struct Cuts {
  int edge = 0;
  std::vector<double> fractions;  ///< increasing, without 0 and 1
};

/// A mesh with chosen cuts; element k gets degrees[k mod size].
bem::Mesh cutMesh(std::shared_ptr<const bem::Outline> outline,
                  const std::vector<Cuts>& cuts, const std::vector<int>& degrees);

struct Sample {
  std::string name;
  bem::Mesh mesh;
};

/// Small meshes with every relation of two elements that is hard: acute corner of 5
/// degrees, reentrant corner, thin beam 1:100, neighbours 1:1000, a hole, degrees up
/// to 10.
std::vector<Sample> hardSamples();

/// Lengths from 1e-10 to 1 on one edge.
Sample gradedSample();

/// Three meshes of a few elements for a quick look.
std::vector<Sample> quickSamples();

}  // namespace epafi::reference
