#pragma once

#include <memory>
#include <string>
#include <vector>

namespace epafi::drivers {

/// Reads an HDF5 file that may be anything: all methods throw bem::InputError saying what
/// is missing or damaged, without the file's name.
class Hdf5Reader {
 public:
  /// \throws bem::InputError if there is no such file or it is not (all of) an HDF5 file.
  explicit Hdf5Reader(const std::string& path);
  ~Hdf5Reader();
  Hdf5Reader(const Hdf5Reader&) = delete;
  Hdf5Reader& operator=(const Hdf5Reader&) = delete;

  bool has(const std::string& name) const;

  /// All numbers of an array of `columns` columns, row by row.  For T = double, int.
  template <class T>
  std::vector<T> array(const std::string& name, long long columns) const;
  std::string text(const std::string& name) const;

  /// One number, an attribute of a group.  For T = double, int, unsigned long long.
  template <class T>
  T attribute(const std::string& group, const std::string& name) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace epafi::drivers
