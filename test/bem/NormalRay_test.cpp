// What lies opposite to a curve along its normals: single curves, and the boundaries of two bodies.
#include "bem/geometry/NormalRay.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace epafi {

namespace {

using bem::crossing;
using bem::Curve;
using bem::CurveTree;
using bem::facing;
using bem::Vec2;
using bem::Visibility;

const double pi = std::acos(-1.0);

/// Of a circle about the origin between two angles; inwards: the edge of a hole, run through
/// clockwise, whose normals lead to the centre.
Curve arc(double radius, double from, double to) {
  const auto point = [&](double angle) {
    return Vec2{radius * std::cos(angle), radius * std::sin(angle)};
  };
  return {point(from), point(to), std::tan((to - from) / 4)};
}

/// The foot of what a normal meets is where the normal begins.
TEUCHOS_UNIT_TEST(NormalRay, feetAreBeginnings) {
  const Curve sides[] = {Curve({-0.4, 0}, {0.5, 0.1}), Curve({-0.4, 0}, {0.5, 0.1}, 0.3),
                         Curve({-0.4, 0}, {0.5, 0.1}, -0.2)};
  const Curve met[] = {Curve({2, -0.5}, {-2, -0.75}), Curve({2, -0.5}, {-2, -0.75}, 0.1),
                       Curve({2, -0.5}, {-2, -0.75}, -0.15)};
  for (const Curve& side : sides)
    for (const Curve& other : met)
      for (const double t : {-1.0, -0.35, 0.2, 1.0}) {
        const auto found = crossing(side.point(t), side.normal(t), other);
        TEST_ASSERT(found && isOn(*found, other));
        TEST_COMPARE(norm(side.point(t) + found->distance * side.normal(t) -
                          other.point(found->t)),
                     <, 1e-14);
        const auto feet = feetOn(side, other.point(found->t));
        TEST_COMPARE(std::abs(feet.front() - t), <, 1e-13);
      }
}

/// Along the normals of what is opposite it is the way back from there, on flanks of a wedge, too.
TEUCHOS_UNIT_TEST(NormalRay, normalsOppositeAreTheWayBack) {
  const Curve sides[] = {Curve({-0.4, 0.4}, {0, 0}), Curve({0, 0}, {0.3, 0.6}, -0.1)};
  const Curve met[] = {Curve({2, -0.05}, {-2, -0.05}), Curve({1, -0.8}, {-1, -0.8}, 0.4),
                       Curve({2, 0.5}, {-2, 0.5}, -0.25)};
  for (const Curve& side : sides)
    for (const Curve& other : met) {
      for (const double t : {-1.0, -0.35, 0.2, 1.0}) {
        const auto found =
            across(side.point(t), side.normal(t), other, bem::Normals::Opposite);
        TEST_ASSERT(found && isOn(*found, other));
        const auto back = crossing(other.point(found->t), other.normal(found->t), side);
        TEST_ASSERT(back.has_value());
        TEST_COMPARE(std::abs(back->t - t), <, 1e-13);
        TEST_COMPARE(std::abs(back->distance - found->distance), <, 1e-14);
      }
      const auto stretches = facing(side, CurveTree({other}), {}, bem::Normals::Opposite);
      TEST_EQUALITY(stretches.size(), 1u);
      TEST_EQUALITY(stretches[0].begin, -1);
      TEST_EQUALITY(stretches[0].end, 1);
    }
}

/// Of many curves, too, it is the nearest, whose stretches end opposite to its own ends.
TEUCHOS_UNIT_TEST(NormalRay, normalsOppositeFindTheNearestOfMany) {
  const Curve side({0.1, 0.3}, {0.7, 1.2});
  std::vector<Curve> curves;
  for (int k = 0; k < 200; ++k)
    curves.push_back(arc(2, -pi + 0.01 * k, -pi + 0.01 * (k + 1)));
  for (int k = 0; k < 200; ++k)
    curves.emplace_back(Vec2{3 - 0.03 * k, -0.2}, Vec2{3 - 0.03 * (k + 1), -0.2});
  const auto stretches = facing(side, CurveTree(curves), {}, bem::Normals::Opposite);
  TEST_COMPARE(stretches.size(), >, 15u);
  double end = -1;
  for (const bem::Facing& stretch : stretches) {
    TEST_EQUALITY(stretch.begin, end);
    end = stretch.end;
    for (const double s : {0.01, 0.5, 0.99}) {
      const double t = stretch.begin + s * (stretch.end - stretch.begin);
      int nearest = -1;
      double least = 1e300;
      for (std::size_t k = 0; k < curves.size(); ++k) {
        const auto found =
            across(side.point(t), side.normal(t), curves[k], bem::Normals::Opposite);
        if (found && isOn(*found, curves[k]) && std::abs(found->distance) < least) {
          least = std::abs(found->distance);
          nearest = static_cast<int>(k);
        }
      }
      TEST_EQUALITY(stretch.curve, nearest);
    }
  }
  TEST_EQUALITY(end, 1);
}

/// Also beyond the centre of an arc whose normals lead there.
TEUCHOS_UNIT_TEST(NormalRay, feetAreBeginningsAcrossTheCentre) {
  const Curve side = arc(1, 2.2, 1.1);
  const Curve other({2, -0.5}, {-2, -0.75});
  for (const double t : {-0.9, 0.1, 0.8}) {
    const auto found = crossing(side.point(t), side.normal(t), other);
    TEST_ASSERT(found && found->distance > 1);
    const auto feet = feetOn(side, side.point(t) + found->distance * side.normal(t));
    TEST_COMPARE(std::abs(feet.back() - t), <, 1e-13);
  }
}

TEUCHOS_UNIT_TEST(NormalRay, stretchesEndOppositeToEnds) {
  const Curve side({-1, 0}, {1, 0});
  const CurveTree below(
      {Curve({0.5, -0.1}, {0.25, -0.1}), Curve({0.25, -0.1}, {-0.5, -0.1})});
  const auto found = facing(side, below, {});
  TEST_EQUALITY(found.size(), 2u);
  TEST_FLOATING_EQUALITY(found[0].begin, -0.5, 1e-15);
  TEST_FLOATING_EQUALITY(found[0].end, 0.25, 1e-15);
  TEST_EQUALITY(found[0].curve, 1);
  TEST_FLOATING_EQUALITY(found[1].end, 0.5, 1e-15);
  TEST_EQUALITY(found[1].curve, 0);
}

/// A circle turns away where the side's normals touch it.
TEUCHOS_UNIT_TEST(NormalRay, stretchesEndWhereACircleTurnsAway) {
  const Curve side({-1, 0.5}, {1, 0.5});
  const double shrink = 0.25;
  const Curve circle({shrink, 0}, {-shrink, 0}, 1);
  const auto found = facing(side, CurveTree({circle}), {});
  TEST_EQUALITY(found.size(), 1u);
  TEST_COMPARE(std::abs(found[0].begin + shrink), <, 1e-14);
  TEST_COMPARE(std::abs(found[0].end - shrink), <, 1e-14);
}

// Elements of a graded mesh, down to sizes at which coordinates round.
TEUCHOS_UNIT_TEST(NormalRay, shortPartsFaceWhatTheWholeFaces) {
  const Curve side({-0.15, 0.01}, {0.15, 0.01}, 0.075);
  const Vec2 shift{0.002, -0.003};
  const Curve other({0.15, -0.03}, {-0.15, -0.03}, 0.03);
  const auto whole = facing(side.moved(shift), CurveTree({other}), {});
  TEST_EQUALITY(whole.size(), 1u);
  const double begin = side.half() * (1 + whole[0].begin);
  TEST_COMPARE(begin, >, 1e-4);
  // towards where the other one ends
  std::vector<Curve> opposite;
  const auto behind = [&](double toEnd) {
    return bem::Position{other.length() - toEnd, toEnd};
  };
  double size = 0.2;
  for (; size > 1e-12; size *= 0.15)
    opposite.push_back(other.part(behind(size), behind(0.15 * size)));
  opposite.push_back(other.part(behind(size), behind(0)));
  const CurveTree graded(opposite);
  for (double h = 0.1; h > 1e-12; h *= 0.15) {
    const Curve part =
        side.part({begin, side.length() - begin}, {begin + h, side.length() - begin - h});
    double seen = 0;
    for (const auto& stretch : facing(part.moved(shift), graded, {}))
      seen += stretch.end - stretch.begin;
    TEST_COMPARE(std::abs(seen - 2), <, 1e-2);
  }
}

TEUCHOS_UNIT_TEST(NormalRay, facesTheNearer) {
  const Curve side({-1, 0}, {1, 0});
  const auto found = facing(
      side, CurveTree({Curve({2, -0.5}, {-2, -0.5}), Curve({0.5, -0.1}, {-0.5, -0.1})}),
      {});
  TEST_EQUALITY(found.size(), 3u);
  TEST_EQUALITY(found[0].curve, 0);
  TEST_EQUALITY(found[1].curve, 1);
  TEST_EQUALITY(found[2].curve, 0);
}

/// A closed polygon, counter-clockwise.
std::vector<Curve> polygon(const std::vector<Vec2>& corners) {
  std::vector<Curve> edges;
  for (std::size_t k = 0; k < corners.size(); ++k)
    edges.emplace_back(corners[k], corners[(k + 1) % corners.size()]);
  return edges;
}

std::vector<Curve> box(double left, double bottom, double right, double top) {
  return polygon({{left, bottom}, {right, bottom}, {right, top}, {left, top}});
}

std::vector<Curve> wholeCircle(Vec2 centre, double radius) {
  const Vec2 arm{radius, 0};
  return {Curve(centre - arm, centre + arm, 1), Curve(centre + arm, centre - arm, 1)};
}

/// The parts of the edges of one body that face another one: edge, from, to.
std::vector<std::array<double, 3>> faces(const std::vector<Curve>& own,
                                         const std::vector<Curve>& other) {
  const Visibility visibility(own, other, 1e-9);
  std::vector<std::array<double, 3>> found;
  for (std::size_t e = 0; e < own.size(); ++e) {
    const auto edge = static_cast<double>(e);
    for (const bem::Facing& stretch : facing(own[e], CurveTree(other), visibility))
      if (!found.empty() && found.back()[0] == edge && found.back()[2] == stretch.begin)
        found.back()[2] = stretch.end;
      else
        found.push_back({edge, stretch.begin, stretch.end});
  }
  return found;
}

using Faces = std::vector<std::array<double, 3>>;

bool near(const Faces& a, const Faces& b, double tolerance = 1e-12) {
  bool all = a.size() == b.size();
  for (std::size_t k = 0; all && k < a.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i)
      all = all && std::abs(a[k][i] - b[k][i]) < tolerance;
  return all;
}

/// A box on a wider one, with a gap, flush or drawn into it, faces it from below and from nowhere else,
/// in either order.
TEUCHOS_UNIT_TEST(Visibility, backsOfBodiesFaceNothing) {
  for (const double gap : {0.5, 0.0, -0.01}) {
    const auto lower = box(-2, -1, 2, 0);
    const auto upper = box(-1, gap, 1, 2);
    TEST_ASSERT(near(faces(upper, lower), {{0, -1, 1}}));
    TEST_ASSERT(near(faces(lower, upper), {{2, -0.5, 0.5}}));
    const auto asWide = box(-2, gap, 2, 2);
    TEST_ASSERT(near(faces(asWide, lower), {{0, -1, 1}}));
    TEST_ASSERT(near(faces(lower, asWide), {{2, -1, 1}}));
  }
}

/// Arcs of nearly no curvature, whose centres are far beyond all digits, face what segments face.
TEUCHOS_UNIT_TEST(Visibility, nearlyStraightArcsAreAsSegments) {
  for (const double bulge : {1e-6, -1e-8, 1e-10, -1e-13}) {
    const auto bent = [bulge](std::vector<Curve> edges) {
      for (const std::size_t e : {0, 2})
        edges[e] = Curve(edges[e].from(), edges[e].to(), bulge);
      return edges;
    };
    const auto lower = bent(box(-2, -1, 2, 0));
    const auto upper = bent(box(-1, 0.5, 1, 2));
    TEST_ASSERT(near(faces(upper, lower), {{0, -1, 1}}, 1e-5));
    TEST_ASSERT(near(faces(lower, upper), {{2, -0.5, 0.5}}, 1e-5));
  }
}

/// The lower half of a disc above a block faces what of it lies below; nothing lies opposite to the
/// upper half, not through the disc either.
TEUCHOS_UNIT_TEST(Visibility, aDiscFacesABlockFromBelow) {
  const auto block = box(-2, -1, 2, 0);
  for (const double height : {1.2, 1.0, 0.99}) {
    const auto disc = wholeCircle({0, height}, 1);
    // the normal through a corner of the block
    const double angle = std::atan2(2, height) / (pi / 2);
    TEST_ASSERT(near(faces(disc, block), {{0, -angle, angle}}));
    TEST_ASSERT(near(faces(block, disc), {{2, -0.5, 0.5}}));
  }
}

/// What is behind the own body is hidden, as is what is behind the other one.
TEUCHOS_UNIT_TEST(Visibility, bodiesHide) {
  // a C whose slot is 0 < y < 1, and a box below its lower arm
  const auto slotted =
      polygon({{0, -1}, {4, -1}, {4, 0}, {1, 0}, {1, 1}, {4, 1}, {4, 2}, {0, 2}});
  TEST_ASSERT(near(faces(slotted, box(-9, -3, 9, -2)), {{0, -1, 1}}));
  // a tongue in the slot
  const auto tongue = box(2.5, 0.1, 5, 0.9);
  TEST_ASSERT(near(faces(slotted, tongue), {{2, -1, 0}, {3, -0.8, 0.8}, {4, 0, 1}}));
  TEST_ASSERT(near(faces(tongue, slotted), {{0, -1, 0.2}, {2, -0.2, 1}, {3, -1, 1}}));
  // from below its lower arm alone is seen, even if the upper one is asked for
  const auto below = box(-9, -3, 9, -2);
  const Visibility fromBelow(below, slotted, 1e-9);
  TEST_EQUALITY(facing(below[2], CurveTree({slotted[0]}), fromBelow).size(), 1u);
  TEST_EQUALITY(facing(below[2], CurveTree({slotted[4]}), fromBelow).size(), 0u);
}

/// Of a ring of radii 4 and 5 all of a disc inside sees the hole, wherever it lies, and what the disc
/// hides no point of the hole sees.
TEUCHOS_UNIT_TEST(Visibility, aDiscInARingFacesTheHole) {
  std::vector<Curve> ring = wholeCircle({0, 0}, 5);
  ring.push_back(arc(4, 2 * pi, pi));
  ring.push_back(arc(4, pi, 0));
  for (const double y : {-3.0, -3.01, -1.0, 0.0}) {
    const auto disc = wholeCircle({0, y}, 1);
    const Visibility visibility(disc, ring, 1e-9);
    for (const Curve& side : disc) {
      double covered = 0;
      for (const bem::Facing& stretch : facing(side, CurveTree(ring), visibility)) {
        TEST_ASSERT(stretch.curve >= 2);
        covered += stretch.end - stretch.begin;
      }
      TEST_FLOATING_EQUALITY(covered, 2.0, 1e-12);
    }
  }
  // normals of the hole lead through the centre, and beyond it the way to a disc at (0, -3) is free
  const double half = std::asin(1.0 / 3) / (pi / 2);
  TEST_ASSERT(
      near(faces(ring, wholeCircle({0, -3}, 1)), {{2, -half, half}, {3, -half, half}}));
}

}  // namespace

}  // namespace epafi
