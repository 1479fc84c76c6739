#pragma once

#include "bem/base/Error.hpp"

#include <array>
#include <hdf5.h>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace epafi::drivers {

/// Stops HDF5 from printing errors while it exists: this program handles them.
class QuietHdf5 {
 public:
  QuietHdf5() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~QuietHdf5() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }
  QuietHdf5(const QuietHdf5&) = delete;
  QuietHdf5& operator=(const QuietHdf5&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// The description of the last HDF5 error, from where the error arose.
inline std::string hdf5Cause() {
  std::string cause = "HDF5 gives no cause";
  const auto innermost = [](unsigned, const H5E_error2_t* error, void* text) -> herr_t {
    if (error->desc != nullptr && *error->desc != '\0')
      *static_cast<std::string*>(text) = error->desc;
    return 1;  // stop at the first one
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, innermost, &cause);
  return cause;
}

/// An open HDF5 object, closed with its last copy.  May be empty.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Hdf5Handle() = default;
  Hdf5Handle(hid_t id, Close close)
      : id_(new hid_t(id), [close](const hid_t* open) {
          close(*open);
          delete open;
        }) {}

  hid_t id() const { return *id_; }

 private:
  std::shared_ptr<const hid_t> id_;
};

/// \throws bem::InputError if not `good`, with `what` and the cause from HDF5.
inline void check(bool good, const std::string& what = "") {
  if (!good)
    throw bem::InputError(what, what.empty() ? "" : ": ", hdf5Cause());
}
/// The handle of an object that was opened.  \throws as check, if `id` is negative.
inline Hdf5Handle checked(hid_t id, Hdf5Handle::Close close,
                          const std::string& what = "") {
  check(id >= 0, what);
  return {id, close};
}

/// The HDF5 type of a number in memory.
template <class T>
hid_t hdf5Type() {
  if constexpr (std::is_same_v<T, double>)
    return H5T_NATIVE_DOUBLE;
  else if constexpr (std::is_same_v<T, int>)
    return H5T_NATIVE_INT;
  else if constexpr (std::is_same_v<T, long long>)
    return H5T_NATIVE_LLONG;
  else if constexpr (std::is_same_v<T, unsigned long long>)
    return H5T_NATIVE_ULLONG;
  else
    return H5T_NATIVE_UCHAR;
}

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

/// Reads an HDF5 file, which may be damaged or somebody else's, and nothing that it has in
/// other files (external links, external and virtual datasets): all methods throw bem::InputError with what
/// is missing or damaged, without the name of the file.
class Hdf5Reader {
 public:
  /// \throws bem::InputError if the file is missing, incomplete or not an HDF5 file.
  explicit Hdf5Reader(const std::string& path);

  bool has(const std::string& name) const;

  /// Reads an array of `columns` columns, row by row.
  template <class T>
  std::vector<T> array(const std::string& name, hsize_t columns) const {
    std::vector<T> values(columns * rowsOf(name, columns, sizeof(T)));
    read(name, hdf5Type<T>(), values.data());
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
  Hdf5Handle spaceOf(const std::string& name) const;
  hsize_t rowsOf(const std::string& name, hsize_t columns, std::size_t bytes) const;
  void read(const std::string& name, hid_t type, void* values) const;
  void readAttribute(const std::string& group, const std::string& name, hid_t type,
                     void* value) const;

  QuietHdf5 quiet_;
  unsigned long long bytes_ = 0;  ///< of the file
  Hdf5Handle file_;
  Hdf5Handle within_;  ///< follows no link into another file
};

}  // namespace epafi::drivers
