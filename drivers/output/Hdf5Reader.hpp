#pragma once

#include "drivers/output/Hdf5Handle.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// Reads an HDF5 file that may be anything: all methods throw bem::InputError saying what
/// is missing or damaged, without the file's name.
class Hdf5Reader {
 public:
  /// \throws bem::InputError if there is no such file or it is not (all of) an HDF5 file.
  explicit Hdf5Reader(const std::string& path);

  bool has(const std::string& name) const;

  /// All numbers of an array of `columns` columns, row by row.
  template <class T>
  std::vector<T> array(const std::string& name, hsize_t columns) const {
    const Hdf5Handle data = dataset(name);
    std::vector<T> values(columns * rowsOf(data, name, columns, sizeof(T)));
    read(data, name, hdf5Type<T>(), values.data());
    return values;
  }
  std::string text(const std::string& name) const;

  /// One number, an attribute of a group.
  template <class T>
  T attribute(const std::string& group, const std::string& name) const {
    T value{};
    readAttribute(group, name, hdf5Type<T>(), &value);
    return value;
  }

 private:
  Hdf5Handle dataset(const std::string& name) const;
  hsize_t rowsOf(const Hdf5Handle& dataset, const std::string& name, hsize_t columns,
                 std::size_t bytes) const;
  static void read(const Hdf5Handle& dataset, const std::string& name, hid_t type,
                   void* values);
  void readAttribute(const std::string& group, const std::string& name, hid_t type,
                     void* value) const;

  QuietHdf5 quiet_;
  unsigned long long bytes_ = 0;  ///< of the file
  Hdf5Handle file_;
};

}  // namespace epafi::drivers
