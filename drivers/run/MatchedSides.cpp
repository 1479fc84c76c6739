#include "drivers/run/MatchedSides.hpp"

#include "bem/geometry/NormalRay.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"
#include "drivers/run/BodySpaces.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace epafi::drivers {

namespace {

using adaptivity::Mark;
using bem::at;
using Meshes = std::vector<const bem::Mesh*>;

/// The node of an element at which a bond ends or begins, contact goes on: 1, -1; 0: none.
int endAtBond(const bem::Mesh& mesh, int e, const contact::Conditions& conditions) {
  const auto* own = contact::contactOn(mesh, e, conditions);
  const auto changes = [&](int neighbour) {
    const auto* other = contact::contactOn(mesh, neighbour, conditions);
    return own != nullptr && other != nullptr &&
           own->friction.ties() != other->friction.ties();
  };
  return changes(mesh[e].next) ? 1 : changes(mesh[e].previous) ? -1 : 0;
}

/// Elements of the two sides of a contact, as they see each other.
class Sides {
 public:
  Sides(const Scene& scene, const ContactPair& pair, const Meshes& meshes)
      : conditions_(scene.bodies[pair.side.body].conditions),
        name_(pair.name),
        side_(*meshes[pair.side.body]),
        opposite_(*meshes[pair.opposite.body]),
        elements_(side_.elementsOf(pair.side.boundary)),
        numbers_(opposite_.elementsOf(pair.opposite.boundary)),
        visibility_(scene.visibility(pair)),
        shift_(scene.shift(pair)) {
    std::vector<bem::Curve> curves;
    for (const int f : numbers_)
      curves.push_back(opposite_[f].curve);
    curves_ = bem::CurveTree(std::move(curves));
  }

  const bem::Element& own(int e) const { return side_[e]; }
  const bem::Element& other(int f) const { return opposite_[f]; }

  /// visit(element, its end at a bond, 1 or -1)
  template <class Visit>
  void forEachEnd(const Visit& visit) const {
    for (const int e : elements_)
      if (const int end = isIn(e) ? endAtBond(side_, e, conditions_) : 0; end != 0)
        visit(e, end);
  }
  struct Place {
    int element;
    double t;
  };
  std::optional<Place> across(int e, double t) const {
    const auto there = faced(side_[e].curve.moved(shift_), t, curves_, visibility_,
                             contact::sightOf(side_, e, conditions_));
    if (!there)
      return {};
    return Place{numbers_[there->curve], there->crossing.t};
  }

  /// visit(element, the place opposite to its middle)
  template <class Visit>
  void forEachFaced(const Visit& visit) const {
    for (const int e : elements_)
      if (isIn(e))
        if (const auto there = across(e, 0))
          visit(e, *there);
  }

  /// visit(element, opposite one) of those with the same ends.
  template <class Visit>
  void forEachMatch(const Visit& visit) const {
    constexpr double same = 1e-4;
    constexpr double inside = 1 - same;
    for (const int e : elements_) {
      if (!isIn(e))
        continue;
      const auto first = across(e, -inside);
      const auto last = across(e, inside);
      if (first && last && first->element == last->element &&
          std::abs(first->t - 1) < 2 * same && std::abs(last->t + 1) < 2 * same)
        visit(e, first->element);
    }
  }

 private:
  bool isIn(int e) const {
    const auto* contact = contact::contactOn(side_, e, conditions_);
    return contact != nullptr && contact->name == name_;
  }

  const contact::Conditions& conditions_;
  const std::string& name_;
  const bem::Mesh& side_;
  const bem::Mesh& opposite_;
  std::vector<int> elements_;
  std::vector<int> numbers_;
  bem::CurveTree curves_;
  bem::Visibility visibility_;
  bem::Vec2 shift_;
};

/// visit(sides, number of the body, of the opposite one) of contacts between elastic bodies.
template <class Visit>
void forEachContact(const Scene& scene, const Meshes& meshes, const Visit& visit) {
  for (const ContactPair& pair : scene.contacts)
    if (!pair.opposite.rigid)
      visit(Sides(scene, pair, meshes), pair.side.body, pair.opposite.body);
}

Mark reversed(const Mark& mark) {
  if (mark.kind() != Mark::Cut)
    return mark;
  std::vector<double> places = mark.places();
  std::vector<int> degrees = mark.degrees();
  std::reverse(places.begin(), places.end());
  std::reverse(degrees.begin(), degrees.end());
  for (double& place : places)
    place = -place;
  return Mark::cut(std::move(places), std::move(degrees));
}

int strength(const Mark& mark) {
  return mark == Mark::Cut           ? 3
         : mark == Mark::Bisect      ? 2
         : mark == Mark::RaiseDegree ? 1
                                     : 0;
}

Mark cutAt(double place, int degree) { return Mark::cut({place}, {degree, degree}); }

/// Of the two elements at the end of a bond: the longer one gets the other's node, else the one of
/// lower degree another degree.
void match(const Sides& sides, int e, int end, adaptivity::Marks& ofSide,
           adaptivity::Marks& ofOpposite) {
  constexpr double close = 1e-6;
  constexpr double sliver = 0.05;
  const auto there = sides.across(e, end * (1 - close));
  if (!there)
    return;
  const int f = there->element;
  Mark& own = ofSide[at(e)];
  Mark& other = ofOpposite[at(f)];
  const auto far = sides.across(e, -end * (1 - close));
  if (far && far->element == f && std::abs(far->t) < 1 - sliver) {
    const double beyond = close / 2 * (far->t - there->t);
    other = cutAt(far->t + beyond, sides.other(f).degree);
    return;
  }
  if (!far || far->element != f) {  // where the element opposite ends on this one
    double inside = end * (1 - close);
    double beyond = -inside;
    for (int k = 0; k < 60; ++k) {
      const double middle = (inside + beyond) / 2;
      const auto seen = sides.across(e, middle);
      (seen && seen->element == f ? inside : beyond) = middle;
    }
    if (std::abs(inside) < 1 - sliver)
      own = cutAt(inside, sides.own(e).degree);
    return;
  }
  const int p = sides.own(e).degree;
  const int q = sides.other(f).degree;
  if (p != q)
    (p < q ? own : other) = Mark::RaiseDegree;
}

/// Is an element cut at transitions, which leaves its degree, and not toward singular points?
bool isCutAtTransitions(const Mark& mark, int degree) {
  const std::vector<int>& degrees = mark.degrees();
  return mark == Mark::Cut &&
         std::all_of(degrees.begin(), degrees.end(), [&](int p) { return p == degree; });
}

/// The mark of an element that is cut, with the cuts of the one that it meets and what degrees that
/// gains: where a transition is cut on one side alone, the other one is a line under a curve.
Mark followed(const Sides& sides, int e, int f, const Mark& own, const Mark& other) {
  constexpr double sliver = 0.1;
  const int degree = sides.own(e).degree;
  std::vector<double> ends = own == Mark::Cut ? own.places() : std::vector<double>{0};
  const std::vector<int> degrees =
      own == Mark::Cut ? own.degrees() : std::vector<int>{degree, degree};
  std::vector<double> places = other.places();
  std::vector<int> gained = other.degrees();
  const auto pieceAt = [&](double t) {
    return std::upper_bound(places.begin(), places.end(), t) - places.begin();
  };
  for (const double end : ends) {
    const auto there = sides.across(e, end);
    if (!there || there->element != f)
      continue;
    const double t = there->t;
    const auto k = pieceAt(t);
    const double before = k == 0 ? -1 : places[at(k - 1)];
    const double after = at(k) == places.size() ? 1 : places[at(k)];
    if (t - before < sliver || after - t < sliver)
      continue;
    places.insert(places.begin() + k, t);
    gained.insert(gained.begin() + k, gained[at(k)]);
  }
  ends.insert(ends.begin(), -1);
  ends.push_back(1);
  for (std::size_t k = 0; k < degrees.size(); ++k) {
    const auto there = sides.across(e, 0.5 * (ends[k] + ends[k + 1]));
    if (there && there->element == f) {
      int& piece = gained[at(pieceAt(there->t))];
      piece = std::max(piece,
                       std::min(sides.other(f).degree + degrees[k] - degree, degrees[k]));
    }
  }
  return Mark::cut(std::move(places), std::move(gained));
}

adaptivity::Marks none(const bem::Mesh& mesh) {
  return adaptivity::Marks(at(mesh.size()));
}

}  // namespace

std::vector<std::vector<bem::Piece>> matchedAtBonds(
    const Scene& scene, std::vector<std::vector<bem::Piece>> meshes) {
  constexpr int most = 2 * bem::largestDegree;
  for (int step = 0; step < most; ++step) {
    std::vector<bem::Mesh> made;
    made.reserve(meshes.size());  // what refers to them follows
    Meshes all;
    std::vector<adaptivity::Marks> marks;
    for (std::size_t b = 0; b < meshes.size(); ++b) {
      made.emplace_back(scene.bodies[b].outline, meshes[b]);
      all.push_back(&made.back());
      marks.push_back(none(made.back()));
    }
    forEachContact(scene, all, [&](const Sides& sides, std::size_t a, std::size_t b) {
      sides.forEachEnd([&](int e, int end) { match(sides, e, end, marks[a], marks[b]); });
    });
    if (std::none_of(marks.begin(), marks.end(), adaptivity::anyMarked))
      break;
    for (std::size_t b = 0; b < meshes.size(); ++b)
      meshes[b] = piecesOf(adaptivity::refine(made[b], marks[b]));
  }
  return meshes;
}

void shareMarked(const Scene& scene, const Meshes& meshes,
                 std::vector<std::vector<int>>& worst) {
  const auto marked = worst;
  const auto has = [](const std::vector<int>& elements, int e) {
    return std::binary_search(elements.begin(), elements.end(), e);
  };
  forEachContact(scene, meshes, [&](const Sides& sides, std::size_t a, std::size_t b) {
    sides.forEachMatch([&](int e, int f) {
      if (has(marked[a], e))
        worst[b].push_back(f);
      if (has(marked[b], f))
        worst[a].push_back(e);
    });
  });
  for (std::vector<int>& elements : worst) {
    std::sort(elements.begin(), elements.end());
    elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
  }
}

void shareMarks(const Scene& scene, const Meshes& meshes,
                std::vector<adaptivity::Marks>& marks) {
  forEachContact(scene, meshes, [&](const Sides& sides, std::size_t a, std::size_t b) {
    sides.forEachMatch([&](int e, int f) {
      Mark& own = marks[a][at(e)];
      Mark& other = marks[b][at(f)];
      const int p = sides.own(e).degree;
      const int q = sides.other(f).degree;
      if (strength(own) > strength(other) || (strength(own) == strength(other) && p > q))
        other = reversed(own);
      else
        own = reversed(other);
      if (p != q && strength(own) <= strength(Mark::RaiseDegree)) {
        own = p < q ? Mark::RaiseDegree : Mark::None;
        other = p < q ? Mark::None : Mark::RaiseDegree;
      }
    });
  });
  // a long element yields as a soft layer to what short ones press on it with
  constexpr double longest = 4;
  constexpr double shortest = 0.5 + 1e-6;
  forEachContact(scene, meshes, [&](const Sides& sides, std::size_t a, std::size_t b) {
    sides.forEachFaced([&](int e, const Sides::Place& there) {
      const int f = there.element;
      Mark& own = marks[a][at(e)];
      Mark& other = marks[b][at(f)];
      const double ratio = sides.other(f).half / sides.own(e).half;
      if (strength(own) >= strength(Mark::Bisect) && ratio > shortest &&
          isCutAtTransitions(other, sides.other(f).degree))
        other = followed(sides, e, f, own, other);
      if (strength(own) > 0 && strength(other) < strength(Mark::Bisect) &&
          ratio > longest)
        other = Mark::Bisect;
    });
  });
  for (std::size_t b = 0; b < marks.size(); ++b)
    marks[b] = adaptivity::withoutShort(*meshes[b], std::move(marks[b]));
}

}  // namespace epafi::drivers
