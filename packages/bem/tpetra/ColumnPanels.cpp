#include "bem/tpetra/ColumnPanels.hpp"

#include "bem/tpetra/Redeal.hpp"

#include <algorithm>

namespace epafi::bem {

ColumnPanels::ColumnPanels(MPI_Comm comm, Index n) : comm_(comm), n_(n) {
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &processes_);
  for (int k = 0; k < count(); ++k)
    strides_.push_back(Matrix(rows(k), 0).stride());
  for (int k = rank_; k < count(); k += processes_)
    mine_.emplace_back(rows(k), columns(k));
}

void ColumnPanels::take(const Matrix& rows) {
  const Rows own = shareOf(rank_, processes_, n_);
  Vector sent(static_cast<std::size_t>(own.size() * width * processes_));
  Vector received(static_cast<std::size_t>(n_ * width));
  const auto below = [&](int rank, int k) {  // what a process has of a panel
    const Rows all = shareOf(rank, processes_, n_);
    return Rows{std::min(all.end, std::max(all.begin, begin(k))), all.end};
  };
  for (int first = 0; first < count(); first += processes_) {
    std::vector<int> sentCounts;
    std::vector<int> sentStarts;
    std::vector<int> receivedCounts;
    std::vector<int> receivedStarts;
    double* to = sent.data();
    Index awaited = 0;
    const int my = first + rank_;
    for (int r = 0; r < processes_; ++r) {
      sentStarts.push_back(static_cast<int>(to - sent.data()));
      const int k = first + r;
      const Rows part = k < count() ? below(rank_, k) : Rows{};
      for (Index j = 0; part.size() > 0 && j < columns(k); ++j, to += part.size())
        std::copy_n(rows.column(begin(k) + j) + (part.begin - own.begin), part.size(),
                    to);
      sentCounts.push_back(static_cast<int>(to - sent.data()) - sentStarts.back());
      receivedStarts.push_back(static_cast<int>(awaited));
      if (my < count())
        awaited += below(r, my).size() * columns(my);
      receivedCounts.push_back(static_cast<int>(awaited) - receivedStarts.back());
    }
    MPI_Alltoallv(sent.data(), sentCounts.data(), sentStarts.data(), MPI_DOUBLE,
                  received.data(), receivedCounts.data(), receivedStarts.data(),
                  MPI_DOUBLE, comm_);
    const double* from = received.data();
    for (int r = 0; my < count() && r < processes_; ++r) {
      const Rows part = below(r, my);
      for (Index j = 0; j < columns(my); ++j, from += part.size())
        std::copy_n(from, part.size(), mine(my).column(j) + (part.begin - begin(my)));
    }
  }
}

PanelStream::PanelStream(const ColumnPanels& panels) : panels_(panels) {
  for (int k = 0; k < std::min(2, panels.count()); ++k)
    buffers_[k] = Matrix(panels.rows(k), panels.columns(k));
}

void PanelStream::begin(int k) {
  // a sender only reads
  double* data =
      panels_.isMine(k) ? const_cast<double*>(panels_.mine(k).data()) : place(k);
  const Index count = panels_.stride(k) * panels_.columns(k);
  MPI_Ibcast(data, static_cast<int>(count), MPI_DOUBLE, panels_.owner(k), panels_.comm(),
             &request_);
}

PanelStream::View PanelStream::end(int k) {
  MPI_Wait(&request_, MPI_STATUS_IGNORE);
  return {panels_.isMine(k) ? panels_.mine(k).data() : place(k), panels_.stride(k)};
}

}  // namespace epafi::bem
