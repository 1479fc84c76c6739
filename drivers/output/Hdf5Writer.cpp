#include "drivers/output/Hdf5Writer.hpp"

#include "drivers/output/Hdf5Handle.hpp"

#include <algorithm>
#include <array>

namespace epafi::drivers {

namespace {

Hdf5Handle scalar() { return checked(H5Screate(H5S_SCALAR), H5Sclose); }

Hdf5Handle stringType(std::size_t length) {
  Hdf5Handle type = checked(H5Tcopy(H5T_C_S1), H5Tclose);
  check(H5Tset_size(type.id(), std::max<std::size_t>(length, 1)) >= 0);
  check(H5Tset_strpad(type.id(), H5T_STR_NULLPAD) >= 0);
  return type;
}

}  // namespace

struct Hdf5Writer::Parts {
  QuietHdf5 quiet;
  Hdf5Handle links;     ///< groups on the way to a name are made
  Hdf5Handle creation;  ///< without times the same calls make the same bytes
  Hdf5Handle file;

  Parts()
      : links(checked(H5Pcreate(H5P_LINK_CREATE), H5Pclose)),
        creation(checked(H5Pcreate(H5P_DATASET_CREATE), H5Pclose)) {
    check(H5Pset_create_intermediate_group(links.id(), 1) >= 0);
    check(H5Pset_obj_track_times(creation.id(), false) >= 0);
    const Hdf5Handle access = checked(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    constexpr std::size_t growth = 1 << 20;
    check(H5Pset_fapl_core(access.id(), growth, false) >= 0);
    file =
        checked(H5Fcreate("memory", H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), H5Fclose);
  }

  Hdf5Handle group(const std::string& name) const {
    if (H5Lexists(file.id(), name.c_str(), H5P_DEFAULT) > 0)
      return checked(H5Gopen2(file.id(), name.c_str(), H5P_DEFAULT), H5Gclose);
    return checked(
        H5Gcreate2(file.id(), name.c_str(), links.id(), H5P_DEFAULT, H5P_DEFAULT),
        H5Gclose);
  }

  void dataset(const std::string& name, hid_t type, const Hdf5Handle& space,
               const void* data) const {
    const Hdf5Handle made = checked(H5Dcreate2(file.id(), name.c_str(), type, space.id(),
                                               links.id(), creation.id(), H5P_DEFAULT),
                                    H5Dclose);
    check(H5Dwrite(made.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) >= 0);
  }

  void attribute(const std::string& owner, const std::string& name, hid_t type,
                 const Hdf5Handle& space, const void* value) const {
    const Hdf5Handle of = group(owner);
    const Hdf5Handle made = checked(
        H5Acreate2(of.id(), name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose);
    check(H5Awrite(made.id(), type, value) >= 0);
  }
};

Hdf5Writer::Hdf5Writer() : parts_(new Parts) {}

Hdf5Writer::~Hdf5Writer() = default;

template <class T>
void Hdf5Writer::array(const std::string& name, const std::vector<T>& values,
                       long long columns) {
  const auto width = static_cast<hsize_t>(columns);
  const std::array<hsize_t, 2> size = {values.size() / width, width};
  const Hdf5Handle space =
      checked(H5Screate_simple(columns == 1 ? 1 : 2, size.data(), nullptr), H5Sclose);
  const T none{};  // HDF5 wants an address
  parts_->dataset(name, hdf5Type<T>(), space, values.empty() ? &none : values.data());
}

void Hdf5Writer::text(const std::string& name, const std::string& value) {
  parts_->dataset(name, stringType(value.size()).id(), scalar(), value.c_str());
}

template <class T>
void Hdf5Writer::attribute(const std::string& group, const std::string& name,
                           const std::vector<T>& values) {
  const hsize_t size = values.size();
  const Hdf5Handle space =
      size == 1 ? scalar() : checked(H5Screate_simple(1, &size, nullptr), H5Sclose);
  parts_->attribute(group, name, hdf5Type<T>(), space, values.data());
}

void Hdf5Writer::attribute(const std::string& group, const std::string& name,
                           const std::string& value) {
  parts_->attribute(group, name, stringType(value.size()).id(), scalar(), value.c_str());
}

std::string Hdf5Writer::bytes() const {
  check(H5Fflush(parts_->file.id(), H5F_SCOPE_GLOBAL) >= 0);
  const ssize_t size = H5Fget_file_image(parts_->file.id(), nullptr, 0);
  check(size > 0);
  std::string image(static_cast<std::size_t>(size), '\0');
  check(H5Fget_file_image(parts_->file.id(), image.data(), image.size()) == size);
  return image;
}

template void Hdf5Writer::array(const std::string&, const std::vector<double>&,
                                long long);
template void Hdf5Writer::array(const std::string&, const std::vector<int>&, long long);
template void Hdf5Writer::array(const std::string&, const std::vector<long long>&,
                                long long);
template void Hdf5Writer::array(const std::string&, const std::vector<unsigned char>&,
                                long long);
template void Hdf5Writer::attribute(const std::string&, const std::string&,
                                    const std::vector<int>&);
template void Hdf5Writer::attribute(const std::string&, const std::string&,
                                    const std::vector<double>&);
template void Hdf5Writer::attribute(const std::string&, const std::string&,
                                    const std::vector<unsigned long long>&);

}  // namespace epafi::drivers
