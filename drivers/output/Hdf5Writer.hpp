#pragma once

#include <memory>
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
  ~Hdf5Writer();
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;

  /// Row by row, `columns` numbers each.  For T = double, int, long long, unsigned char.
  template <class T>
  void array(const std::string& name, const std::vector<T>& values,
             long long columns = 1);
  /// A text of any length, in ASCII or UTF-8, as one string of fixed length.
  void text(const std::string& name, const std::string& value);

  /// Attributes of a group.  One number is stored without dimension.  For T = int,
  /// double, unsigned long long.
  template <class T>
  void attribute(const std::string& group, const std::string& name,
                 const std::vector<T>& values);
  void attribute(const std::string& group, const std::string& name,
                 const std::string& value);

  /// The file.  The same calls make the same bytes.
  std::string bytes() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace epafi::drivers
