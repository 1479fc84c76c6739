#pragma once

#include "bem/base/DenseAlgebra.hpp"

#include <memory>
#include <string>
#include <vector>

namespace epafi::drivers {

/// This process's part of an array that all processes write together: its rows from
/// `first` on, of `rows` in all, `columns` numbers each.
template <class T>
struct Slice {
  long long rows = 0;
  long long first = 0;
  long long columns = 1;
  std::vector<T> mine;
};

/// My share of the rows of an array that every process has whole.
template <class T>
Slice<T> shareOf(const std::vector<T>& whole, long long columns,
                 const bem::DenseAlgebra& algebra) {
  const auto rows = static_cast<long long>(whole.size()) / columns;
  const bem::Rows mine = algebra.myRows(rows);
  const auto at = [&](bem::Index row) {
    return whole.begin() + static_cast<std::ptrdiff_t>(row * columns);
  };
  return {rows, mine.begin, columns, {at(mine.begin), at(mine.end)}};
}

/// Writes an HDF5 file: several processes by MPI-IO, one as an image in memory that goes
/// to the disk as a whole.
///
/// Nothing happens before write(): it first makes sure that there is room, since MPI-IO
/// and HDF5 do not survive a full disk.  All calls are collective, with the same
/// arguments but for Slice::mine.  Names are paths; groups are made on the way.
class Hdf5Writer {
 public:
  Hdf5Writer(std::string path, const bem::DenseAlgebra& algebra);
  ~Hdf5Writer();
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;

  /// For T = double, int, long long, unsigned char.
  template <class T>
  void array(const std::string& name, Slice<T> slice);
  /// A text of any length, in ASCII or UTF-8, as one string of fixed length.
  void text(const std::string& name, const std::string& value);

  /// Attributes of a group.  One number is stored without dimension.  For T = int,
  /// double, unsigned long long.
  template <class T>
  void attribute(const std::string& group, const std::string& name,
                 std::vector<T> values);
  void attribute(const std::string& group, const std::string& name,
                 const std::string& value);

  /// \throws bem::InputError on all processes, saying why, if the file cannot be written.
  void write();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace epafi::drivers
