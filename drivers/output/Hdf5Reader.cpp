#include "drivers/output/Hdf5Reader.hpp"

#include "drivers/output/Hdf5Handle.hpp"
#include "drivers/scene/SceneFile.hpp"

#include <array>
#include <cstring>
#include <filesystem>

namespace epafi::drivers {

using bem::InputError;
using bem::message;

struct Hdf5Reader::Parts {
  QuietHdf5 quiet;
  Hdf5Handle file;
  unsigned long long bytes = 0;

  Hdf5Handle dataset(const std::string& name) const {
    return checked(H5Dopen2(file.id(), name.c_str(), H5P_DEFAULT), H5Dclose,
                   name + " is missing");
  }
};

Hdf5Reader::Hdf5Reader(const std::string& path) : parts_(new Parts) {
  checkReadable(path);
  if (H5Fis_hdf5(path.c_str()) <= 0)
    throw InputError("is not an HDF5 file");
  parts_->bytes = std::filesystem::file_size(path);
  parts_->file = checked(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose,
                         "is damaged or not complete");
}

Hdf5Reader::~Hdf5Reader() = default;

bool Hdf5Reader::has(const std::string& name) const {
  const htri_t exists = H5Lexists(parts_->file.id(), name.c_str(), H5P_DEFAULT);
  check(exists >= 0, "is damaged");
  return exists > 0;
}

template <class T>
std::vector<T> Hdf5Reader::array(const std::string& name, long long columns) const {
  const Hdf5Handle dataset = parts_->dataset(name);
  const Hdf5Handle space =
      checked(H5Dget_space(dataset.id()), H5Sclose, name + " is damaged");
  const int rank = columns == 1 ? 1 : 2;
  std::array<hsize_t, 2> size = {0, 1};
  if (H5Sget_simple_extent_ndims(space.id()) != rank)
    throw InputError(name + " has another shape");
  check(H5Sget_simple_extent_dims(space.id(), size.data(), nullptr) == rank, name);
  // Before memory is taken: a damaged file may say anything.
  if (size[1] != static_cast<hsize_t>(columns) ||
      size[0] > parts_->bytes / (size[1] * sizeof(T)))
    throw InputError(name + " has another shape");
  std::vector<T> values(size[0] * size[1]);
  if (!values.empty())
    check(H5Dread(dataset.id(), hdf5Type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT,
                  values.data()) >= 0,
          name + " is damaged");
  return values;
}

std::string Hdf5Reader::text(const std::string& name) const {
  const Hdf5Handle dataset = parts_->dataset(name);
  const Hdf5Handle type =
      checked(H5Dget_type(dataset.id()), H5Tclose, name + " is damaged");
  const Hdf5Handle space =
      checked(H5Dget_space(dataset.id()), H5Sclose, name + " is damaged");
  const std::size_t size = H5Tget_size(type.id());
  if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) != 0 ||
      H5Sget_simple_extent_npoints(space.id()) != 1 || size > parts_->bytes)
    throw InputError(name + " is not a text");
  std::string value(size, '\0');
  check(
      H5Dread(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, value.data()) >= 0,
      name + " is damaged");
  value.resize(std::strlen(value.c_str()));
  return value;
}

template <class T>
T Hdf5Reader::attribute(const std::string& group, const std::string& name) const {
  const std::string what = message(group, "/", name);
  const Hdf5Handle owner =
      checked(H5Gopen2(parts_->file.id(), group.c_str(), H5P_DEFAULT), H5Gclose, group);
  const Hdf5Handle attribute = checked(H5Aopen(owner.id(), name.c_str(), H5P_DEFAULT),
                                       H5Aclose, what + " is missing");
  const Hdf5Handle space =
      checked(H5Aget_space(attribute.id()), H5Sclose, what + " is damaged");
  if (H5Sget_simple_extent_npoints(space.id()) != 1)
    throw InputError(what + " is not one number");
  T value{};
  check(H5Aread(attribute.id(), hdf5Type<T>(), &value) >= 0, what + " is not a number");
  return value;
}

template std::vector<double> Hdf5Reader::array(const std::string&, long long) const;
template std::vector<int> Hdf5Reader::array(const std::string&, long long) const;
template double Hdf5Reader::attribute(const std::string&, const std::string&) const;
template int Hdf5Reader::attribute(const std::string&, const std::string&) const;
template unsigned long long Hdf5Reader::attribute(const std::string&,
                                                  const std::string&) const;

}  // namespace epafi::drivers
