#include "contact/newton/OffsetTableau.hpp"

#include <algorithm>

namespace epafi::contact {

OffsetTableau::OffsetTableau(Index normals, const Matrix& flexibility,
                             const Vector& offset)
    : size_(static_cast<Index>(offset.size())),
      normals_(normals),
      T_(size_, size_ + 2),
      active_(offset.size(), false),
      side_(offset.size(), 0.0),
      pieces_(offset.size()) {
  for (Index c = 0; c < size_; ++c)
    for (Index r = 0; r < size_; ++r)
      T_(r, c) = -flexibility(r, c);
  std::copy(offset.begin(), offset.end(), T_.column(size_));
}

double OffsetTableau::valueOf(const BoundPiece& piece, double t) const {
  return piece.constant +
         (piece.slope != 0 ? piece.slope * pressure(piece.normal, t) : 0);
}

double OffsetTableau::boundRate(Index i) const {
  const BoundPiece& own = piece(i);
  return own.slope != 0 && isActive(own.normal) ? own.slope * rate(own.normal) : 0;
}

double OffsetTableau::multiplier(Index i, double t) const {
  return (isActive(i) ? value(i, t) : 0) + side(i) * bound(i, t);
}

void OffsetTableau::pivot(Index i) {
  double* own = T_.column(i);
  const double pivot = own[i];
  own[i] = 0;
  for (Index c = 0; c < size_ + 2; ++c) {
    double* column = T_.column(c);
    if (c == i || column[i] == 0)
      continue;
    const double factor = column[i] / pivot;
    for (Index r = 0; r < size_; ++r)
      column[r] -= factor * own[r];
    column[i] = -factor;
  }
  for (Index r = 0; r < size_; ++r)
    own[r] /= pivot;
  own[i] = 1 / pivot;
  active_[at(i)] = !active_[at(i)];
}

double OffsetTableau::setPiece(Index i, double side, const BoundPiece& piece) {
  // W: change of side s, as a row of the tableau
  Vector gain(at(size_ + 2), 0.0);
  const auto add = [&](double factor, const BoundPiece& of) {
    gain[at(size_)] += factor * of.constant;
    const double by = factor * of.slope;
    if (by == 0)
      return;
    if (!isActive(of.normal))
      gain[at(of.normal)] += by;
    for (Index c = 0; c < size_ + 2 && isActive(of.normal); ++c)
      gain[at(c)] += by * T_(of.normal, c);
  };
  add(side, piece);
  add(-side_[at(i)], pieces_[at(i)]);
  side_[at(i)] = side;
  pieces_[at(i)] = piece;
  if (isActive(i)) {
    for (Index c = 0; c < size_ + 2; ++c)
      T_(i, c) -= gain[at(c)];
    return 1;
  }
  // solves x_i = x_i' + W for x_i, by the factor 1 / (1 - W_i)
  const double factor = 1 - gain[at(i)];
  double* own = T_.column(i);
  for (Index r = 0; r < size_; ++r)
    own[r] /= factor;
  for (Index c = 0; c < size_ + 2; ++c) {
    double* column = T_.column(c);
    for (Index r = 0; r < size_ && c != i && gain[at(c)] != 0; ++r)
      column[r] += gain[at(c)] * own[r];
  }
  return factor;
}

}  // namespace epafi::contact
