#include "drivers/output/Hdf5Writer.hpp"

#include <algorithm>

namespace epafi::drivers {

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

}  // namespace epafi::drivers
