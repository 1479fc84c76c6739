#include "drivers/output/Hdf5File.hpp"

#include "drivers/scene/SceneFile.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>

namespace epafi::drivers {

using bem::InputError;

namespace {

Hdf5Handle stringType(std::size_t length) {
  Hdf5Handle type = checked(H5Tcopy(H5T_C_S1), H5Tclose);
  check(H5Tset_size(type.id(), std::max<std::size_t>(length, 1)) >= 0);
  check(H5Tset_strpad(type.id(), H5T_STR_NULLPAD) >= 0);
  return type;
}

}  // namespace

Hdf5Writer::Hdf5Writer()
    : links_(checked(H5Pcreate(H5P_LINK_CREATE), H5Pclose)),
      creation_(checked(H5Pcreate(H5P_DATASET_CREATE), H5Pclose)) {
  check(H5Pset_create_intermediate_group(links_.id(), 1) >= 0);
  check(H5Pset_obj_track_times(creation_.id(), false) >= 0);
  const Hdf5Handle access = checked(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  constexpr std::size_t growth = 1 << 20;
  check(H5Pset_fapl_core(access.id(), growth, false) >= 0);
  file_ = checked(H5Fcreate("memory", H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), H5Fclose);
}

Hdf5Handle Hdf5Writer::simpleSpace(int rank, const hsize_t* size) {
  return checked(
      rank == 0 ? H5Screate(H5S_SCALAR) : H5Screate_simple(rank, size, nullptr),
      H5Sclose);
}

void Hdf5Writer::dataset(const std::string& name, hid_t type, const Hdf5Handle& space,
                         const void* data) {
  const Hdf5Handle made = checked(H5Dcreate2(file_.id(), name.c_str(), type, space.id(),
                                             links_.id(), creation_.id(), H5P_DEFAULT),
                                  H5Dclose);
  check(H5Dwrite(made.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) >= 0);
}

void Hdf5Writer::attribute(const std::string& group, const std::string& name, hid_t type,
                           const Hdf5Handle& space, const void* value) {
  const bool exists = H5Lexists(file_.id(), group.c_str(), H5P_DEFAULT) > 0;
  const Hdf5Handle owner = checked(
      exists
          ? H5Gopen2(file_.id(), group.c_str(), H5P_DEFAULT)
          : H5Gcreate2(file_.id(), group.c_str(), links_.id(), H5P_DEFAULT, H5P_DEFAULT),
      H5Gclose);
  const Hdf5Handle made = checked(
      H5Acreate2(owner.id(), name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  check(H5Awrite(made.id(), type, value) >= 0);
}

void Hdf5Writer::text(const std::string& name, const std::string& value) {
  dataset(name, stringType(value.size()).id(), simpleSpace(0), value.c_str());
}

void Hdf5Writer::attribute(const std::string& group, const std::string& name,
                           const std::string& value) {
  attribute(group, name, stringType(value.size()).id(), simpleSpace(0), value.c_str());
}

std::string Hdf5Writer::bytes() const {
  check(H5Fflush(file_.id(), H5F_SCOPE_GLOBAL) >= 0);
  const ssize_t size = H5Fget_file_image(file_.id(), nullptr, 0);
  check(size > 0);
  std::string image(static_cast<std::size_t>(size), '\0');
  check(H5Fget_file_image(file_.id(), image.data(), image.size()) == size);
  return image;
}

Hdf5Reader::Hdf5Reader(const std::string& path) {
  checkReadable(path);
  if (H5Fis_hdf5(path.c_str()) <= 0)
    throw InputError("is not an HDF5 file");
  bytes_ = std::filesystem::file_size(path);
  file_ = checked(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose,
                  "is damaged or not complete");
  within_ = checked(H5Pcreate(H5P_LINK_ACCESS), H5Pclose);
  const H5L_elink_traverse_t refuse = [](const char*, const char*, const char*,
                                         const char*, unsigned*, hid_t,
                                         void*) -> herr_t { return -1; };
  check(H5Pset_elink_cb(within_.id(), refuse, nullptr) >= 0);
}

bool Hdf5Reader::has(const std::string& name) const {
  const htri_t exists = H5Lexists(file_.id(), name.c_str(), within_.id());
  check(exists >= 0, "is damaged");
  return exists > 0;
}

Hdf5Handle Hdf5Reader::dataset(const std::string& name) const {
  Hdf5Handle found = checked(H5Oopen(file_.id(), name.c_str(), within_.id()), H5Oclose,
                             name + " is missing");
  const Hdf5Handle how = checked(H5Dget_create_plist(found.id()), H5Pclose, name);
  if (H5Pget_external_count(how.id()) != 0 || H5Pget_layout(how.id()) == H5D_VIRTUAL)
    throw InputError(name + " is in another file");
  return found;
}

Hdf5Handle Hdf5Reader::spaceOf(const std::string& name) const {
  return checked(H5Dget_space(dataset(name).id()), H5Sclose, name + " is damaged");
}

// Checks the shape before memory is allocated: a damaged file may contain any size.
hsize_t Hdf5Reader::rowsOf(const std::string& name, hsize_t columns,
                           std::size_t bytes) const {
  const Hdf5Handle space = spaceOf(name);
  const int rank = columns == 1 ? 1 : 2;
  std::array<hsize_t, 2> size = {0, 1};
  if (H5Sget_simple_extent_ndims(space.id()) != rank)
    throw InputError(name + " has another shape");
  check(H5Sget_simple_extent_dims(space.id(), size.data(), nullptr) == rank, name);
  if (size[1] != columns || size[0] > bytes_ / (columns * bytes))
    throw InputError(name + " has another shape");
  return size[0];
}

void Hdf5Reader::read(const std::string& name, hid_t type, void* values) const {
  if (values != nullptr)
    check(H5Dread(dataset(name).id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0,
          name + " is damaged");
}

std::string Hdf5Reader::text(const std::string& name) const {
  const Hdf5Handle type =
      checked(H5Dget_type(dataset(name).id()), H5Tclose, name + " is damaged");
  const std::size_t size = H5Tget_size(type.id());
  if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) != 0 ||
      H5Sget_simple_extent_npoints(spaceOf(name).id()) != 1 || size > bytes_)
    throw InputError(name + " is not a text");
  std::string value(size, '\0');
  read(name, type.id(), value.data());
  value.resize(std::strlen(value.c_str()));
  return value;
}

void Hdf5Reader::readAttribute(const std::string& group, const std::string& name,
                               hid_t type, void* value) const {
  const std::string what = bem::message(group, "/", name);
  const Hdf5Handle owner =
      checked(H5Oopen(file_.id(), group.c_str(), within_.id()), H5Oclose, group);
  const Hdf5Handle attribute = checked(H5Aopen(owner.id(), name.c_str(), H5P_DEFAULT),
                                       H5Aclose, what + " is missing");
  const Hdf5Handle space =
      checked(H5Aget_space(attribute.id()), H5Sclose, what + " is damaged");
  if (H5Sget_simple_extent_npoints(space.id()) != 1)
    throw InputError(what + " is not one number");
  check(H5Aread(attribute.id(), type, value) >= 0, what + " is not a number");
}

}  // namespace epafi::drivers
