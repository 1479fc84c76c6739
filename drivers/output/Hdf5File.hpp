#pragma once

#include "drivers/output/Hdf5Handle.hpp"

#include <array>
#include <string>
#include <vector>

namespace epafi::drivers {

/// An HDF5 file, built as an image in memory: HDF5 itself does not survive a full disk,
/// so the caller writes the bytes and handles such errors.  Names are paths; missing
/// groups are created.
///
/// All methods throw bem::InputError with the cause that HDF5 gives.
class Hdf5Writer {
 public:
  Hdf5Writer();

  /// Writes an array row by row, `columns` numbers each.
  template <class T>
  void array(const std::string& name, const std::vector<T>& values, hsize_t columns = 1) {
    const std::array<hsize_t, 2> size = {values.size() / columns, columns};
    const T none{};  // HDF5 requires an address
    dataset(name, hdf5Type<T>(), simpleSpace(columns == 1 ? 1 : 2, size.data()),
            values.empty() ? &none : values.data());
  }
  /// Writes a text (ASCII or UTF-8) as one string of fixed length.
  void text(const std::string& name, const std::string& value);

  /// Writes an attribute of a group; a single number as a scalar.
  template <class T>
  void attribute(const std::string& group, const std::string& name,
                 const std::vector<T>& values) {
    const hsize_t size = values.size();
    attribute(group, name, hdf5Type<T>(), simpleSpace(size == 1 ? 0 : 1, &size),
              values.data());
  }
  void attribute(const std::string& group, const std::string& name,
                 const std::string& value);

  /// The bytes of the file.  The same calls give the same bytes.
  std::string bytes() const;

 private:
  static Hdf5Handle simpleSpace(int rank, const hsize_t* size = nullptr);
  void dataset(const std::string& name, hid_t type, const Hdf5Handle& space,
               const void* data);
  void attribute(const std::string& group, const std::string& name, hid_t type,
                 const Hdf5Handle& space, const void* value);

  QuietHdf5 quiet_;
  Hdf5Handle links_;     ///< creates the missing groups of a path
  Hdf5Handle creation_;  ///< no time stamps, so that the same calls give the same bytes
  Hdf5Handle file_;
};

/// Reads an HDF5 file, which may be damaged: all methods throw bem::InputError with what
/// is missing or damaged, without the name of the file.
class Hdf5Reader {
 public:
  /// \throws bem::InputError if the file is missing, incomplete or not an HDF5 file.
  explicit Hdf5Reader(const std::string& path);

  bool has(const std::string& name) const;

  /// Reads an array of `columns` columns, row by row.
  template <class T>
  std::vector<T> array(const std::string& name, hsize_t columns) const {
    const Hdf5Handle data = dataset(name);
    std::vector<T> values(columns * rowsOf(data, name, columns, sizeof(T)));
    read(data, name, hdf5Type<T>(), values.data());
    return values;
  }
  std::string text(const std::string& name) const;

  /// Reads an attribute of a group that is a single number.
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
