#include "bem/tpetra/Redeal.hpp"

#include <algorithm>

namespace epafi::bem {

Redeal::Redeal(MPI_Comm comm, Index n, Index m) : comm_(comm), n_(n), m_(m) {
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &processes_);
  // a buffer holds all rows of my chunk, or my rows of everybody's
  const Index widest = std::min(width_, share(0, m_).size());
  const Index tallest = share(0, n_).size();
  sent_.resize(static_cast<std::size_t>(widest * tallest * processes_));
  received_.resize(sent_.size());
}

Rows Redeal::share(int rank, Index count) const {
  return shareOf(rank, processes_, count);
}

/// The columns of a process that move together.
Rows Redeal::chunk(int rank, Index offset) const {
  const Rows all = share(rank, m_);
  const Index begin = std::min(all.end, all.begin + offset);
  return {begin, std::min(all.end, begin + width_)};
}

/// A buffer with count(r) numbers at the place of process r.
template <class Count>
Redeal::Pieces Redeal::pieces(const Count& count) const {
  Pieces pieces;
  int start = 0;
  for (int r = 0; r < processes_; ++r) {
    pieces.starts.push_back(start);
    pieces.counts.push_back(asInt(count(r)));
    start += pieces.counts.back();
  }
  return pieces;
}

/// A buffer with my rows of everybody's chunk.
Redeal::Pieces Redeal::byRows(Index offset) const {
  return pieces([&](int r) { return share(rank_, n_).size() * chunk(r, offset).size(); });
}

/// A buffer with everybody's rows of my chunk.
Redeal::Pieces Redeal::byColumns(Index offset) const {
  return pieces([&](int r) { return share(r, n_).size() * chunk(rank_, offset).size(); });
}

void Redeal::exchange(const Pieces& sent, const Pieces& received) {
  MPI_Alltoallv(sent_.data(), sent.counts.data(), sent.starts.data(), MPI_DOUBLE,
                received_.data(), received.counts.data(), received.starts.data(),
                MPI_DOUBLE, comm_);
}

Matrix Redeal::toColumns(const Matrix& rows, Matrix columns) {
  const Index first = share(rank_, m_).begin;
  const Index height = share(rank_, n_).size();
  for (Index offset = 0; offset < share(0, m_).size(); offset += width_) {
    double* to = sent_.data();
    for (int r = 0; r < processes_; ++r) {
      const Rows theirs = chunk(r, offset);
      for (Index j = theirs.begin; j < theirs.end; ++j, to += height)
        std::copy_n(rows.column(j), height, to);
    }
    exchange(byRows(offset), byColumns(offset));
    const double* from = received_.data();
    const Rows mine = chunk(rank_, offset);
    for (int r = 0; r < processes_; ++r) {
      const Rows theirs = share(r, n_);
      for (Index j = mine.begin; j < mine.end; ++j, from += theirs.size())
        std::copy_n(from, theirs.size(), columns.column(j - first) + theirs.begin);
    }
  }
  return columns;
}

Matrix Redeal::toRows(const Matrix& columns, Matrix rows) {
  const Index first = share(rank_, m_).begin;
  const Index height = share(rank_, n_).size();
  for (Index offset = 0; offset < share(0, m_).size(); offset += width_) {
    double* to = sent_.data();
    const Rows mine = chunk(rank_, offset);
    for (int r = 0; r < processes_; ++r) {
      const Rows theirs = share(r, n_);
      for (Index j = mine.begin; j < mine.end; ++j, to += theirs.size())
        std::copy_n(columns.column(j - first) + theirs.begin, theirs.size(), to);
    }
    exchange(byColumns(offset), byRows(offset));
    const double* from = received_.data();
    for (int r = 0; r < processes_; ++r) {
      const Rows theirs = chunk(r, offset);
      for (Index j = theirs.begin; j < theirs.end; ++j, from += height)
        std::copy_n(from, height, rows.column(j));
    }
  }
  return rows;
}

}  // namespace epafi::bem
