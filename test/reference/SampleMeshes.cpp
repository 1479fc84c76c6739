#include "reference/SampleMeshes.hpp"

#include <cmath>

namespace epafi::reference {

using bem::Loop;
using bem::Mesh;
using bem::Outline;
using bem::Vec2;

namespace {

std::shared_ptr<const Outline> outline(const std::vector<Vec2>& vertices) {
  return std::make_shared<const Outline>(polygon(vertices));
}

std::vector<Vec2> acuteTriangle() {
  const double angle = 5 * std::acos(-1.0) / 180;
  return {{0, 0}, {1, 0}, {std::cos(angle), std::sin(angle)}};
}

const std::vector<Vec2> unitSquare = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const std::vector<Vec2> lShape = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
const std::vector<Vec2> beam = {{0, 0}, {1, 0}, {1, 0.01}, {0, 0.01}};

}  // namespace

Loop polygon(const std::vector<Vec2>& vertices) {
  return {vertices, std::vector<std::string>(vertices.size(), "side")};
}

Loop regularPolygon(int sides, double radius) {
  std::vector<Vec2> vertices;
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * std::acos(-1.0) * k / sides;
    vertices.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return polygon(vertices);
}

Loop square() { return polygon(unitSquare); }

Loop disc(int arcs, double radius) {
  Loop loop =
      arcs > 2 ? regularPolygon(arcs, radius) : polygon({{radius, 0}, {-radius, 0}});
  loop.bulges.assign(arcs, std::tan(std::acos(-1.0) / (2 * arcs)));
  return loop;
}

Loop lens(double first, double second) {
  Loop loop = polygon({{0.5, 0}, {-0.5, 0}});
  loop.bulges = {first, second};
  return loop;
}

// A slit of height 0.02 on the right, between an arc and a segment; below it a corner of 5
// degrees between a segment and an arc.
Loop curvedSample() {
  Loop loop = polygon(
      {{0, 0}, {1, 0}, {1.3, 0.3}, {0.6, 0.34}, {1.3, 0.38}, {1, 0.9}, {0.2, 0.8}});
  loop.bulges = {0.3, 0.41421356237309503, 0, 0.01, -0.3, 0.2, -0.1};
  return loop;
}

Mesh meshOf(const Loop& loop, int elementsPerEdge, int degree) {
  return bem::makeMesh(outlineOf(loop),
                       std::vector<int>(loop.edges.size(), elementsPerEdge), degree);
}

std::shared_ptr<const Outline> squareWithHole() {
  const Loop hole = polygon({{0.1, 0.4}, {0.3, 0.4}, {0.3, 0.6}, {0.1, 0.6}});
  return std::make_shared<const Outline>(square(), std::vector<Loop>{hole});
}

Mesh cutMesh(std::shared_ptr<const Outline> shape, const std::vector<Cuts>& cuts,
             const std::vector<int>& degrees) {
  std::vector<bem::Piece> pieces;
  for (int edge = 0; edge < static_cast<int>(shape->edges().size()); ++edge) {
    std::vector<double> ends = {0};
    for (const Cuts& c : cuts)
      if (c.edge == edge)
        ends.insert(ends.end(), c.fractions.begin(), c.fractions.end());
    ends.push_back(1);
    const double length = shape->edge(edge).curve.length();
    const auto position = [length](double fraction) {
      return bem::Position{fraction * length, (1 - fraction) * length};
    };
    for (std::size_t k = 0; k + 1 < ends.size(); ++k)
      pieces.push_back({edge, position(ends[k]), position(ends[k + 1]),
                        degrees[pieces.size() % degrees.size()]});
  }
  return Mesh(std::move(shape), pieces);
}

std::vector<Sample> hardSamples() {
  std::vector<Sample> samples;
  samples.push_back(
      {"square, 8 elements, p = 1 to 4",
       cutMesh(outline(unitSquare), {{0, {0.5}}, {1, {0.5}}, {2, {0.5}}, {3, {0.5}}},
               {1, 2, 3, 4})});
  samples.push_back(
      {"triangle with a corner of 5 degrees, p = 1 to 10",
       cutMesh(outline(acuteTriangle()), {{0, {0.3}}, {2, {0.6, 0.9}}}, {4, 10, 1, 7})});
  samples.push_back(
      {"L-shape, p = 1 to 5",
       cutMesh(outline(lShape), {{2, {0.5}}, {3, {0.8}}}, {2, 5, 1, 4, 3})});
  samples.push_back(
      {"beam 1:100, p = 1 to 6",
       cutMesh(outline(beam), {{0, {0.4, 0.8}}, {2, {0.3, 0.9}}}, {1, 3, 6, 2})});
  samples.push_back(
      {"square, neighbours 1:1000, p = 1 to 8",
       cutMesh(outline(unitSquare), {{0, {0.5, 0.501}}, {1, {0.001}}}, {3, 1, 8, 2})});
  samples.push_back({"square with a hole, p = 1 to 3",
                     cutMesh(squareWithHole(), {{3, {0.5}}}, {2, 3, 1})});
  samples.push_back(
      {"square, p = 10", cutMesh(outline(unitSquare), {{1, {0.25}}}, {10})});
  samples.push_back({"strip, elements facing at half their length, p = 1 to 10",
                     cutMesh(outline({{0, 0}, {1, 0}, {1, 0.1}, {0, 0.1}}),
                             {{0, {0.2, 0.4, 0.6, 0.8}}, {2, {0.17, 0.31, 0.55, 0.75}}},
                             {10, 1, 6, 3, 2})});
  samples.push_back({"square, 48 elements, p = 3",
                     bem::makeMesh(outline(unitSquare), {12, 12, 12, 12}, 3)});
  samples.push_back({"square, 20 elements, p = 10",
                     bem::makeMesh(outline(unitSquare), {8, 1, 8, 3}, 10)});
  return samples;
}

Sample gradedSample() {
  return {
      "square graded to a corner, lengths 1:1e10, p = 1 to 3",
      cutMesh(outline(unitSquare),
              {{0, {1e-10, 1e-8, 1e-6, 1e-4, 1e-2}}, {3, {0.99, 0.9999}}}, {1, 2, 3})};
}

std::vector<Sample> quickSamples() {
  std::vector<Sample> samples;
  samples.push_back(
      {"square, p = 1 to 4", cutMesh(outline(unitSquare), {{0, {0.5}}}, {1, 2, 3, 4})});
  samples.push_back({"triangle with a corner of 5 degrees, p = 2, 5, 10",
                     cutMesh(outline(acuteTriangle()), {}, {2, 5, 10})});
  samples.push_back({"beam 1:100, p = 2", cutMesh(outline(beam), {{0, {0.99}}}, {2})});
  return samples;
}

}  // namespace epafi::reference
