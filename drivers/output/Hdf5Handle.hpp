#pragma once

#include "bem/base/Error.hpp"

#include <hdf5.h>
#include <string>
#include <type_traits>
#include <utility>

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

/// Owns an open HDF5 object and closes it in the destructor.  May be empty.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Hdf5Handle() = default;
  Hdf5Handle(hid_t id, Close how) : id_(id), close_(how) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept
      : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Hdf5Handle() {
    if (id_ >= 0)
      close_(id_);
  }

  hid_t id() const { return id_; }

 private:
  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
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

}  // namespace epafi::drivers
