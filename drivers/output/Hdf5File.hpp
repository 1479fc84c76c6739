#pragma once

#include "drivers/output/Hdf5Handle.hpp"

#include <array>
#include <string>
#include <vector>

namespace epafi::drivers {

/// An HDF5 file, made as an image in memory: a full disk is then the business of who
/// writes the bytes, which HDF5 itself would not survive.  Names are paths; groups are
/// made on the way.
///
/// All methods throw bem::InputError with HDF5's cause.
class Hdf5Writer {
 public:
  Hdf5Writer();

  /// Row by row, `columns` numbers each.
  template <class T>
  void array(const std::string& name, const std::vector<T>& values, hsize_t columns = 1) {
    const std::array<hsize_t, 2> size = {values.size() / columns, columns};
    const T none{};  // HDF5 wants an address
    dataset(name, hdf5Type<T>(), simpleSpace(columns == 1 ? 1 : 2, size.data()),
            values.empty() ? &none : values.data());
  }
  /// A text of any length, in ASCII or UTF-8, as one string of fixed length.
  void text(const std::string& name, const std::string& value);

  /// Attributes of a group.  One number is stored without dimension.
  template <class T>
  void attribute(const std::string& group, const std::string& name,
                 const std::vector<T>& values) {
    const hsize_t size = values.size();
    attribute(group, name, hdf5Type<T>(), simpleSpace(size == 1 ? 0 : 1, &size),
              values.data());
  }
  void attribute(const std::string& group, const std::string& name,
                 const std::string& value);

  /// The file.  The same calls make the same bytes.
  std::string bytes() const;

 private:
  static Hdf5Handle simpleSpace(int rank, const hsize_t* size = nullptr);
  void dataset(const std::string& name, hid_t type, const Hdf5Handle& space,
               const void* data);
  void attribute(const std::string& group, const std::string& name, hid_t type,
                 const Hdf5Handle& space, const void* value);

  QuietHdf5 quiet_;
  Hdf5Handle links_;     ///< groups on the way to a name are made
  Hdf5Handle creation_;  ///< without times the same calls make the same bytes
  Hdf5Handle file_;
};

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
