#include "reference/ArcMoments.hpp"

#include <algorithm>

namespace epafi::reference {

namespace {

QuadVec turned(const QuadVec& a, const Quad& angle) {
  const Quad c = cos(angle);
  const Quad s = sin(angle);
  return {c * a.x - s * a.y, s * a.x + c * a.y};
}

/// A bisected pair of this level is 2^-level as long.
constexpr int deepest = 48;

}  // namespace

QuadVec ArcMoments::Arc::tangent(const Quad& t) const {
  return turned(middleTangent, alpha * t);
}

// chords from the start have the direction of the tangent half way
QuadVec ArcMoments::Arc::point(const Quad& t) const {
  const Quad s = alpha * (1 + t) / 2;
  const Quad sinc = s == 0 ? Quad(1) : Quad(sin(s) / s);
  return from + (half * (1 + t) * sinc) * tangent((t - 1) / 2);
}

ArcMoments::Arc ArcMoments::arcOf(const bem::Mesh& mesh, int e) {
  const bem::Piece& piece = mesh[e].piece;
  const bem::Curve& edge = mesh.outline().edge(piece.edge).curve;
  Arc whole;
  const bem::Vec2 tangent = edge.frame().tangent;
  const Quad length = sqrt(Quad(tangent.x) * tangent.x + Quad(tangent.y) * tangent.y);
  whole.from = {edge.from().x, edge.from().y};
  whole.middleTangent = {tangent.x / length, tangent.y / length};
  whole.half = edge.half();
  whole.alpha = Quad(edge.angle()) / 2;
  Arc part = whole;
  // places from the nearer end, as the mesh holds them
  const auto place = [&](const bem::Position& p) {
    return p.fromStart < p.toEnd ? Quad(p.fromStart) / whole.half - 1
                                 : 1 - Quad(p.toEnd) / whole.half;
  };
  const Quad start = place(piece.start);
  const Quad end = place(piece.end);
  part.from = whole.point(start);
  part.middleTangent = whole.tangent((start + end) / 2);
  part.half = whole.half * (end - start) / 2;
  part.alpha = whole.alpha * (end - start) / 2;
  return part;
}

ArcMoments::ArcMoments(const bem::Mesh& mesh, int e, int f, int largestDegree)
    : e_(arcOf(mesh, e)),
      f_(arcOf(mesh, f)),
      degree_(largestDegree),
      rule_(quadGauss(12 + largestDegree)),
      values_(Fields * (degree_ + 1) * (degree_ + 1)) {
  if (e == f)
    addSelf();
  else
    bisect({-1, 1}, {-1, 1}, 0);
}

double ArcMoments::operator()(Field field, int i, int j) const {
  return static_cast<double>(const_cast<ArcMoments*>(this)->value(field, i, j));
}

void ArcMoments::bisect(Part s, Part t, int level) {
  const QuadVec w = e_.point((s.from + s.to) / 2) - f_.point((t.from + t.to) / 2);
  const Quad lengthE = e_.half * (s.to - s.from);
  const Quad lengthF = f_.half * (t.to - t.from);
  const Quad gap = sqrt(dot(w, w)) - (lengthE + lengthF) / 2;
  const Quad longer = std::max(lengthE, lengthF);
  if (gap >= longer)
    return addApart(s, t);
  if (level >= 2 * deepest)
    return;
  if (lengthE >= lengthF) {
    const Quad middle = (s.from + s.to) / 2;
    bisect({s.from, middle}, t, level + 1);
    bisect({middle, s.to}, t, level + 1);
  } else {
    const Quad middle = (t.from + t.to) / 2;
    bisect(s, {t.from, middle}, level + 1);
    bisect(s, {middle, t.to}, level + 1);
  }
}

void ArcMoments::addApart(Part s, Part t) {
  const Quad scaleS = (s.to - s.from) / 2;
  const Quad scaleT = (t.to - t.from) / 2;
  for (std::size_t q = 0; q < rule_.points.size(); ++q)
    for (std::size_t k = 0; k < rule_.points.size(); ++k)
      addPoint((s.from + s.to) / 2 + scaleS * rule_.points[q],
               (t.from + t.to) / 2 + scaleT * rule_.points[k],
               scaleS * scaleT * rule_.weights[q] * rule_.weights[k]);
}

void ArcMoments::addSelf() {
  Quad to = 2;
  for (int level = 0; level < 2 * deepest; ++level) {
    const Quad from = to / 2;
    for (std::size_t q = 0; q < rule_.points.size(); ++q) {
      const Quad r = (from + to) / 2 + (to - from) / 2 * rule_.points[q];
      const Quad scale = (2 - r) / 2;
      for (std::size_t k = 0; k < rule_.points.size(); ++k) {
        const Quad t = -1 + scale * (1 + rule_.points[k]);
        const Quad weight = (to - from) / 2 * rule_.weights[q] * scale * rule_.weights[k];
        addPoint(t + r, t, weight);
        addPoint(t, t + r, weight);
      }
    }
    to = from;
  }
}

void ArcMoments::addPoint(const Quad& s, const Quad& t, const Quad& weight) {
  const QuadVec w = e_.point(s) - f_.point(t);
  const QuadVec tangentE = e_.tangent(s);
  const QuadVec tangentF = f_.tangent(t);
  const Quad square = dot(w, w);
  const Quad at[Fields] = {log(square) / 2, (w.x * w.x - w.y * w.y) / square,
                           2 * w.x * w.y / square,
                           f_.half * (w.x * tangentF.y - w.y * tangentF.x) / square,
                           -e_.half * (w.x * tangentE.y - w.y * tangentE.x) / square};
  const std::vector<Quad> outer = legendre(degree_, s);
  const std::vector<Quad> inner = legendre(degree_, t);
  for (int field = 0; field < Fields; ++field)
    for (int i = 0; i <= degree_; ++i)
      for (int j = 0; j <= degree_; ++j)
        value(field, i, j) += weight * at[field] * outer[i] * inner[j];
}

}  // namespace epafi::reference
