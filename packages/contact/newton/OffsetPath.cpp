#include "contact/newton/OffsetPath.hpp"

#include "contact/newton/OffsetTableau.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi::contact {

namespace {

constexpr double softness = 1e5;    // compliance of springs over the mean of D_ii
constexpr double farthest = 100;    // largest t over that of the start
constexpr double sameBound = 1e-9;  // relative error of a bound on its linear piece
constexpr double nearBound = 1e-3;  // relative error of a tangent to a curved bound
constexpr double noise = 1e-12;     // error of a bound over the load
constexpr double never = std::numeric_limits<double>::infinity();

// v_i in [1, 2), different for each i, so that no two coefficients change at the same t.
double generic(Index i, int direction) {
  constexpr double goldenSection = 0.6180339887498949;
  return 1 + std::fmod((1 + direction) * goldenSection * static_cast<double>(i + 1), 1);
}

/// The problem scaled by λ = scale λ̂, r = r̂ / scale, so that D̂ has a unit diagonal,
/// with free rigid motions eliminated by their springs.
class Scaled {
 public:
  Scaled(const Problem& problem, const Vector& placement)
      : problem_(problem), D_(problem.flexibility.entries().copy()) {
    const Index n = problem.size();
    d_ = problem.offset;
    for (const auto& [row, column, value] : problem.surface.linear)
      D_(row, column) += value;
    double mean = 0;
    for (Index i = 0; i < n; ++i)
      mean += D_(i, i) / static_cast<double>(n);
    for (Index j = 0; j < problem.rigidMotions(); ++j) {
      double largest = 0;
      for (Index i = 0; i < n; ++i)
        largest = std::max(largest, std::abs(problem.rigid(i, j)));
      const double soft = largest > 0 ? softness * mean / (largest * largest) : 0;
      const double parallel = 1 + soft * problem.stiffness(j);
      springs_.push_back(soft / parallel);
      rest_.push_back(placement[at(j)] / parallel);
      const double centre = rest_.back() + springs_.back() * problem.rigidLoad[at(j)];
      for (Index c = 0; c < n; ++c) {
        d_[at(c)] += problem.rigid(c, j) * centre;
        for (Index r = 0; r < n; ++r)
          D_(r, c) += springs_.back() * problem.rigid(r, j) * problem.rigid(c, j);
      }
    }
    for (Index i = 0; i < n; ++i) {
      scale_.push_back(D_(i, i) > 0 ? 1 / std::sqrt(D_(i, i)) : 1);
      d_[at(i)] *= scale_.back();
    }
    for (Index c = 0; c < n; ++c)
      for (Index r = 0; r < n; ++r)
        D_(r, c) *= scale_[at(r)] * scale_[at(c)];
  }

  double scale(Index i) const { return scale_[at(i)]; }
  double stress(Index i) const { return problem_.stress / scale(i); }
  const Matrix& flexibility() const { return D_; }
  const Vector& offset() const { return d_; }

  /// The tangent of a bound at some pressures.
  BoundPiece tangent(Index i, const Vector& pressures) const {
    const Tangential& t = problem_.tangentials[at(i - problem_.normals)];
    BoundPiece piece{t.bound(pressures), t.slope(pressures)};
    double parts = piece.constant;
    if (piece.slope != 0) {
      piece.normal = t.normal();
      const double part = piece.slope * pressures[at(piece.normal)];
      piece.constant -= part;
      parts += std::abs(part);
      piece.slope *= scale(piece.normal) / scale(i);
    }
    const double rounding = 64 * std::numeric_limits<double>::epsilon() * parts;
    piece.constant = std::abs(piece.constant) <= rounding ? 0 : piece.constant / scale(i);
    return piece;
  }

  Vector unknowns(const OffsetTableau& tableau, double t) const {
    Vector result;
    for (Index i = 0; i < problem_.size(); ++i)
      result.push_back(tableau.multiplier(i, t) * scale(i));
    for (Index j = 0; j < problem_.rigidMotions(); ++j) {
      double rest = problem_.rigidLoad[at(j)];
      for (Index i = 0; i < problem_.size(); ++i)
        rest -= problem_.rigid(i, j) * result[at(i)];
      result.push_back(rest_[at(j)] + springs_[at(j)] * rest);
    }
    return result;
  }

 private:
  const Problem& problem_;
  Matrix D_;
  Vector d_;
  Vector scale_;
  Vector springs_;  // 1 / (K + 1/soft), by motion; rest_: α without forces
  Vector rest_;
};

class Path {
 public:
  Path(const Problem& problem, const Vector& placement, int direction)
      : problem_(problem),
        scaled_(problem, placement),
        tableau_(problem.normals, scaled_.flexibility(), scaled_.offset()),
        following_(at(problem.normals)) {
    for (Index i = problem.normals; i < size(); ++i)
      if (!tangential(i).isTied())
        following_[at(tangential(i).normal())].push_back(i);
    begin(direction);
  }

  OffsetPath run(int mostPivots, const OffsetWatch& watch) {
    const int silent = static_cast<int>(std::clamp(1e9 / workOfPivot(size()), 1.0, 1e9));
    double t = start_;
    double direction = -1;
    OffsetPath result;
    while (result.pivots < mostPivots && t <= farthest * start_) {
      if (watch && result.pivots % silent == 0)
        watch(result.pivots, mostPivots);
      const double end = direction < 0 ? t : 2 * farthest * start_ - t;
      const Event event = firstKink(t, direction, firstChange(t, direction, end));
      t += direction * event.distance;
      if (event.kind == Event::End) {
        result.arrived = direction < 0;
        break;
      }
      direction = take(event, t, direction);
      result.pivots += 1;
    }
    result.unknowns = scaled_.unknowns(tableau_, result.arrived ? 0 : t);
    if (!std::all_of(result.unknowns.begin(), result.unknowns.end(),
                     [](double x) { return std::isfinite(x); }))
      result = {{}, result.pivots, false};
    return result;
  }

 private:
  struct Event {
    enum Kind { End, Change, Across, Kink } kind = End;
    double distance = never;
    Index coefficient = 0;
    BoundPiece piece{};  ///< next piece, of a kink
  };

  Index size() const { return problem_.size(); }
  const Tangential& tangential(Index i) const {
    return problem_.tangentials[at(i - problem_.normals)];
  }
  bool isTied(Index i) const { return i >= problem_.normals && tangential(i).isTied(); }
  bool isPressed(Index i) const { return tableau_.isActive(tangential(i).normal()); }
  /// Can its state change?  With a zero bound it cannot.
  bool isLive(Index i) const {
    if (tableau_.isNormal(i))
      return true;
    return !isTied(i) && (tableau_.piece(i).constant > 0 ||
                          (tableau_.piece(i).slope != 0 && isPressed(i)));
  }
  double sideOfSlip(Index i, double t) const {
    return tableau_.value(i, t) >= 0 ? 1 : -1;
  }

  Vector pressuresAt(double t) const {
    Vector result;
    for (Index i = 0; i < problem_.normals; ++i)
      result.push_back(std::max(tableau_.pressure(i, t), 0.0) * scaled_.scale(i));
    return result;
  }

  /// Start: all open or slipping forwards; v, and the t from which on that is the solution.
  void begin(int direction) {
    for (Index i = 0; i < size(); ++i) {
      if (isTied(i))
        tableau_.pivot(i);
      else if (!tableau_.isNormal(i))
        tableau_.setPiece(i, 1, scaled_.tangent(i, Vector(at(problem_.normals), 0.0)));
    }
    for (Index i = 0; i < size(); ++i) {
      if (isTied(i) || !isLive(i))
        continue;
      const double rate =
          (tableau_.isNormal(i) ? -1 : 1) * generic(i, direction) * scaled_.stress(i);
      tableau_.setRate(i, rate);
      start_ = std::max(start_, -1.001 * tableau_.value(i, 0) / rate);
    }
  }

  /// The first change of a state.
  Event firstChange(double t, double direction, double end) const {
    Event first{Event::End, end};
    // room >= 0 shrinks by `speed` for each unit of t
    const auto meet = [&](Event::Kind kind, Index i, double room, double speed) {
      if (speed > 0 && std::max(room, 0.0) < first.distance * speed)
        first = {kind, std::max(room, 0.0) / speed, i};
    };
    for (Index i = size(); i-- > 0;) {
      if (!isLive(i))
        continue;
      const double x = tableau_.value(i, t);
      const double speed = direction * tableau_.rate(i);
      const bool active = tableau_.isActive(i);
      const double sign =
          tableau_.isNormal(i) ? (active ? 1 : -1) : (active ? -1 : 1) * tableau_.side(i);
      meet(Event::Change, i, sign * x, -sign * speed);
      if (!tableau_.isNormal(i) && active)
        meet(Event::Across, i, 2 * tableau_.bound(i, t) - sign * x,
             sign * speed - 2 * direction * tableau_.boundRate(i));
    }
    return first;
  }

  /// `first`, or an earlier end of a linear piece of a bound.
  Event firstKink(double t, double direction, Event first) const {
    Vector last = pressuresAt(t + direction * first.distance);
    for (Index i = problem_.normals; i < size(); ++i) {
      if (!tangential(i).followsPressure() || !(isLive(i) || isPressed(i)))
        continue;
      const double line = tableau_.bound(i, t + direction * first.distance);
      if (isOn(i, line, last, sameBound))
        continue;
      first = kink(i, t, direction, first.distance);
      last = pressuresAt(t + direction * first.distance);
    }
    return first;
  }

  bool isOn(Index i, double line, const Vector& pressures, double tolerance) const {
    const double bound = tangential(i).bound(pressures) / scaled_.scale(i);
    return std::abs(bound - line) <= tolerance * bound + noise * scaled_.stress(i);
  }

  /// End of the current linear piece of bound i, which is before `behind`, by bisection
  /// with intersections: the tangent at `behind` intersects the piece at the kink, or
  /// between the kink and `behind`.  A curved bound gets the first tangent with an
  /// intersection near it.
  Event kink(Index i, double t, double direction, double behind) const {
    constexpr int most = 40;
    double before = 0;
    Event near;
    for (int k = 0; k < most; ++k) {
      const double end = t + direction * behind;
      BoundPiece piece = scaled_.tangent(i, pressuresAt(end));
      const double from = tableau_.gain(i, piece, t + direction * before);
      const double to = tableau_.gain(i, piece, end);
      const bool meets = from * to < 0;
      const double where = meets ? before + (behind - before) * from / (from - to)
                                 : 0.5 * (before + behind);
      const Vector pressures = pressuresAt(t + direction * where);
      const double line = tableau_.bound(i, t + direction * where);
      if (!isOn(i, line, pressures, sameBound)) {
        if (meets && near.kind == Event::End && isOn(i, line, pressures, nearBound))
          near = {Event::Kink, where, i, piece};
        behind = where;
      } else if (meets) {
        return {Event::Kink, where, i, piece};
      } else {
        before = where;
      }
    }
    if (near.kind == Event::End)
      near = {Event::Kink, behind, i,
              scaled_.tangent(i, pressuresAt(t + direction * behind))};
    return near;
  }

  /// Pivots at an event; returns the direction of t after it.
  double take(const Event& event, double t, double direction) {
    const Index i = event.coefficient;
    if (event.kind == Event::Kink) {
      const double side = isLive(i) ? tableau_.side(i) : sideOfSlip(i, t);
      const double factor = tableau_.setPiece(i, side, event.piece);
      if (!isLive(i) && tableau_.isActive(i))
        tableau_.pivot(i);
      return factor > 0 ? direction : -direction;
    }
    if (tableau_.isNormal(i)) {
      if (tableau_.isActive(i))
        open(i, t);
      else
        close(i, t);
      return tableau_.isActive(i) == (tableau_.rate(i) > 0) ? 1 : -1;
    }
    if (event.kind == Event::Across)
      tableau_.setPiece(i, -tableau_.side(i), tableau_.piece(i));
    tableau_.pivot(i);
    const bool forwards = tableau_.side(i) * tableau_.rate(i) > 0;
    return forwards == !tableau_.isActive(i) ? 1 : -1;
  }

  // Closes i; bounds that depend on its pressure get their piece at zero pressure.
  void close(Index i, double t) {
    Vector pressures = pressuresAt(t);
    pressures[at(i)] = sameBound * problem_.stress;
    for (const Index j : following_[at(i)]) {
      const bool slips =
          tangential(j).normal() == i && !tableau_.isActive(j) && !isLive(j);
      const double side = slips ? sideOfSlip(j, t) : tableau_.side(j);
      tableau_.setPiece(j, side, scaled_.tangent(j, pressures));
    }
    tableau_.pivot(i);
  }

  // Opens i; coefficients whose bounds become zero with it slip.
  void open(Index i, double t) {
    tableau_.pivot(i);
    const Vector pressures = pressuresAt(t);
    for (const Index j : following_[at(i)]) {
      if (tangential(j).normal() == i)
        tableau_.setPiece(j, tableau_.side(j), scaled_.tangent(j, pressures));
      if (tableau_.isActive(j) && !isLive(j))
        tableau_.pivot(j);
    }
  }

  const Problem& problem_;
  Scaled scaled_;
  OffsetTableau tableau_;
  std::vector<std::vector<Index>>
      following_;     // tangentials whose bound depends on a pressure
  double start_ = 0;  // t
};

}  // namespace

OffsetPath followOffset(const Problem& problem, const Vector& placement, int direction,
                        int mostPivots, const OffsetWatch& watch) {
  return Path(problem, placement, direction).run(mostPivots, watch);
}

}  // namespace epafi::contact
